#include "converter/panels/parts.h"

#include "lutlib/metrics/viewing.h"
#include "lutlib/survey/display.h"

#include <cmath>

namespace converter {

using lutlib::RgbD;

SeenLight::SeenLight(const lutlib::Encoding& encoding)
    : encoding_(encoding), to_rec709_(light_to_rec709(lutlib::Viewing(encoding))),
      from_rec709_(inverse(to_rec709_)) {}

RgbD SeenLight::of(RgbD codes) const {
    // The curves would take what is broken for a number.
    if (!std::isfinite(largest_magnitude(codes))) {
        return {no_value, no_value, no_value};
    }
    if (is_for_displays(encoding_)) {
        codes = saturate(codes);
    }
    encoding_.decode_all(std::span(&codes, 1));
    return to_rec709_ * codes;
}

RgbD SeenLight::codes(RgbD rec709) const {
    RgbD out = from_rec709_ * rec709;
    encoding_.encode_all(std::span(&out, 1));
    return out;
}

RgbD xyz_of_light(RgbD rec709) {
    static constexpr lutlib::Matrix3 to_xyz = rgb_to_xyz(lutlib::rec709);
    return to_xyz * rec709;
}

RgbD srgb_of_light(RgbD rec709) {
    if (std::isfinite(largest_magnitude(rec709))) {
        lutlib::srgb().encode_all(std::span(&rec709, 1));
    }
    return rec709;
}

std::vector<RgbD> images_of(const ShownLook& look, std::vector<RgbD> codes) {
    apply_in_parallel(look.look, codes);
    return codes;
}

bool same_inputs(const ShownLook& a, const ShownLook& b) {
    return a.domain == b.domain && a.input == b.input;
}

std::vector<const ShownLook*> befores(ShownLooks looks) {
    std::vector<const ShownLook*> out{&looks.front()};
    if (!same_inputs(looks.front(), looks.back())) {
        out.push_back(&looks.back());
    }
    return out;
}

std::string before_name(ShownLooks looks, const ShownLook& look) {
    return befores(looks).size() == 1 ? "before" : "before " + look.name;
}

plot::Line line_of(ShownLooks looks, std::size_t i, const std::string& what, std::size_t color) {
    plot::Line out;
    out.name = i == 0 ? what : "";
    out.label = looks.size() == 1 ? what : looks[i].name + ", " + what;
    out.color = color;
    out.dashed = out.pale = i > 0;
    return out;
}

plot::Line line_of(ShownLooks looks, std::size_t i) {
    plot::Line out;
    out.name = looks[i].name;
    out.color = i + 1;
    out.dashed = i > 0;
    return out;
}

std::vector<plot::Line> key_of(ShownLooks looks) {
    std::vector<plot::Line> out;
    for (std::size_t i = 0; looks.size() > 1 && i < looks.size(); ++i) {
        out.push_back(line_of(looks, i, "", series_of_all));
        out.back().name = looks[i].name;
        out.back().label.clear();
    }
    return out;
}

plot::Line thin_line(const std::string& name) {
    plot::Line out;
    out.name = name;
    return out;
}

std::vector<double> evenly(double low, double high, int count) {
    std::vector<double> out;
    for (int i = 0; i < count; ++i) {
        out.push_back(std::lerp(low, high, i / (count - 1.0)));
    }
    return out;
}

} // namespace converter
