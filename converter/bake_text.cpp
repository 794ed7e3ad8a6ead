#include "converter/bake_result.h"
#include "converter/report.h"
#include "lutlib/io/bake_report.h"

#include <fmt/core.h>

namespace converter {
namespace {

std::string gain_text(std::string_view what, const lutlib::ErrorStats& before,
                      const lutlib::ErrorStats& after) {
    return fmt::format(
        "    {}: mean {:.4g} instead of {:.4g} ({:.1f} % less), max {:.4g} instead of "
        "{:.4g}\n",
        what, after.mean, before.mean, 100 * (1 - after.mean / before.mean), after.max, before.max);
}

std::string fit_text(const lutlib::FilledBake& filled, const lutlib::Viewing& viewing) {
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
    const lutlib::Difference &before = *filled.point_sampled, &after = *filled.result;
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

std::string budget_text(const Promise& promise, const lutlib::BudgetBake& found,
                        const lutlib::Viewing& viewing) {
    const lutlib::Bake& bake = found.filled.bake;
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

} // namespace

std::string to_text(const BakeResult& result) {
    std::string out = lutlib::io::bake_report(input_text(result.input), output_text(result.output),
                                              result.filled.bake, result.domain, result.place,
                                              result.error, result.viewing);
    if (!result.config.empty()) {
        out += "  encodings: " + result.config +
               " is converted by OpenColorIO before the look, and nothing else\n";
    }
    if (!result.error) {
        out += "  not measured: how far the lookup is from the look between the nodes; --measure "
               "says it, and so does lutconv verify\n";
    }
    if (result.filled.result) {
        out += fit_text(result.filled, result.viewing);
    }
    if (result.is_beyond_fitting()) {
        out += "  not fitted: " + lutlib::fit_limit_text() + "\n";
    }
    if (result.budgeted) {
        out += budget_text(*result.promise, *result.budgeted, result.viewing);
    }
    if (result.explanation) {
        out += to_text(*result.explanation);
    }
    return out;
}

} // namespace converter
