#include "preview/frame/frame_stills.h"

#include "preview/frame/frame_zoom.h"
#include "preview/scene/gpu_scene.h"

namespace preview {

namespace {

constexpr std::array<std::string_view, 2> names{"still A", "still B"};

bool shows(const Compare& compare, std::size_t side) {
    return side == 0 ? compare.shows_a : compare.shows_b;
}

} // namespace

bool compares_stills(const FrameInputs& inputs, const FrameSettings& settings) {
    return (inputs.stills[0] != nullptr && settings.compare->shows_a) ||
           (inputs.stills[1] != nullptr && settings.compare->shows_b);
}

FrameSettings beside_stills(const FrameInputs& inputs, const FrameSettings& settings) {
    FrameSettings out = settings;
    out.compare = inputs.stills[0] != nullptr ? &compare_b : &compare_a;
    return out;
}

void fit_stills(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                FrameHandles& handles) {
    const Size size = size_of(graph, handles.hdr);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (inputs.stills[i] == nullptr) {
            graph.withhold(names[i], "that side shows no still");
            continue;
        }
        const gpu::Image& image = inputs.stills[i]->image;
        handles.stills[i] = add_fitted_still(
            graph, graph.import(std::string(names[i]) + " picture", image, image.desc()), size,
            {settings.format, settings.reuses_light(), names[i]});
    }
}

void compare_with_stills(Graph& graph, const FrameSettings& settings, bool is_viewed,
                         FrameHandles& handles) {
    const Size size = size_of(graph, handles.hdr);
    const Compare& compare = *settings.compare;
    StillSettings how{.compare = &compare,
                      .wipe = wipe_shape(settings, compare, size),
                      .heat_scale =
                          settings.heat_scale < 0 ? usual_heat_scale : settings.heat_scale,
                      .has_marks = !is_viewed && !zooms(settings)};
    const auto compared = [&](ImageHandle picture) {
        std::array<StillSide, 2> sides = handles.stills;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            if (!shows(compare, i)) {
                sides[i] = {};
            } else if (!sides[i].picture) {
                sides[i] = {picture, size};
            }
        }
        how.format = graph.image_desc(picture).format;
        return add_still_comparison(graph, sides, size, how);
    };
    const Finished finished = compared(handles.output);
    if (is_viewed) {
        handles.unrounded = compared(handles.unrounded).picture;
        if (handles.before_looks) {
            handles.before_looks = compared(handles.before_looks).picture;
        }
    }
    handles.output = finished.picture;
    handles.figures = finished.figures;
}

} // namespace preview
