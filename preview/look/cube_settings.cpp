#include "preview/look/cube_settings.h"

#include "preview/finish/setting_needs.h"

namespace preview {

namespace {

constexpr NumberRow<CubeView> numbers[] = {
    {.flag = "cube-turn",
     .label = "Turn",
     .unit = "degrees",
     .help = "Turn of the cube view about the neutral axis, degrees",
     .needs = Need::cube_view,
     .min = -360,
     .max = 360,
     .of = [](CubeView& v) -> float& { return v.turn; }},
    {.flag = "cube-tilt",
     .label = "Tilt",
     .unit = "degrees",
     .help = "Elevation of the cube view, degrees; 90 looks down on white",
     .needs = Need::cube_view,
     .min = -90,
     .max = 90,
     .of = [](CubeView& v) -> float& { return v.tilt; }},
    {.flag = "cube-zoom",
     .label = "Zoom",
     .help = "Camera zoom of the cube view",
     .needs = Need::cube_view,
     .min = 0.3,
     .max = 8,
     .is_logarithmic = true,
     .of = [](CubeView& v) -> float& { return v.zoom; }},
};

constexpr SwitchRow<CubeView> switches[] = {
    {.flag = "cube-by-input",
     .label = "in the colours of their inputs",
     .help = "Dots in the colours that nodes stand for, not those they give",
     .needs = Need::cube_view,
     .of = [](CubeView& v) -> bool& { return v.by_input; }},
    {.flag = "cube-clamped",
     .label = "where a display shows them, within 0 to 1",
     .help = "Nodes where a display shows them, within 0 to 1",
     .needs = Need::cube_view,
     .of = [](CubeView& v) -> bool& { return v.clamped; }},
};

} // namespace

std::span<const NumberRow<CubeView>> cube_numbers() {
    return numbers;
}

std::span<const SwitchRow<CubeView>> cube_switches() {
    return switches;
}

} // namespace preview
