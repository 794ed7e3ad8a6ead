// lutconv bake: a look becomes an engine's LUT picture.
#include "lutlib/bake.h"
#include "converter/command.h"
#include "converter/options.h"
#include "converter/report.h"
#include "lutlib/error.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/file.h"
#include "lutlib/io/lut_picture.h"

#include <nlohmann/json.hpp>

#include <memory>

namespace converter {
namespace {

using lutlib::Bake;
using lutlib::Domain;
using lutlib::LookupError;
using lutlib::io::bake_report;
using lutlib::io::clamped_share;
using lutlib::io::measure_bake;
using lutlib::io::reachable_share;

struct Options {
    std::string input, output;
    EngineOption engine;
    int size = 0, bits = 0;
    InterpolationOption interpolation;
    bool json = false;
};

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
    const lutlib::Engine& engine = o.engine.get();
    const int size = o.size ? o.size : engine.default_size;
    const int bits = o.bits ? o.bits : engine.default_bits;
    check_contract(engine, size, bits);
    const Look look = open_look(o.input, o.interpolation.get());
    const Bake result = bake(look.exact, engine, size, bits);
    lutlib::io::write_file(
        o.output, lutlib::io::picture_bytes(result, {lutlib::io::input_name(o.input), look.title,
                                                     name_of(o.interpolation.get())}));
    const LookupError error = measure_bake(result, look.exact);
    o.json ? print(as_json(o, result, look.domain, error), o.output)
           : print(bake_report(lutlib::io::input_name(o.input), lutlib::io::output_name(o.output),
                               result, look.domain, error),
                   o.output);
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
    app.add_flag("--json", o->json, "print the figures as JSON");
    return [o] { return run(*o); };
}

} // namespace converter
