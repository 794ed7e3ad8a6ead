// lutconv bake: a look becomes an engine's LUT picture.
#include "lutlib/bake/bake.h"
#include "converter/bake_result.h"
#include "converter/command.h"
#include "converter/config_options.h"
#include "converter/look_files.h"
#include "converter/many_looks.h"
#include "converter/options.h"
#include "converter/placing.h"
#include "converter/replaceable.h"
#include "converter/report.h"
#include "converter/unused.h"
#include "converter/usage.h"
#include "converter/watch.h"
#include "lutlib/bake/budget.h"
#include "lutlib/bake/stack.h"
#include "lutlib/error.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/file.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/resample/resample.h"
#include "lutlib/resample/sample_lut.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

namespace converter {
namespace {

using lutlib::Bake;
using lutlib::BudgetBake;
using lutlib::Domain;
using lutlib::FilledBake;

struct BakeOptions {
    std::vector<std::string> inputs;
    std::string output_template;
    std::string input, output; ///< of one bake
    const lutlib::Engine* engine = nullptr;
    EngineOption engines;
    int size = 0, bits = 0;
    InterpolationOption interpolation;
    PlacingOptions placing;
    ConfigOptions config;
    WatchOption watch;
    double max_delta_e = 0, max_delta_itp = 0;
    double reference_white = lutlib::reference_white_nits;
    bool stack = false, fit = false, measure = false, no_measure = false, explain = false,
         json = false;
};

std::optional<Promise> promise_of(const BakeOptions& o) {
    if (o.max_delta_itp > 0) {
        return Promise{"--max-delta-itp", "dE-ITP", lutlib::Metric::delta_e_itp, o.max_delta_itp};
    }
    if (o.max_delta_e > 0) {
        return Promise{"--max-delta-e", "dE2000", lutlib::Metric::delta_e_2000, o.max_delta_e};
    }
    return std::nullopt;
}

// Measuring takes some twenty times as long as the bake, so only who wants figures waits for them.
bool is_measured(const BakeOptions& o) {
    return o.measure || o.fit || promise_of(o) || (o.json && !o.no_measure);
}

FilledBake fill(const BakeOptions& o, const lutlib::Transform& look, const lutlib::Engine& engine,
                const lutlib::FitView& view) {
    const int size = o.size ? o.size : engine.default_size;
    const int bits = o.bits ? o.bits : engine.default_bits;
    check_contract(engine, size, bits);
    return o.fit ? bake_fitted(look, engine, size, bits, view)
                 : FilledBake{.bake = bake(look, engine, size, bits)};
}

std::optional<int> if_given(int value) {
    return value ? std::optional(value) : std::nullopt;
}

// The look as the engine is to see it.
lutlib::Lut table_to_explain(const lutlib::io::Look& look, const lutlib::Transform& placed,
                             bool converted) {
    if (!converted) {
        return *look.table().lut;
    }
    lutlib::Lut out;
    out.cube = lutlib::sample_cube(placed, {}, lutlib::usual_cube_size);
    return out;
}

lutlib::io::Look opened_look(const BakeOptions& o) {
    return o.config.given() && o.input == identity_word
               ? identity_look()
               : open_look(o.input,
                           {.interpolation = o.interpolation.get(), .encodings = o.placing.look()});
}

// A config says what is converted, of spaces that have no encoding here.
lutlib::LookPlace place_of(const BakeOptions& o, const lutlib::Engine& engine,
                           const lutlib::io::Look& look) {
    if (o.config.given()) {
        return {};
    }
    lutlib::LookPlace out = lutlib::io::place_in(engine, look.encodings(), o.placing.convert());
    out.adaptation = &o.placing.adaptation();
    return out;
}

BakeResult make_result(const BakeOptions& o, const Verb& verb) {
    const lutlib::Engine& engine = *o.engine;
    const lutlib::io::Look look = opened_look(o);
    BakeResult out;
    out.input = o.input;
    out.output = o.output;
    out.config = o.config.given() ? o.config.text() : "";
    out.promise = promise_of(o);
    out.fit_wanted = o.fit;
    out.place = place_of(o, engine, look);
    const lutlib::Placement placement = out.place.applied();
    const lutlib::Transform exact = o.config.before(placement.around(look.exact()));
    tell_unused(verb, {interpolation_part(has_lattice(look)),
                       adaptation_part(placement),
                       no_convert_part(out.place),
                       {"--reference-white", is_measured(o), "nothing is measured"}});
    out.title = look.title();
    out.interpolation = look.interpolation();
    out.domain = o.config.given() ? Domain{} : look.domain();
    out.viewing = lutlib::io::viewing_of(out.place, o.reference_white);
    const lutlib::Breaks breaks =
        o.config.given() ? lutlib::no_breaks() : lutlib::io::placed(look.breaks(), placement);
    if (const std::optional<Promise>& promise = out.promise) {
        out.budgeted = bake_within(
            exact, engine,
            {.most = promise->most,
             .size = if_given(o.size),
             .bits = if_given(o.bits),
             .fit = true,
             .metric = promise->metric,
             .viewing = out.viewing,
             .breaks = breaks,
             .nodes = placement.before || o.config.given() ? std::nullopt : look.nodes()});
        out.filled = out.budgeted->filled;
        out.error = out.budgeted->error;
    } else {
        out.filled = fill(o, exact, engine, {breaks, out.viewing});
        const Bake& bake = out.filled.bake;
        if (out.filled.result) {
            out.error = out.filled.result;
        } else if (is_measured(o)) {
            out.error = measure_lookup(bake.picture, engine, bake.size, exact, breaks, out.viewing);
        }
    }
    if (o.explain) {
        // What changes less than half a code is not seen in the picture.
        out.explanation =
            explain(table_to_explain(look, exact, placement.converts() || o.config.given()),
                    0.5 / out.filled.bake.picture.depth.maximum());
        out.explanation->kept =
            "nothing is left out, because the engine needs a lattice of this size";
    }
    return out;
}

std::string made_of(const BakeOptions& o) {
    return lutlib::io::input_name(o.input) + (o.config.given() ? ", " + o.config.text() : "");
}

void write_picture(const BakeOptions& o, const BakeResult& result) {
    lutlib::io::write_file(
        o.output, lutlib::io::picture_bytes(result.filled.bake,
                                            {.source = made_of(o),
                                             .title = result.title,
                                             .interpolation = name_of(result.interpolation),
                                             .fitted = result.filled.fitted,
                                             .encodings = names_of(result.place.shown()),
                                             .look = names_of(result.place.look)}));
}

void say_that_nothing_was_written(const BakeOptions& o, const BudgetBake& found) {
    print(fmt::format("  nothing was written; raise {} above {:.4g}{}\n", promise_of(o)->option,
                      found.largest, o.size || o.bits ? ", or leave --size and --bits open" : ""),
          std::string(lutlib::io::standard_stream));
}

int bake_one(const BakeOptions& o, const Verb& verb) {
    require_png_name(o.output, "bake");
    const BakeResult result = make_result(o, verb);
    if (result.is_kept()) {
        write_picture(o, result);
    }
    o.json ? print(to_json(result), o.output) : print(to_text(result), o.output);
    if (!result.is_kept()) {
        say_that_nothing_was_written(o, *result.budgeted);
        return verification_failed;
    }
    return ok;
}

// The one that was named, else the first that reads several lattices in one picture.
const lutlib::Engine& stacking_engine(const BakeOptions& o, const Verb& verb) {
    const std::vector<const lutlib::Engine*> named = o.engines.all();
    if (!verb.given("--engine")) {
        const auto all = lutlib::engines();
        return *std::find_if(all.begin(), all.end(),
                             [](const lutlib::Engine& engine) { return reads_stacks(engine); });
    }
    if (named.size() > 1) {
        throw lutlib::UsageError("--stack makes one picture, for one engine");
    }
    return *named.front();
}

int bake_stacked(const BakeOptions& o, const Verb& verb) {
    if (const std::optional<Promise> promise = promise_of(o)) {
        throw lutlib::UsageError(fmt::format("--stack excludes {}", promise->option));
    }
    require_png_name(o.output_template, "bake");
    require_replaceable(o.output_template, o.inputs);
    const lutlib::Engine& engine = stacking_engine(o, verb);
    std::vector<Bake> rows;
    std::string sources, titles, text;
    nlohmann::ordered_json json{{"output", o.output_template},
                                {"engine", engine.name},
                                {"rows", nlohmann::ordered_json::array()}};
    std::vector<BakeResult> results;
    for (const LookRoute& route : routes_of_looks(o.inputs, "", std::array{&engine})) {
        BakeOptions one = o;
        one.input = route.route.from.path;
        one.output = o.output_template;
        one.engine = &engine;
        results.push_back(make_result(one, verb));
        const BakeResult& result = results.back();
        const char* const between = rows.empty() ? "" : ", ";
        sources += between + made_of(one);
        titles += between + result.title;
        text += fmt::format("row {}: ", rows.size()) + to_text(result);
        json["rows"].push_back(to_json(result));
        rows.push_back(result.filled.bake);
    }
    const Bake all = lutlib::stacked(rows);
    const BakeResult& first = results.front();
    lutlib::io::write_file(
        o.output_template,
        lutlib::io::picture_bytes(all, {.source = sources,
                                        .title = titles,
                                        .interpolation = name_of(first.interpolation),
                                        .fitted = o.fit,
                                        .encodings = names_of(first.place.shown()),
                                        .look = names_of(first.place.look)}));
    text += fmt::format("  {0} lattices below each other, {1}x{2} pixels: set {3} to {0} tables of "
                        "{4} nodes; --row picks one of them in other verbs\n",
                        rows.size(), all.picture.width, all.picture.height, engine.label, all.size);
    o.json ? print(json, o.output_template) : print(text, o.output_template);
    return ok;
}

std::vector<LookRoute> bake_routes(const BakeOptions& o) {
    const std::vector<const lutlib::Engine*> engines = o.engines.all();
    return routes_of_looks(o.inputs, o.output_template, engines);
}

int bake_route(const BakeOptions& o, const LookRoute& route, const Verb& verb) {
    BakeOptions one = o;
    one.input = route.route.from.path;
    one.output = route.route.to;
    one.engine = route.engine;
    return bake_one(one, verb);
}

std::vector<WatchedWork> watched_bakes(const BakeOptions& o, const Verb& verb) {
    std::vector<WatchedWork> out;
    if (o.stack) {
        out.push_back({o.inputs, o.output_template, [&o, &verb] { return bake_stacked(o, verb); }});
    } else {
        for (const LookRoute& route : bake_routes(o)) {
            out.push_back({{route.route.from.path}, route.route.to, [&o, &verb, route] {
                               return bake_route(o, route, verb);
                           }});
        }
    }
    for (WatchedWork& work : out) {
        if (o.config.given()) {
            work.from.push_back(o.config.file());
        }
    }
    return out;
}

int run_bake(const BakeOptions& o, const Verb& verb) {
    o.config.check();
    o.config.require_alone(o.placing.given());
    if (o.no_measure && (o.fit || promise_of(o))) {
        throw lutlib::UsageError("a fit and a promise are measured; leave --no-measure out");
    }
    if (o.watch.given()) {
        o.watch.run(o.inputs, o.output_template, [&] { return watched_bakes(o, verb); });
    }
    if (o.stack) {
        return bake_stacked(o, verb);
    }
    return run_over(bake_routes(o),
                    [&](const LookRoute& route) { return bake_route(o, route, verb); });
}

std::string stacking_engines() {
    std::string out;
    for (const lutlib::Engine& engine : lutlib::engines()) {
        out += reads_stacks(engine) ? (out.empty() ? "" : ", ") + std::string(engine.name) : "";
    }
    return out;
}

} // namespace

Run declare_bake(Verb& verb) {
    const auto o = std::make_shared<BakeOptions>();
    verb.add_option("LUTS", o->inputs,
                    "LUT or recipe files, or - for standard input; folders of them; with "
                    "--ocio-config also the word identity")
        .required();
    verb.add_output("-o,--output", o->output_template,
                    "the PNG, or - for standard output; of several bakes a name with {name} and "
                    "{engine} in it",
                    OutputName::is_template)
        .required();
    o->engines.declare(verb, "piccolo");
    verb.add_option("--size", o->size, "lattice size: nodes per axis (default: the engine's)")
        .takes(Takes::cube_size);
    verb.add_option("--bits", o->bits, "bits per sample: 8 or 16 (default: the engine's)")
        .takes(Takes::picture_bits);
    o->interpolation.declare(verb, "how to interpolate the look between its own nodes");
    o->placing.declare(verb);
    verb.add_flag("--stack", o->stack,
                  "put all looks below each other into one picture, in the order given, for "
                  "engines that read several lattices: " +
                      stacking_engines());
    verb.add_flag("--fit", o->fit,
                  fmt::format("choose the nodes so that the engine's lookup comes nearest to the "
                              "look between them; keeps point samples where that does not help, "
                              "and beyond {} nodes per axis",
                              lutlib::largest_fitted_size));
    verb.add_option(
            "--max-delta-e", o->max_delta_e,
            "take the smallest combination of size, bits and fit that the engine accepts and "
            "that stays within this dE2000; writes nothing, with exit code 1, when none does")
        .takes(Takes::above_zero);
    verb.add_option(
            "--max-delta-itp", o->max_delta_itp,
            "the same of dE-ITP (ITU-R BT.2124), for HDR outputs, where dE2000 means little")
        .takes(Takes::above_zero)
        .excludes({"--max-delta-e"});
    declare_reference_white(verb, o->reference_white);
    verb.add_flag(
        "--measure", o->measure,
        "say how far the engine's lookup is from the look: p99 and mean, and the largest "
        "of all colours, in code values and dE2000; a tenth of a second where the bake takes a "
        "hundredth. With --json, --fit and --max-delta-e always");
    verb.add_flag("--no-measure", o->no_measure, "leave that out with --json too")
        .excludes({"--measure"});
    verb.add_flag("--explain", o->explain,
                  "list the parts of the look that a shader could do without a LUT");
    verb.add_flag("--json", o->json, "print the results as JSON");
    o->watch.declare(verb);
    o->config.declare(verb);
    return [o, &verb] { return run_bake(*o, verb); };
}

} // namespace converter
