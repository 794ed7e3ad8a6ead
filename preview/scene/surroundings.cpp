#include "preview/scene/surroundings.h"

#include "preview/finish/setting_needs.h"

#include <cmath>

namespace preview {

namespace {

// A kind's rows stand side by side.
constexpr NumberRow<Surroundings> numbers[] = {
    {.flag = "sun-height",
     .label = "Sun's height",
     .unit = "degrees",
     .help = "Puts the sun so high above the horizon, degrees; twilight below 0",
     .needs = Need::frame | Need::scene | Need::surroundings_kind,
     .min = -20,
     .max = 90,
     .of = [](Surroundings& s) -> float& { return s.sky.sun_height; }},
    {.flag = "sun-azimuth",
     .label = "Sun's azimuth",
     .unit = "degrees",
     .help = "Turns the sun to the right, degrees",
     .needs = Need::frame | Need::scene | Need::surroundings_kind,
     .min = -180,
     .max = 180,
     .of = [](Surroundings& s) -> float& { return s.sky.sun_azimuth; }},
    {.flag = "turbidity",
     .label = "Turbidity",
     .help = "Fills the air with haze: 2 is clear, 10 hazy; held within 2 to 10",
     .needs = Need::frame | Need::scene | Need::surroundings_kind,
     .min = 1,
     .max = 30,
     .slider_min = 2,
     .slider_max = 10,
     .of = [](Surroundings& s) -> float& { return s.sky.turbidity; }},
    {.flag = "surroundings-exposure",
     .label = "Surroundings' exposure",
     .unit = "stops",
     .help = "Brightens the sky with its sun, or the picture of the surroundings, stops",
     .needs = Need::frame | Need::scene | Need::surroundings_kind,
     .min = -20,
     .max = 20,
     .slider_min = -5,
     .slider_max = 5,
     .of = [](Surroundings& s) -> float& { return s.exposure; }},
    {.flag = "surroundings-rotation",
     .label = "Surroundings' rotation",
     .unit = "degrees",
     .help = "Turns the picture of the surroundings to the right, degrees",
     .needs = Need::frame | Need::scene | Need::surroundings_kind,
     .min = -180,
     .max = 180,
     .of = [](Surroundings& s) -> float& { return s.rotation; }},
    {.flag = "noise-hue",
     .label = "Noise's hue",
     .unit = "degrees",
     .help = "Chooses the hue of the noise at time 0, degrees; it turns once in 30 seconds",
     .needs = Need::frame | Need::scene | Need::surroundings_kind,
     .min = 0,
     .max = 360,
     .of = [](Surroundings& s) -> float& { return s.noise_hue; }},
    {.flag = "noise-value",
     .label = "Noise's value",
     .help = "Brightens the noise; of HSV",
     .needs = Need::frame | Need::scene | Need::surroundings_kind,
     .min = 0,
     .max = 1,
     .of = [](Surroundings& s) -> float& { return s.noise_value; }},
    {.flag = "noise-scale",
     .label = "Noise's scale",
     .help = "Makes the noise finer",
     .needs = Need::frame | Need::scene | Need::surroundings_kind,
     .min = 0.1,
     .max = 50,
     .slider_min = 0.5,
     .slider_max = 10,
     .is_logarithmic = true,
     .of = [](Surroundings& s) -> float& { return s.noise_scale; }},
};

constexpr SurroundingsInfo kinds[] = {
    {SurroundingsKind::gradient, "gradient", "the scene's own gradient and soft boxes", {}},
    {SurroundingsKind::sky, "sky", "a clear sky with its sun, by Preetham's model",
     std::span(numbers).subspan(0, 4)},
    {SurroundingsKind::picture, "picture", "an equirectangular picture, by its file's name",
     std::span(numbers).subspan(3, 2)},
    {SurroundingsKind::noise, "noise",
     "the gradient, and noise that --time moves where no surface is",
     std::span(numbers).subspan(5, 3)},
};

} // namespace

std::span<const SurroundingsInfo> surroundings_kinds() {
    return kinds;
}

std::span<const NumberRow<Surroundings>> surroundings_numbers() {
    return numbers;
}

glm::dvec4 noise_now(const Surroundings& surroundings) {
    constexpr double seconds_a_turn = 30, steps_a_second = 0.15, period = 256;
    const double turns =
        static_cast<double>(surroundings.noise_hue) / 360 + surroundings.seconds / seconds_a_turn;
    const double moved = std::fmod(surroundings.seconds * steps_a_second, period);
    return {turns - std::floor(turns), static_cast<double>(surroundings.noise_value),
            static_cast<double>(surroundings.noise_scale), moved};
}

} // namespace preview
