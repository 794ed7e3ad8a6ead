// lutconv verify: proves a LUT picture right against OpenColorIO, or says what is wrong with it.
#include "converter/command.h"
#include "converter/config_options.h"
#include "converter/judge.h"
#include "converter/many_looks.h"
#include "converter/options.h"
#include "converter/placing.h"
#include "converter/report.h"
#include "converter/unused.h"
#include "converter/verify_result.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <optional>

namespace converter {
namespace {

namespace io = lutlib::io;

constexpr int most_samples = 10'000'000;

struct VerifyOptions {
    std::vector<std::string> pictures;
    std::string against;
    std::string picture; ///< of one verdict
    EngineOption engine;
    InterpolationOption interpolation;
    PlacingOptions placing;
    ConfigOptions config;
    int row = -1;
    int samples = static_cast<int>(lutlib::SampleLimits{}.even);
    double reference_white = lutlib::reference_white_nits;
    bool json = false;
};

int verify_one(const VerifyOptions& o, const Verb& verb) {
    const Subject s = open_subject(o.picture, o.engine.given() ? &o.engine.get() : nullptr,
                                   o.row < 0 ? std::nullopt : std::optional(o.row));
    const Verdict v = judge(s, {.picture = o.picture,
                                .against = o.against,
                                .interpolation = o.interpolation.get(),
                                .look = o.placing.look(),
                                .convert = o.placing.convert(),
                                .adaptation = &o.placing.adaptation(),
                                .config = &o.config,
                                .samples = static_cast<std::size_t>(o.samples),
                                .reference_white = o.reference_white});
    tell_unused(verb, {interpolation_part(v.lattice), adaptation_part(v.place.applied()),
                       no_convert_part(v.place)});
    o.json ? print(to_json(s, v), "") : print(to_text(s, v), "");
    return v.passed ? ok : verification_failed;
}

int run_verify(const VerifyOptions& o, const Verb& verb) {
    if (o.samples < 1 || o.samples > most_samples) {
        throw lutlib::UsageError(fmt::format("--samples must be 1 to {}", most_samples));
    }
    o.config.check();
    o.config.require_alone(o.placing.given());
    const std::vector<LookRoute> routes = routes_of_looks(o.pictures, "");
    if (o.against == io::standard_stream &&
        (routes.size() > 1 || routes.front().route.from.path == io::standard_stream)) {
        throw lutlib::UsageError("the look can come from standard input for one picture alone, "
                                 "which then cannot come from there");
    }
    return run_over(routes, [&](const LookRoute& route) {
        VerifyOptions one = o;
        one.picture = route.route.from.path;
        return verify_one(one, verb);
    });
}
} // namespace

Run declare_verify(Verb& verb) {
    const auto o = std::make_shared<VerifyOptions>();
    verb.add_option("PICTURES", o->pictures,
                    "the LUT pictures, or - for standard input; folders of them")
        .required();
    verb.add_option("--against", o->against,
                    "the look or recipe that it should have been baked from")
        .required();
    o->engine.declare(verb, "");
    o->interpolation.declare(verb, "how the look was read between its nodes (default: as recorded "
                                   "in the picture)");
    o->placing.declare(verb);
    verb.add_option("--row", o->row,
                    "which of the lattices stacked in the picture, from the top and 0 (ReShade's "
                    "multi-LUT files)")
        .takes(Takes::count);
    verb.add_option("--samples", o->samples,
                    "colours spread evenly, for the mean and the percentiles of the lookup's error")
        .capture_default_str();
    declare_reference_white(verb, o->reference_white);
    verb.add_flag("--json", o->json, "print the results as JSON");
    o->config.declare(verb);
    return [o, &verb] { return run_verify(*o, verb); };
}

} // namespace converter
