// lutconv resample: a look on another lattice.
#include "converter/command.h"
#include "converter/look_files.h"
#include "converter/recipe_options.h"
#include "converter/report.h"
#include "converter/result.h"
#include "converter/unused.h"

#include <nlohmann/json.hpp>

#include <memory>

namespace converter {
namespace {

struct ResampleOptions {
    std::string input;
    NewLutOptions made;
};

int run_resample(const ResampleOptions& o, const Verb& verb) {
    const lutlib::Encoding encoding = o.made.results();
    const lutlib::ResamplingMethod& method = o.made.method.get();
    const auto look = read_table(o.input);
    const lutlib::Lut lut = resample(*look, o.made.sampling.sampling_of({look.get()}), method);
    tell_unused(verb, {interpolation_part(look->cube.has_value()), shaper_part(lut)});
    const std::string name = input_text(o.input);
    write_and_report({lut,
                      o.made.output,
                      o.made.output,
                      name,
                      method.transform_of(*look),
                      encoding,
                      {},
                      lutlib::breaks_of(*look)},
                     o.made.json, {{"input", o.input}});
    return ok;
}

} // namespace

Run declare_resample(Verb& verb) {
    const auto o = std::make_shared<ResampleOptions>();
    verb.add_option("LUT", o->input, "a LUT or recipe file, or - for standard input").required();
    o->made.declare(verb);
    verb.footer("Without --size, --domain or --shaper the look's own are kept.");
    return [o, &verb] { return run_resample(*o, verb); };
}

} // namespace converter
