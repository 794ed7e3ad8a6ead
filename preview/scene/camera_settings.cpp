#include "preview/scene/camera_settings.h"

#include "preview/finish/setting_needs.h"

namespace preview {

namespace {

constexpr NumberRow<Orbit> numbers[] = {
    {.flag = "azimuth",
     .label = "Azimuth",
     .unit = "degrees",
     .help = "Turns the camera to the right, degrees",
     .needs = Need::frame | Need::scene,
     .min = -180,
     .max = 180,
     .of = [](Orbit& o) -> float& { return o.azimuth; }},
    {.flag = "elevation",
     .label = "Elevation",
     .unit = "degrees",
     .help = "Raises the camera, degrees",
     .needs = Need::frame | Need::scene,
     .min = -89,
     .max = 89,
     .of = [](Orbit& o) -> float& { return o.elevation; }},
    {.flag = "distance",
     .label = "Distance",
     .unit = "m",
     .help = "Moves the camera away, metres",
     .needs = Need::frame | Need::scene,
     .min = 0.2,
     .max = 1000,
     .slider_min = 0.2,
     .slider_max = 50,
     .is_logarithmic = true,
     .of = [](Orbit& o) -> float& { return o.distance; }},
    {.flag = "fov",
     .label = "Field of view",
     .unit = "degrees",
     .help = "Widens the field of view, degrees",
     .needs = Need::frame | Need::scene,
     .min = 1,
     .max = 170,
     .slider_min = 10,
     .slider_max = 120,
     .of = [](Orbit& o) -> float& { return o.field_of_view; }},
    {.flag = "roll",
     .label = "Roll",
     .unit = "degrees",
     .help = "Turns the camera about its axis, degrees",
     .needs = Need::frame | Need::scene,
     .min = -180,
     .max = 180,
     .of = [](Orbit& o) -> float& { return o.roll; }},
    {.flag = "pan-right",
     .label = "Pan to the right",
     .unit = "m",
     .help = "Moves the camera and what it looks at to the right, metres",
     .needs = Need::frame | Need::scene,
     .min = -1000,
     .max = 1000,
     .slider_min = -5,
     .slider_max = 5,
     .of = [](Orbit& o) -> float& { return o.pan.x; }},
    {.flag = "pan-up",
     .label = "Pan upwards",
     .unit = "m",
     .help = "Moves the camera and what it looks at upwards, metres",
     .needs = Need::frame | Need::scene,
     .min = -1000,
     .max = 1000,
     .slider_min = -5,
     .slider_max = 5,
     .of = [](Orbit& o) -> float& { return o.pan.y; }},
};

} // namespace

std::span<const NumberRow<Orbit>> camera_numbers() {
    return numbers;
}

} // namespace preview
