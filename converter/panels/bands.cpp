#include "converter/panels/bands.h"

#include "converter/panels/parts.h"
#include "lutlib/plot/dot_font.h"

namespace converter {

std::vector<lutlib::RgbD> codes_of_light(const ShownLook& look, std::vector<lutlib::RgbD> light) {
    const SeenLight seen(look.input);
    for (lutlib::RgbD& c : light) {
        c = seen.codes(c);
    }
    return light;
}

std::vector<lutlib::RgbD> in_srgb(std::vector<lutlib::RgbD> codes,
                                  const lutlib::Encoding& encoding) {
    const SeenLight seen(encoding);
    for (lutlib::RgbD& c : codes) {
        c = seen.of(c);
    }
    return shown_srgb(std::move(codes));
}

std::vector<lutlib::RgbD> shown_srgb(std::vector<lutlib::RgbD> light) {
    for (lutlib::RgbD& c : light) {
        c = srgb_of_light(c);
    }
    return light;
}

void Bands::add(const std::string& name, const std::vector<lutlib::RgbD>& srgb,
                const std::vector<std::string>& labels, const std::vector<std::string>& texts) {
    constexpr double thick = 1, apart = 0.12, text_room = 0.5;
    const double name_room = names_above_ ? text_room : figure_.cells.empty() ? 0 : apart;
    const double top = below_ - name_room, bottom = top - thick;
    const auto columns = static_cast<int>(srgb.size());
    figure_.cells.push_back({name, 0, 1, bottom, top, columns, 1, srgb, labels});
    if (names_above_) {
        figure_.notes.push_back(
            {0.5, top + text_room / 2, plot::text_cut_in_the_middle(name, most_letters)});
    } else {
        figure_.y.ticks.push_back({bottom + thick / 2, name});
    }
    for (std::size_t i = 0; i < texts.size(); ++i) {
        figure_.notes.push_back(
            {(static_cast<double>(i) + 0.5) / columns, bottom - text_room / 2, texts[i]});
    }
    below_ = bottom - (texts.empty() ? 0 : text_room);
    figure_.y.range.add(below_);
    figure_.y.range.add(top + (names_above_ ? text_room : 0));
}

plot::Figure Bands::figure() {
    if (figure_.y.ticks.empty()) {
        figure_.y.ticks.push_back({0, ""}); // names stand elsewhere, and there are no numbers
    }
    return std::move(figure_);
}

} // namespace converter
