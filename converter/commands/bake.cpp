// lutconv bake: a look becomes an engine's LUT picture.
#include "lutlib/bake/bake.h"
#include "converter/command.h"
#include "converter/explain.h"
#include "converter/look_files.h"
#include "converter/options.h"
#include "converter/placing.h"
#include "converter/report.h"
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
using lutlib::Domain;
using lutlib::FilledBake;
using lutlib::LookupError;
using lutlib::io::bake_report;
using lutlib::io::measure_bake;

struct Options {
    std::string input, output;
    EngineOption engine;
    int size = 0, bits = 0;
    InterpolationOption interpolation;
    PlacingOptions placing;
    double max_delta_e = 0;
    bool fit = false, explain = false, json = false;
};

std::string fit_text(const FilledBake& filled) {
    const lutlib::ErrorStats &before = filled.point_sampled, &after = filled.result;
    if (!filled.fitted) {
        return "  fitting does not help this look at this size; its nodes are point samples\n";
    }
    const lutlib::BakeLoss& lost = filled.look_loss;
    const std::string clamped =
        lost.clamped_values == 0
            ? ""
            : fmt::format("  lost: {} of the look's own values at the nodes lie outside 0..1, by "
                          "{:.4g} at most; the fit aims at the look held to 0..1\n",
                          lost.clamped_values, lost.most_clamped);
    return clamped +
           fmt::format("  fitted to the engine's lookup: mean error {:.4g} instead of {:.4g} "
                       "({:.1f} % less), max {:.4g} instead of {:.4g}; over {} colours that the "
                       "fit has not seen\n",
                       after.mean, before.mean, 100 * (1 - after.mean / before.mean), after.max,
                       before.max, after.count);
}

std::string budget_text(const Options& o, const BudgetBake& found) {
    const Bake& bake = found.filled.bake;
    return fmt::format("  {} dE2000 {:g}{} {} nodes, {} bits, {}, {} bytes of codes, {} tried\n"
                       "    on the {} colours it was chosen on: {}\n"
                       "    on {} others, and uphill from the worst of them: {}\n",
                       found.kept ? "stays within" : "no combination stays within", o.max_delta_e,
                       found.kept ? ":" : "; the closest is", bake.size, bake.picture.depth.bits,
                       found.filled.fitted ? "fitted" : "point-sampled",
                       lutlib::lattice_bytes(bake.size, bake.picture.depth.bits), found.tried,
                       found.chosen_on.delta_e.count, to_text(found.chosen_on.delta_e),
                       found.checked_on.delta_e.count, to_text(found.checked_on.delta_e));
}

nlohmann::ordered_json as_json(const Options& o, const FilledBake& filled, const Domain& domain,
                               const lutlib::LookPlace& place, const LookupError& error) {
    const Bake& bake = filled.bake;
    const lutlib::io::Reach reach = lutlib::io::reach_of(domain, place.applied());
    return {{"input", o.input},
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
            {"absolute_error", to_json(error.absolute)},
            {"delta_e_2000", to_json(error.delta_e)}};
}

nlohmann::ordered_json fit_json(const FilledBake& filled) {
    return {{"point_sampled", to_json(filled.point_sampled)},
            {"result", to_json(filled.result)},
            {"look_clamped_values", filled.look_loss.clamped_values},
            {"look_most_clamped", filled.look_loss.most_clamped}};
}

nlohmann::ordered_json budget_json(const Options& o, const BudgetBake& found) {
    return {{"max_delta_e", o.max_delta_e},
            {"kept", found.kept},
            {"tried", found.tried},
            {"bytes",
             lutlib::lattice_bytes(found.filled.bake.size, found.filled.bake.picture.depth.bits)},
            {"chosen_on", to_json(found.chosen_on.delta_e)},
            {"checked_on", to_json(found.checked_on.delta_e)}};
}

bool is_beyond_fitting(const Options& o, const FilledBake& filled) {
    return o.fit && filled.bake.size > lutlib::largest_fitted_size;
}

FilledBake fill(const Options& o, const lutlib::Transform& look, const lutlib::Engine& engine) {
    const int size = o.size ? o.size : engine.default_size;
    const int bits = o.bits ? o.bits : engine.default_bits;
    check_contract(engine, size, bits);
    return o.fit ? bake_fitted(look, engine, size, bits)
                 : FilledBake{bake(look, engine, size, bits), false, {}, {}};
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
    LookupError error;
    std::optional<Explanation> explanation;

    bool is_kept() const { return !budgeted || budgeted->kept; }
};

// The look as the engine is to see it.
lutlib::Lut table_to_explain(const lutlib::io::Look& look, const lutlib::Transform& placed,
                             const lutlib::Placement& placement) {
    if (!placement.converts()) {
        return *look.table().lut;
    }
    lutlib::Lut out;
    out.cube = lutlib::sample_cube(placed, {}, lutlib::usual_cube_size);
    return out;
}

BakeReport make_report(const Options& o) {
    const lutlib::Engine& engine = o.engine.get();
    const lutlib::io::Look look =
        open_look(o.input, {.interpolation = o.interpolation.get(), .encodings = o.placing.look()});
    BakeReport out;
    out.place = lutlib::io::place_in(engine, look.encodings(), o.placing.convert());
    out.place.adaptation = &o.placing.adaptation();
    const lutlib::Placement placement = out.place.applied();
    const lutlib::Transform exact = placement.around(look.exact());
    out.title = look.title();
    out.interpolation = look.interpolation();
    out.domain = look.domain();
    if (o.max_delta_e > 0) {
        out.budgeted =
            bake_within(exact, engine, {o.max_delta_e, if_given(o.size), if_given(o.bits), true});
        out.filled = out.budgeted->filled;
    } else {
        out.filled = fill(o, exact, engine);
    }
    out.error = measure_bake(out.filled.bake, exact);
    if (o.explain) {
        // What changes less than half a code is not seen in the picture.
        out.explanation = explain(table_to_explain(look, exact, placement),
                                  0.5 / out.filled.bake.picture.depth.maximum());
        out.explanation->kept =
            "the engine reads a lattice of this size, so there is nothing to leave out";
    }
    return out;
}

void write_picture(const Options& o, const BakeReport& report) {
    lutlib::io::write_file(
        o.output, lutlib::io::picture_bytes(report.filled.bake,
                                            {.source = lutlib::io::input_name(o.input),
                                             .title = report.title,
                                             .interpolation = name_of(report.interpolation),
                                             .fitted = report.filled.fitted,
                                             .encodings = names_of(report.place.shown()),
                                             .look = names_of(report.place.look)}));
}

nlohmann::ordered_json report_json(const Options& o, const BakeReport& report) {
    nlohmann::ordered_json json =
        as_json(o, report.filled, report.domain, report.place, report.error);
    if (report.filled.result.count > 0) {
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
                                  report.domain, report.place, report.error);
    if (report.filled.result.count > 0) {
        out += fit_text(report.filled);
    }
    if (is_beyond_fitting(o, report.filled)) {
        out += "  not fitted: " + lutlib::fit_limit_text() + "\n";
    }
    if (report.budgeted) {
        out += budget_text(o, *report.budgeted);
    }
    if (report.explanation) {
        out += to_text(*report.explanation);
    }
    return out;
}

void say_that_nothing_was_written(const Options& o, const BudgetBake& found) {
    print(fmt::format("  nothing was written; raise --max-delta-e above {:.4g}{}\n",
                      found.largest_delta_e(),
                      o.size || o.bits ? ", or leave --size and --bits open" : ""),
          std::string(lutlib::io::standard_stream));
}

int run(const Options& o) {
    require_png_name(o.output, "bake");
    const BakeReport report = make_report(o);
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

Run declare_bake(CLI::App& app) {
    const auto o = std::make_shared<Options>();
    app.add_option("LUT", o->input, "a LUT or recipe file, or - for standard input")->required();
    app.add_option("-o,--output", o->output, "the PNG, or - for standard output")->required();
    o->engine.declare(app, "piccolo");
    app.add_option("--size", o->size, "lattice size: nodes per axis (default: the engine's)")
        ->check(cube_sizes());
    app.add_option("--bits", o->bits, "bits per sample: 8 or 16 (default: the engine's)")
        ->check(picture_bits());
    o->interpolation.declare(app, "how to interpolate the look between its own nodes");
    o->placing.declare(app);
    app.add_flag("--fit", o->fit,
                 fmt::format("choose the nodes so that the engine's lookup comes nearest to the "
                             "look between them; keeps point samples where that does not help, "
                             "and beyond {} nodes per axis",
                             lutlib::largest_fitted_size));
    app.add_option(
           "--max-delta-e", o->max_delta_e,
           "take the smallest combination of size, bits and fit that the engine accepts and "
           "that stays within this dE2000; writes nothing, with exit code 1, when none does")
        ->check(above_zero());
    app.add_flag("--explain", o->explain,
                 "list the parts of the look that a shader could do without a LUT");
    app.add_flag("--json", o->json, "print the results as JSON");
    return [o] { return run(*o); };
}

} // namespace converter
