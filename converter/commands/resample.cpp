// lutconv resample: a look on another lattice.
#include "converter/command.h"
#include "converter/options.h"
#include "converter/recipe_options.h"
#include "converter/result.h"
#include "lutlib/io/file.h"

#include <nlohmann/json.hpp>

#include <memory>

namespace converter {
namespace {

struct Options {
    std::string input, output, encoding = "srgb";
    SamplingOptions sampling;
    MethodOption method;
    bool json = false;
};

int run(const Options& o) {
    const lutlib::Encoding& encoding = encoding_of(o.encoding, "--encoding");
    const lutlib::ResamplingMethod& method = o.method.get();
    const lutlib::Lut look = read_look(o.input);
    const lutlib::Lut lut = resample(look, o.sampling.sampling(), method);
    write_and_report(
        {lut, o.output, lutlib::io::input_name(o.input), transform_of(look, method), encoding, {}},
        o.json, {{"input", o.input}});
    return ok;
}

} // namespace

Run declare_resample(CLI::App& app) {
    const auto o = std::make_shared<Options>();
    app.add_option("LUT", o->input, "a LUT or recipe file, or - for standard input")->required();
    app.add_option("-o,--output", o->output, "the new LUT, or - for standard output")->required();
    o->sampling.declare(app, false);
    o->method.declare(app);
    app.add_option("--encoding", o->encoding,
                   "what the results are, for colour differences: " + encoding_names())
        ->capture_default_str();
    app.add_flag("--json", o->json, "print the figures as JSON");
    app.footer("Without --size, --domain or --shaper the look's own are kept.");
    return [o] { return run(*o); };
}

} // namespace converter
