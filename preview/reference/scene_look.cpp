#include "preview/reference/scene_look.h"

#include "lutlib/color/matrix.h"

#include <algorithm>

namespace preview::reference {

using lutlib::RgbD;

RgbD graded_light(RgbD light, const lutlib::Encoding& fed, const lutlib::Encoding& gives,
                  const lutlib::Transform& look, const Tonemap* tonemap) {
    const lutlib::Encoding linear = *lutlib::encoding_named("linear");
    const auto held = [](double v) { return v > 0 ? std::min(v, lutlib::largest_light) : 0; };
    const RgbD sane{held(light.r), held(light.g), held(light.b)};
    RgbD c = lutlib::light_to_light(linear, fed) * sane;
    c = look(RgbD{fed.encode(c.r), fed.encode(c.g), fed.encode(c.b)});
    if (tonemap == nullptr && gives == lutlib::srgb()) {
        return c;
    }
    c = lutlib::light_to_light(gives, linear) *
        RgbD{gives.decode(c.r), gives.decode(c.g), gives.decode(c.b)};
    if (tonemap != nullptr) {
        return tonemap->apply(c);
    }
    const lutlib::Encoding& shown = lutlib::srgb();
    const auto encode = [&](double v) { return shown.encode(std::clamp(v, 0.0, 1.0)); };
    return {encode(c.r), encode(c.g), encode(c.b)};
}

} // namespace preview::reference
