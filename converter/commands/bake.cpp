// lutconv bake: a look becomes an engine's LUT picture.
#include "lutlib/bake/bake.h"
#include "converter/command.h"
#include "converter/config_options.h"
#include "converter/explain.h"
#include "converter/look_files.h"
#include "converter/options.h"
#include "converter/placing.h"
#include "converter/report.h"
#include "converter/unused.h"
#include "converter/usage.h"
#include "lutlib/bake/budget.h"
#include "lutlib/error.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/file.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/resample/resample.h"
#include "lutlib/resample/sample_lut.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <optional>

namespace converter {
namespace {

using lutlib::Bake;
using lutlib::BudgetBake;
using lutlib::Difference;
using lutlib::Domain;
using lutlib::FilledBake;
using lutlib::io::bake_report;

struct Options {
    std::string input, output;
    EngineOption engine;
    int size = 0, bits = 0;
    InterpolationOption interpolation;
    PlacingOptions placing;
    ConfigOptions config;
    double max_delta_e = 0, max_delta_itp = 0;
    double reference_white = lutlib::reference_white_nits;
    bool fit = false, measure = false, no_measure = false, explain = false, json = false;
};

std::string gain_text(std::string_view what, const lutlib::ErrorStats& before,
                      const lutlib::ErrorStats& after) {
    return fmt::format(
        "    {}: mean {:.4g} instead of {:.4g} ({:.1f} % less), max {:.4g} instead of "
        "{:.4g}\n",
        what, after.mean, before.mean, 100 * (1 - after.mean / before.mean), after.max, before.max);
}

std::string fit_text(const FilledBake& filled, const lutlib::Viewing& viewing) {
    if (!filled.fitted) {
        return "  fitting does not help this look at this size; its nodes are point samples\n";
    }
    const lutlib::BakeLoss& lost = filled.look_loss;
    const std::string clamped =
        lost.clamped_values == 0
            ? ""
            : fmt::format("  lost: {} of the look's own values at the nodes lie outside 0..1, by "
                          "{:.4g} at most; the fit aims at the look clamped to 0..1\n",
                          lost.clamped_values, lost.most_clamped);
    const Difference &before = *filled.point_sampled, &after = *filled.result;
    const lutlib::Metric eye = eye_metric(viewing);
    return clamped +
           fmt::format(
               "  fitted to the engine's lookup, over {} colours that the fit has not seen, "
               "and the largest of all:\n{}{}    greys are tinted by {:.4g} at most instead "
               "of {:.4g} (code values, between channels)\n",
               after.absolute.count,
               gain_text(lutlib::metrics()[static_cast<std::size_t>(eye)].label, before.by(eye),
                         after.by(eye)),
               gain_text("code values", before.absolute, after.absolute), filled.tint,
               filled.tint_of_point_samples);
}

// What was promised: the option, its metric and its limit.
struct Promise {
    std::string_view option, label;
    lutlib::Metric metric;
    double most;
};

std::optional<Promise> promise_of(const Options& o) {
    if (o.max_delta_itp > 0) {
        return Promise{"--max-delta-itp", "dE-ITP", lutlib::Metric::delta_e_itp, o.max_delta_itp};
    }
    if (o.max_delta_e > 0) {
        return Promise{"--max-delta-e", "dE2000", lutlib::Metric::delta_e_2000, o.max_delta_e};
    }
    return std::nullopt;
}

// Measuring takes ten times as long as the bake, so only who wants figures waits for them.
bool is_measured(const Options& o) {
    return o.measure || o.fit || promise_of(o) || (o.json && !o.no_measure);
}

std::string budget_text(const Options& o, const BudgetBake& found, const lutlib::Viewing& viewing) {
    const Bake& bake = found.filled.bake;
    const Promise promise = *promise_of(o);
    const std::string note =
        is_hdr(viewing.output) && promise.metric == lutlib::Metric::delta_e_2000
            ? "  note: dE2000 means little above diffuse white; --max-delta-itp judges HDR\n"
            : "";
    return fmt::format("  {} {} {:g}{} {} nodes, {} bits, {}, {} bytes of codes, {} tried\n{}",
                       found.kept ? "stays within" : "no combination stays within", promise.label,
                       promise.most, found.kept ? ":" : "; the closest is", bake.size,
                       bake.picture.depth.bits, found.filled.fitted ? "fitted" : "point-sampled",
                       lutlib::lattice_bytes(bake.size, bake.picture.depth.bits), found.tried,
                       note);
}

nlohmann::ordered_json as_json(const Options& o, const FilledBake& filled, const Domain& domain,
                               const lutlib::LookPlace& place,
                               const std::optional<Difference>& error,
                               const lutlib::Viewing& viewing) {
    const Bake& bake = filled.bake;
    const lutlib::io::Reach reach = lutlib::io::reach_of(domain, place.applied());
    nlohmann::ordered_json out{{"input", o.input},
                               {"output", o.output},
                               {"engine", bake.engine->name},
                               {"layout", bake.engine->layout},
                               {"width", bake.picture.width},
                               {"height", bake.picture.height},
                               {"size", bake.size},
                               {"bits", bake.picture.depth.bits},
                               {"srgb_tag", bake.engine->srgb_tag == lutlib::SrgbTag::present},
                               {"encodings", to_json(place)},
                               {"loss",
                                {{"clamped_values", bake.loss.clamped_values},
                                 {"most_clamped", bake.loss.most_clamped},
                                 {"reachable_domain_share", reach.reached},
                                 {"clamped_input_share", reach.clamped},
                                 {"max_rounding", bake.loss.max_rounding},
                                 {"mean_rounding", bake.loss.mean_rounding}}},
                               {"fitted", filled.fitted},
                               {"viewing", to_json(viewing)}};
    if (error) {
        out["absolute_error"] = to_json(error->absolute);
        out["delta_e_2000"] = to_json(error->delta_e_2000);
        out["delta_e_itp"] = to_json(error->delta_e_itp);
    }
    return out;
}

nlohmann::ordered_json fit_json(const FilledBake& filled) {
    const Difference &before = *filled.point_sampled, &after = *filled.result;
    return {
        {"point_sampled", to_json(before.absolute)},
        {"result", to_json(after.absolute)},
        {"delta_e_2000",
         {{"point_sampled", to_json(before.delta_e_2000)},
          {"result", to_json(after.delta_e_2000)}}},
        {"delta_e_itp",
         {{"point_sampled", to_json(before.delta_e_itp)}, {"result", to_json(after.delta_e_itp)}}},
        {"grey_tint", {{"point_sampled", filled.tint_of_point_samples}, {"result", filled.tint}}},
        {"look_clamped_values", filled.look_loss.clamped_values},
        {"look_most_clamped", filled.look_loss.most_clamped}};
}

nlohmann::ordered_json budget_json(const Options& o, const BudgetBake& found) {
    const Promise promise = *promise_of(o);
    return {{promise.metric == lutlib::Metric::delta_e_itp ? "max_delta_itp" : "max_delta_e",
             promise.most},
            {"kept", found.kept},
            {"tried", found.tried},
            {"bytes",
             lutlib::lattice_bytes(found.filled.bake.size, found.filled.bake.picture.depth.bits)},
            {"largest", found.largest}};
}

bool is_beyond_fitting(const Options& o, const FilledBake& filled) {
    return o.fit && filled.bake.size > lutlib::largest_fitted_size;
}

FilledBake fill(const Options& o, const lutlib::Transform& look, const lutlib::Engine& engine,
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

// Everything that is found out about one bake, before any of it is written or printed.
struct BakeReport {
    FilledBake filled;
    std::optional<BudgetBake> budgeted; ///< with --max-delta-e
    std::string title;
    lutlib::Interpolation interpolation; ///< how the look was read
    Domain domain;
    lutlib::LookPlace place;
    lutlib::Viewing viewing;         ///< of what comes out
    std::optional<Difference> error; ///< unless it was not to be measured
    std::optional<Explanation> explanation;

    bool is_kept() const { return !budgeted || budgeted->kept; }
};

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

lutlib::io::Look opened(const Options& o) {
    return o.config.given() && o.input == identity_word
               ? identity_look()
               : open_look(o.input,
                           {.interpolation = o.interpolation.get(), .encodings = o.placing.look()});
}

// A config says what is converted, of spaces that have no encoding here.
lutlib::LookPlace place_of(const Options& o, const lutlib::Engine& engine,
                           const lutlib::io::Look& look) {
    if (o.config.given()) {
        return {};
    }
    lutlib::LookPlace out = lutlib::io::place_in(engine, look.encodings(), o.placing.convert());
    out.adaptation = &o.placing.adaptation();
    return out;
}

BakeReport make_report(const Options& o, const Verb& verb) {
    const lutlib::Engine& engine = o.engine.get();
    const lutlib::io::Look look = opened(o);
    BakeReport out;
    out.place = place_of(o, engine, look);
    const lutlib::Placement placement = out.place.applied();
    const lutlib::Transform exact = o.config.before(placement.around(look.exact()));
    tell_unused(verb, {interpolation_part(has_lattice(look)),
                       adaptation_part(placement),
                       {"--reference-white", is_measured(o), "nothing is measured"}});
    out.title = look.title();
    out.interpolation = look.interpolation();
    out.domain = o.config.given() ? Domain{} : look.domain();
    out.viewing = lutlib::io::viewing_of(out.place, o.reference_white);
    const lutlib::Breaks breaks =
        o.config.given() ? lutlib::no_breaks() : lutlib::io::placed(look.breaks(), placement);
    if (const std::optional<Promise> promise = promise_of(o)) {
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

std::string made_of(const Options& o) {
    return lutlib::io::input_name(o.input) + (o.config.given() ? ", " + o.config.text() : "");
}

void write_picture(const Options& o, const BakeReport& report) {
    lutlib::io::write_file(
        o.output, lutlib::io::picture_bytes(report.filled.bake,
                                            {.source = made_of(o),
                                             .title = report.title,
                                             .interpolation = name_of(report.interpolation),
                                             .fitted = report.filled.fitted,
                                             .encodings = names_of(report.place.shown()),
                                             .look = names_of(report.place.look)}));
}

nlohmann::ordered_json report_json(const Options& o, const BakeReport& report) {
    nlohmann::ordered_json json =
        as_json(o, report.filled, report.domain, report.place, report.error, report.viewing);
    if (o.config.given()) {
        json["ocio_config"] = o.config.text();
    }
    if (report.filled.result) {
        json["fit"] = fit_json(report.filled);
    }
    if (is_beyond_fitting(o, report.filled)) {
        json["notes"] = {"not fitted: " + lutlib::fit_limit_text()};
    }
    if (report.budgeted) {
        json["budget"] = budget_json(o, *report.budgeted);
    }
    if (report.explanation) {
        json["explanation"] = to_json(*report.explanation);
    }
    return json;
}

std::string report_text(const Options& o, const BakeReport& report) {
    std::string out = bake_report(input_text(o.input), output_text(o.output), report.filled.bake,
                                  report.domain, report.place, report.error, report.viewing);
    if (o.config.given()) {
        out += "  encodings: " + o.config.text() +
               " is converted by OpenColorIO before the look, and nothing else\n";
    }
    if (!report.error) {
        out += "  not measured: how far the lookup is from the look between the nodes; --measure "
               "says it, and so does lutconv verify\n";
    }
    if (report.filled.result) {
        out += fit_text(report.filled, report.viewing);
    }
    if (is_beyond_fitting(o, report.filled)) {
        out += "  not fitted: " + lutlib::fit_limit_text() + "\n";
    }
    if (report.budgeted) {
        out += budget_text(o, *report.budgeted, report.viewing);
    }
    if (report.explanation) {
        out += to_text(*report.explanation);
    }
    return out;
}

void say_that_nothing_was_written(const Options& o, const BudgetBake& found) {
    print(fmt::format("  nothing was written; raise {} above {:.4g}{}\n", promise_of(o)->option,
                      found.largest, o.size || o.bits ? ", or leave --size and --bits open" : ""),
          std::string(lutlib::io::standard_stream));
}

int run(const Options& o, const Verb& verb) {
    require_png_name(o.output, "bake");
    o.config.check();
    o.config.require_alone(o.placing.given());
    if (o.no_measure && (o.fit || promise_of(o))) {
        throw lutlib::UsageError("a fit and a promise are measured; leave --no-measure out");
    }
    const BakeReport report = make_report(o, verb);
    if (report.is_kept()) {
        write_picture(o, report);
    }
    o.json ? print(report_json(o, report), o.output) : print(report_text(o, report), o.output);
    if (!report.is_kept()) {
        say_that_nothing_was_written(o, *report.budgeted);
        return verification_failed;
    }
    return ok;
}

} // namespace

Run declare_bake(Verb& verb) {
    const auto o = std::make_shared<Options>();
    verb.add_option("LUT", o->input,
                    "a LUT or recipe file, or - for standard input; with --ocio-config also the "
                    "word identity")
        .required();
    verb.add_option("-o,--output", o->output, "the PNG, or - for standard output").required();
    o->engine.declare(verb, "piccolo");
    verb.add_option("--size", o->size, "lattice size: nodes per axis (default: the engine's)")
        .takes(Takes::cube_size);
    verb.add_option("--bits", o->bits, "bits per sample: 8 or 16 (default: the engine's)")
        .takes(Takes::picture_bits);
    o->interpolation.declare(verb, "how to interpolate the look between its own nodes");
    o->placing.declare(verb);
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
        "of all colours, in code values and dE2000; takes ten times as long. With --json, "
        "--fit and --max-delta-e always");
    verb.add_flag("--no-measure", o->no_measure, "leave that out with --json too")
        .excludes({"--measure"});
    verb.add_flag("--explain", o->explain,
                  "list the parts of the look that a shader could do without a LUT");
    verb.add_flag("--json", o->json, "print the results as JSON");
    o->config.declare(verb);
    return [o, &verb] { return run(*o, verb); };
}

} // namespace converter
