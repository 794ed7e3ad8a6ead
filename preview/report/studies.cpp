#include "preview/report/study.h"

namespace preview::report {

std::vector<const Study*> studies() {
    return {&surface_study,      &shadow_study,         &area_light_study, &surroundings_study,
            &occlusion_study,    &depth_of_field_study, &bloom_study,      &lookup_study,
            &antialiasing_study, &effect_study};
}

reference::Image supersampled(Renderer& renderer, const Situation& situation, int times) {
    Situation large = situation;
    const auto side = static_cast<std::uint32_t>(times);
    large.settings.output = {situation.settings.output.width * side,
                             situation.settings.output.height * side};
    return averaged(renderer.render(large).finished, times);
}

} // namespace preview::report
