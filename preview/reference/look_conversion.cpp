#include "preview/reference/look_conversion.h"

#include "lutlib/color/matrix.h"

#include <algorithm>

namespace preview::reference {

using lutlib::RgbD;

namespace {

RgbD encoded(const lutlib::Encoding& as, RgbD light) {
    return {as.encode(light.r), as.encode(light.g), as.encode(light.b)};
}

RgbD decoded(const lutlib::Encoding& from, RgbD codes) {
    return {from.decode(codes.r), from.decode(codes.g), from.decode(codes.b)};
}

RgbD fed_to(const LookConversion& conversion, RgbD texel) {
    const lutlib::Encoding& fed = conversion.fed;
    if (conversion.codes) {
        const lutlib::Encoding& codes = *conversion.codes;
        return codes == fed ? texel
                            : encoded(fed, light_to_light(codes, fed) * decoded(codes, texel));
    }
    const auto held = [](double v) { return v > 0 ? std::min(v, lutlib::largest_light) : 0; };
    const RgbD light{held(texel.r), held(texel.g), held(texel.b)};
    return encoded(fed, light_to_light(*lutlib::encoding_named("linear"), fed) * light);
}

} // namespace

RgbD graded(RgbD texel, const LookConversion& conversion, const lutlib::Transform& look,
            const Tonemap& tonemap) {
    const RgbD out = look(fed_to(conversion, texel));
    const lutlib::Encoding& gives = conversion.gives;
    if (conversion.is_picture && gives == lutlib::srgb()) {
        return out;
    }
    const RgbD light =
        light_to_light(gives, *lutlib::encoding_named("linear")) * decoded(gives, out);
    if (!conversion.is_picture) {
        return tonemap.apply(light);
    }
    const auto held = [](double v) { return std::clamp(v, 0.0, 1.0); };
    return encoded(lutlib::srgb(), {held(light.r), held(light.g), held(light.b)});
}

} // namespace preview::reference
