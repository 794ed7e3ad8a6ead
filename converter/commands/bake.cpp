// lutconv bake: a look becomes an engine's LUT picture.
#include "lutlib/bake.h"
#include "converter/command.h"
#include "converter/explain.h"
#include "converter/options.h"
#include "converter/report.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/samples.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <optional>

namespace converter {
namespace {

using lutlib::Bake;
using lutlib::Domain;
using lutlib::LookupError;

struct Options {
    std::string input, output;
    EngineOption engine;
    int size = 0, bits = 0;
    InterpolationOption interpolation;
    bool explain = false, json = false;
};

// A few thousand colours are enough to say how large the error is; `verify` looks at all.
constexpr lutlib::SampleCounts quick_samples{.neutral = 256, .random = 2048, .lattice = false};

// The share of the look's input domain that 0..1 reaches, in the channel that loses most.
double reachable_share(const Domain& domain) {
    double share = 1;
    for (std::size_t c = 0; c < 3; ++c) {
        const double low = std::max(0.0, static_cast<double>(domain.min[c]));
        const double high = std::min(1.0, static_cast<double>(domain.max[c]));
        const double width =
            static_cast<double>(domain.max[c]) - static_cast<double>(domain.min[c]);
        share = std::min(share, std::max(0.0, high - low) / width);
    }
    return share;
}

// The share of the engine's inputs 0..1 that lie outside the look's domain and are clamped to it.
double clamped_share(const Domain& domain) {
    double share = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const double low = std::clamp(static_cast<double>(domain.min[c]), 0.0, 1.0);
        const double high = std::clamp(static_cast<double>(domain.max[c]), 0.0, 1.0);
        share = std::max(share, 1 - (high - low));
    }
    return share;
}

LookupError measure(const Bake& bake, const lutlib::ExactLook& look) {
    const std::vector<lutlib::Rgb> inputs = lutlib::sample_colors(bake.size, quick_samples);
    std::vector<lutlib::Rgb> expected;
    expected.reserve(inputs.size());
    for (const lutlib::Rgb& in : inputs) {
        expected.push_back(to_float(look(to_double(in))));
    }
    return lookup_error(*bake.engine, decoded(bake.picture), bake.size, inputs, expected);
}

std::string as_text(const Options& o, const Bake& bake, const Domain& domain,
                    const LookupError& error) {
    const lutlib::Engine& engine = *bake.engine;
    std::string out = fmt::format(
        "{} -> {}\n  {}x{} pixels, {} nodes a side, {} bits, layout {}, {} sRGB tag: {}\n",
        lutlib::io::input_name(o.input), lutlib::io::output_name(o.output), bake.picture.width,
        bake.picture.height, bake.size, bake.picture.bits, engine.layout,
        engine.srgb_tag == lutlib::SrgbTag::present ? "with" : "no", engine.label);
    out += fmt::format("  input: {}\n  import: {}\n", engine.input, engine.import);
    const auto values = static_cast<std::size_t>(bake.size) * static_cast<std::size_t>(bake.size) *
                        static_cast<std::size_t>(bake.size) * 3;
    if (bake.loss.clamped_values > 0) {
        out += fmt::format("  lost: {} of {} values lie outside 0..1 and were clamped, by {:.4g} "
                           "at most\n",
                           bake.loss.clamped_values, values, bake.loss.most_clamped);
    }
    if (reachable_share(domain) < 1) {
        out += fmt::format("  lost: the engine reaches {:.3g} % of the look's input domain "
                           "({}); it feeds 0..1\n",
                           100 * reachable_share(domain), domain_text(domain));
    }
    if (clamped_share(domain) > 0) {
        out += fmt::format("  lost: {:.3g} % of the engine's inputs lie outside the look's domain "
                           "({}) and are clamped to it\n",
                           100 * clamped_share(domain), domain_text(domain));
    }
    out += fmt::format("  lost: rounding to {} bits, max {:.4g}, mean {:.4g}\n", bake.picture.bits,
                       bake.loss.max_rounding, bake.loss.mean_rounding);
    out += fmt::format("  error of {}'s lookup against the look, {} colours: {}\n", engine.name,
                       error.absolute.count, to_text(error.absolute));
    out += fmt::format("  as dE2000: {}\n", to_text(error.delta_e));
    return out;
}

nlohmann::ordered_json as_json(const Options& o, const Bake& bake, const Domain& domain,
                               const LookupError& error) {
    return {{"input", o.input},
            {"output", o.output},
            {"engine", bake.engine->name},
            {"layout", bake.engine->layout},
            {"width", bake.picture.width},
            {"height", bake.picture.height},
            {"size", bake.size},
            {"bits", bake.picture.bits},
            {"srgb_tag", bake.engine->srgb_tag == lutlib::SrgbTag::present},
            {"loss",
             {{"clamped_values", bake.loss.clamped_values},
              {"most_clamped", bake.loss.most_clamped},
              {"reachable_domain_share", reachable_share(domain)},
              {"clamped_input_share", clamped_share(domain)},
              {"max_rounding", bake.loss.max_rounding},
              {"mean_rounding", bake.loss.mean_rounding}}},
            {"absolute_error", to_json(error.absolute)},
            {"delta_e_2000", to_json(error.delta_e)}};
}

int run(const Options& o) {
    if (o.explain && o.input == lutlib::io::standard_stream) {
        throw lutlib::UsageError("--explain needs a file, not standard input");
    }
    const lutlib::Engine& engine = o.engine.get();
    const int size = o.size ? o.size : engine.default_size;
    const int bits = o.bits ? o.bits : engine.default_bits;
    check_contract(engine, size, bits);
    const Look look = open_look(o.input, o.interpolation.get());
    const Bake result = bake(look.exact, engine, size, bits);
    lutlib::io::write_file(
        o.output, lutlib::io::picture_bytes(result, {lutlib::io::input_name(o.input), look.title,
                                                     name_of(o.interpolation.get())}));
    const LookupError error = measure(result, look.exact);
    // What changes less than half a code is not seen in the picture.
    const double half_code = 0.5 / result.picture.maximum();
    std::optional<Explanation> explanation;
    if (o.explain) {
        explanation = explain(read_look(o.input), half_code);
        explanation->kept = "the engine reads a lattice of this size whatever the look is";
    }
    if (o.json) {
        nlohmann::ordered_json json = as_json(o, result, look.domain, error);
        if (explanation) {
            json["explanation"] = to_json(*explanation);
        }
        print(json, o.output);
    } else {
        print(as_text(o, result, look.domain, error) + (explanation ? to_text(*explanation) : ""),
              o.output);
    }
    return ok;
}

} // namespace

Run declare_bake(CLI::App& app) {
    const auto o = std::make_shared<Options>();
    app.add_option("LUT", o->input, "a LUT or recipe file, or - for standard input")->required();
    app.add_option("-o,--output", o->output, "the PNG, or - for standard output")->required();
    o->engine.declare(app, "piccolo");
    app.add_option("--size", o->size, "nodes a side (default: the engine's)");
    app.add_option("--bits", o->bits, "8 or 16 bits a sample (default: the engine's)");
    o->interpolation.declare(app, "how the look is read between its own nodes");
    app.add_flag("--explain", o->explain, "say what of the look no picture would need");
    app.add_flag("--json", o->json, "print the figures as JSON");
    return [o] { return run(*o); };
}

} // namespace converter
