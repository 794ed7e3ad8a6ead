// lutconv info: what is in a LUT.
#include "converter/command.h"
#include "converter/look_files.h"
#include "converter/picture_facts.h"
#include "converter/report.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/file.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <optional>

namespace converter {
namespace {

using lutlib::Rgb;

struct Extent {
    Rgb low, high;
    std::size_t outside = 0; ///< values outside 0..1
};

Extent extent_of(const std::vector<Rgb>& values) {
    Extent out{values.front(), values.front(), 0};
    for (const Rgb& value : values) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.low[c] = std::min(out.low[c], value[c]);
            out.high[c] = std::max(out.high[c], value[c]);
            out.outside += value[c] < 0 || value[c] > 1;
        }
    }
    return out;
}

// How far the look moves the colours of its own domain's lattice.
lutlib::ErrorStats distance_from_identity(const lutlib::Lut& lut) {
    std::vector<double> moves;
    for (const Rgb& in : lutlib::identity_cube(17, lut.domain()).nodes) {
        const lutlib::RgbD d = evaluate_exact(lut, to_double(in)) - to_double(in);
        moves.push_back(largest_magnitude(d));
    }
    return lutlib::error_stats(std::move(moves));
}

nlohmann::ordered_json table_json(int size, const lutlib::Domain& d,
                                  const std::vector<Rgb>& values) {
    const Extent e = extent_of(values);
    return {{"size", size},
            {"domain_min", {d.min.r, d.min.g, d.min.b}},
            {"domain_max", {d.max.r, d.max.g, d.max.b}},
            {"lowest", {e.low.r, e.low.g, e.low.b}},
            {"highest", {e.high.r, e.high.g, e.high.b}},
            {"values_outside_0_1", e.outside}};
}

std::string table_text(const char* what, int size, const lutlib::Domain& d,
                       const std::vector<Rgb>& values) {
    const Extent e = extent_of(values);
    return fmt::format("  {}: {} {}, input {}, output {:.6g}..{:.6g}, {:.6g}..{:.6g}, "
                       "{:.6g}..{:.6g}{}\n",
                       what, size, what[0] == 's' ? "entries" : "nodes per axis",
                       lutlib::io::domain_text(d), e.low.r, e.high.r, e.low.g, e.high.g, e.low.b,
                       e.high.b,
                       e.outside ? fmt::format(", {} values outside 0..1", e.outside) : "");
}

nlohmann::ordered_json encodings_json(const lutlib::LookEncodings& known) {
    const lutlib::EncodingNames names = names_of(known);
    const auto name = [](const std::string& text) {
        return text.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(text);
    };
    return {{"input", name(names.input)}, {"output", name(names.output)}};
}

std::string known_encodings(const lutlib::LookEncodings& known) {
    const lutlib::EncodingNames names = names_of(known);
    const auto name = [](const std::string& text) {
        return text.empty() ? std::string("unknown") : text;
    };
    return fmt::format("  encodings: input {}, output {}\n", name(names.input), name(names.output));
}

int run_info(const std::string& path, bool json) {
    const std::string bytes = lutlib::io::read_file(path);
    const lutlib::io::Look look = open_look(bytes, path);
    const std::optional<PictureFacts> picture = picture_facts(bytes, look);
    const auto table = table_of(look);
    const lutlib::Lut& lut = *table;
    const lutlib::ErrorStats moves = distance_from_identity(lut);
    if (json) {
        nlohmann::ordered_json out{{"file", path},
                                   {"format", look.kind().format},
                                   {"title", lut.title},
                                   {"encodings", encodings_json(look.encodings())},
                                   {"comments", lut.comments},
                                   {"keywords", lut.keywords},
                                   {"notes", lut.notes}};
        if (lut.shaper) {
            out["shaper"] = table_json(lut.shaper->size(), lut.shaper->domain, lut.shaper->entries);
        }
        if (lut.cube) {
            out["cube"] = table_json(lut.cube->size, lut.cube->domain, lut.cube->nodes);
        }
        if (lut.interpolation) {
            out["interpolation"] = name_of(*lut.interpolation);
        }
        if (picture) {
            out["picture"] = picture->json;
        }
        out["distance_from_identity"] = to_json(moves);
        print(out, "");
        return ok;
    }
    std::string out = input_text(path) + "\n";
    if (!lut.title.empty()) {
        out += "  title: " + one_line(lut.title) + "\n";
    }
    out += known_encodings(look.encodings());
    if (picture) {
        out += picture->text;
    }
    if (lut.shaper) {
        out += table_text("shaper", lut.shaper->size(), lut.shaper->domain, lut.shaper->entries);
    }
    if (lut.cube) {
        out += table_text("cube", lut.cube->size, lut.cube->domain, lut.cube->nodes);
    }
    if (lut.interpolation) {
        out += fmt::format("  it asks for {} interpolation\n", name_of(*lut.interpolation));
    }
    out += "  distance from the identity: " + to_text(moves) + "\n";
    for (const std::string& comment : lut.comments) {
        out += "  # " + one_line(comment) + "\n";
    }
    print(out, "");
    return ok;
}

} // namespace

Run declare_info(Verb& verb) {
    const auto path = std::make_shared<std::string>();
    const auto json = std::make_shared<bool>(false);
    verb.add_option("LUT", *path, "a LUT file, or - for standard input").required();
    verb.add_flag("--json", *json, "print as JSON");
    return [path, json] { return run_info(*path, *json); };
}

} // namespace converter
