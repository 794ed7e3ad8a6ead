#include "preview/frame/measured.h"

#include "preview/finish/blooms.h"
#include "preview/frame/frame.h"
#include "preview/frame/frame_effects.h"

#include <cstring>

namespace preview {

std::optional<float> measured_maximum(Executor& executor, const FrameInputs& inputs,
                                      const FrameSettings& settings) {
    if (settings.shows_intermediate() || settings.force_all || settings.bloom == nullptr ||
        settings.without.has(Effect::bloom) || bloom_onset(settings.bloom_settings) <= 0 ||
        is_display_encoded(inputs)) {
        return inputs.hdr_maximum;
    }
    FrameSettings measuring = settings;
    measuring.only_maximum = true;
    Graph graph;
    const FrameHandles handles = build_frame(graph, inputs, measuring);
    executor.render(graph);
    float maximum = 0;
    std::memcpy(&maximum, executor.read_buffer(handles.hdr_maximum).data(), sizeof maximum);
    return maximum;
}

} // namespace preview
