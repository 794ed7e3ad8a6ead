#include "preview/frame/instruments.h"

#include "lutlib/error.h"
#include "preview/gpu/memory.h"
#include "preview/passes/axes.h"
#include "preview/passes/pass.h"
#include "preview/passes/probe.h"
#include "preview/passes/scope.h"
#include "preview/passes/scope_codes.h"

#include <string>

namespace preview {

namespace {

/// What scopes with levels count in place of the picture's codes; empty where they count those.
ImageHandle codes_for_scopes(Graph& graph, const FrameSettings& settings, ImageHandle picture) {
    bool is_wanted = false;
    for (std::size_t i = 0; i < scopes.size(); ++i) {
        const bool is_counted = settings.keeps_scopes || settings.scope_sizes[i] != Size{};
        is_wanted = is_wanted || (is_counted && has_levels(scopes[i]));
    }
    if (is_wanted && settings.scope_levels.converts()) {
        return add_scope_codes(graph, picture, settings.scope_levels);
    }
    graph.withhold("encode for scopes", is_wanted ? "they count the codes as they are shown"
                                                  : "no scope with levels is shown");
    return {};
}

/// In their usual size those that nobody sees.
ScopeDrawing drawing_of(const FrameSettings& settings, const Scope& scope) {
    const Size size = settings.scope_sizes[index_of(scope)];
    return {size == Size{} ? Size{scope.width, scope.height} : size,
            settings.scope_logarithmic.value_or(scope.logarithmic), settings.scope_figures,
            settings.scope_levels, settings.scope_gain->factor};
}

ScopeCounts imported(Graph& graph, const Scope& scope, const KeptScope& kept) {
    return {graph.import("frozen counts of " + std::string(scope.name), *kept.counts,
                         kept.counts->bytes()),
            kept.columns, kept.width, kept.height};
}

void add_scopes(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                FrameHandles& handles) {
    const ScopeArea area = scope_area(*settings.scope_side, *settings.compare, settings,
                                      settings.scope_region, size_of(graph, handles.output));
    const std::string_view reason =
        no_scope_because(area, *settings.scope_side, *settings.compare, settings.scope_region);
    const ImageHandle encoded = codes_for_scopes(graph, settings, handles.output);
    for (const Scope& scope : scopes) {
        const std::size_t i = index_of(scope);
        const bool is_seen = settings.scope_sizes[i] != Size{};
        const bool is_kept = inputs.kept_scopes[i].counts != nullptr;
        const ScopeDrawing drawing = drawing_of(settings, scope);
        if (!is_seen && !settings.keeps_scopes) {
            graph.withhold(scope.name, "it is not shown");
            continue;
        }
        if (!is_kept && !reason.empty()) {
            graph.withhold(scope.name, reason);
            continue;
        }
        if (is_kept) {
            graph.withhold("count " + std::string(scope.name),
                           "it is frozen, and shows what was counted then");
            handles.scope_counts[i] = imported(graph, scope, inputs.kept_scopes[i]);
        } else {
            const bool is_encoded = encoded && has_levels(scope);
            handles.scope_counts[i] =
                count_scope(graph, is_encoded ? encoded : handles.output, scope, area, drawing);
        }
        if (settings.keeps_scopes) {
            graph.present(handles.scope_counts[i].counts);
        }
        if (is_seen) {
            handles.scope_pictures[i] = draw_scope(graph, scope, handles.scope_counts[i], drawing);
            graph.present(handles.scope_pictures[i]);
        }
    }
}

/// A place of the output as one of the picture before its comparison.
ProbePlace before_comparison(ProbePlace place, const FrameSettings& settings, Size picture) {
    if (settings.compare == &compare_side) {
        place.x %= static_cast<std::int32_t>(picture.width);
    }
    return place;
}

} // namespace

void add_instruments(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                     const Finishing& finishing, std::optional<ProbePlace> probe,
                     FrameHandles& handles) {
    add_scopes(graph, inputs, settings, handles);
    if (settings.scope != nullptr) {
        handles.output = handles.scope_pictures[index_of(*settings.scope)];
        if (!handles.output) {
            throw lutlib::UsageError("this frame has nothing for the " +
                                     std::string(settings.scope->name) +
                                     " to show; --explain says why");
        }
    }
    if (probe) {
        handles.probe = add_probe(
            graph, finishing,
            before_comparison(*probe, settings, size_of(graph, finishing.picture)), handles.stills);
        graph.present(handles.probe);
    } else {
        graph.withhold("probe", "the mouse is not over the picture");
    }
    if (settings.axes != nullptr) {
        handles.axis_counts = add_axes(graph, finishing, *settings.axes);
        graph.present(handles.axis_counts);
    } else {
        graph.withhold("count along axes", "no curve editor is open");
    }
}

} // namespace preview
