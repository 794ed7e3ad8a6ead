#include "converter/result.h"

#include "converter/look_files.h"
#include "converter/report.h"
#include "lutlib/io/bake_report.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace converter {
namespace {

nlohmann::ordered_json color_json(lutlib::RgbD c) {
    return {c.r, c.g, c.b};
}

nlohmann::ordered_json worst_json(const lutlib::WorstColor& worst) {
    return {{"in", color_json(to_double(worst.in))},
            {"a", color_json(worst.a)},
            {"b", color_json(worst.b)}};
}

std::string worst_text(const lutlib::WorstColor& worst) {
    return fmt::format("{} -> {} and {}", color_text(to_double(worst.in)), color_text(worst.a),
                       color_text(worst.b));
}

std::string tables_text(const lutlib::Lut& lut) {
    if (!lut.cube) {
        return fmt::format("a 1D table of {} entries, input {}: the channels do not mix",
                           lut.shaper->size(), lutlib::io::domain_text(lut.domain()));
    }
    std::string out = fmt::format("{} nodes per axis, input {}", lut.cube->size,
                                  lutlib::io::domain_text(lut.domain()));
    if (lut.shaper) {
        out += fmt::format(", a 1D table of {} before them", lut.shaper->size());
    }
    return out;
}

} // namespace

std::string color_text(lutlib::RgbD c) {
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", c.r, c.g, c.b);
}

nlohmann::ordered_json to_json(const lutlib::Difference& d) {
    return {{"absolute", to_json(d.absolute)},
            {"delta_e_2000", to_json(d.delta_e_2000)},
            {"delta_e_itp", to_json(d.delta_e_itp)},
            {"psnr", d.psnr},
            {"worst", worst_json(d.worst)},
            {"worst_to_eye", worst_json(d.worst_to_eye)},
            {"worst_to_itp", worst_json(d.worst_to_itp)}};
}

std::string to_text(const lutlib::Difference& d, const std::string& indent) {
    return fmt::format("{0}code values: {1}\n{0}dE2000: {2}\n{0}dE-ITP: {3}\n{0}PSNR: {4:.4g} dB\n"
                       "{0}worst: {5}\n{0}worst to the eye: {6}\n",
                       indent, to_text(d.absolute), to_text(d.delta_e_2000), to_text(d.delta_e_itp),
                       d.psnr, worst_text(d.worst), worst_text(d.worst_to_eye));
}

nlohmann::ordered_json to_json(const std::vector<lutlib::Loss>& losses) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const lutlib::Loss& loss : losses) {
        out.push_back({{"what", loss.what}, {"figure", loss.figure}, {"unit", loss.unit}});
    }
    return out;
}

std::string to_text(const std::vector<lutlib::Loss>& losses) {
    std::string out;
    for (const lutlib::Loss& loss : losses) {
        out += "  lost: " + loss_text(loss) + '\n';
    }
    return out;
}

std::string figures_of_file(const std::vector<lutlib::Loss>& losses,
                            const lutlib::Difference& error) {
    return fmt::format(
        "  error of the {} against that; p99 and mean over {} colours spread evenly\n{}",
        losses.empty() ? "LUT" : "file, as it is read,", error.absolute.count,
        to_text(error, "    "));
}

void write_and_report(const Result& result, bool json, nlohmann::ordered_json extra) {
    const WrittenLook written = write_look(result.lut, result.output, result.others);
    const lutlib::Difference error = measure(
        result.exact, written.read,
        error_samples(result.lut.domain(), united(result.breaks, written.breaks)), result.encoding);
    const lutlib::Lut& lut = *written.lut;
    if (json) {
        nlohmann::ordered_json out{{"output", result.output},
                                   {"size", lut.cube ? lut.cube->size : 0},
                                   {"shaper_size", lut.shaper ? lut.shaper->size() : 0}};
        out.update(extra);
        out["losses"] = to_json(written.losses);
        out["error"] = to_json(error);
        print(out, result.shown);
        return;
    }
    std::string text = fmt::format("{} <- {}\n  {}\n", output_text(result.output), result.made_of,
                                   tables_text(lut));
    for (const std::string& note : result.notes) {
        text += "  " + note + "\n";
    }
    text += to_text(written.losses) + figures_of_file(written.losses, error);
    print(text, result.shown);
}

} // namespace converter
