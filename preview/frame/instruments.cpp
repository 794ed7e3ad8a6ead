#include "preview/frame/instruments.h"

#include "lutlib/error.h"
#include "preview/passes/axes.h"
#include "preview/passes/pass.h"
#include "preview/passes/probe.h"
#include "preview/passes/scope.h"

#include <string>

namespace preview {

namespace {

void add_scopes(Graph& graph, const FrameSettings& settings, FrameHandles& handles) {
    const Size size = size_of(graph, handles.output);
    const ColumnRange range = scope_range(*settings.scope_side, *settings.compare, settings.split,
                                          size.width, size.height);
    const bool is_part = settings.scope_side != &scope_side_shown && settings.compare->shows_one;
    const bool has_columns = settings.compare != &compare_box && is_upright(settings);
    for (std::size_t i = 0; i < scopes.size(); ++i) {
        if (settings.scope_sizes[i] == Size{}) {
            graph.withhold(scopes[i].name, "it is not shown");
        } else if (is_part && !has_columns) {
            graph.withhold(scopes[i].name, "its side is not columns of the picture: turn the split "
                                           "upright, or choose another comparison");
        } else if (range.count == 0) {
            graph.withhold(scopes[i].name, settings.compare == &compare_difference
                                               ? "a heat map has no code values to count"
                                               : "its side is not shown");
        } else {
            handles.scope_pictures[i] =
                add_scope(graph, handles.output, scopes[i], range,
                          {settings.scope_sizes[i],
                           settings.scope_logarithmic.value_or(scopes[i].logarithmic),
                           settings.scope_figures})
                    .picture;
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

void add_instruments(Graph& graph, const FrameSettings& settings, const Finishing& finishing,
                     std::optional<ProbePlace> probe, FrameHandles& handles) {
    add_scopes(graph, settings, handles);
    if (settings.scope != nullptr) {
        handles.output = handles.scope_pictures[index_of(*settings.scope)];
        if (!handles.output) {
            throw lutlib::UsageError("this frame has nothing for the " +
                                     std::string(settings.scope->name) +
                                     " to show; --explain says why");
        }
    }
    if (probe) {
        handles.probe =
            add_probe(graph, finishing,
                      before_comparison(*probe, settings, size_of(graph, finishing.picture)));
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
