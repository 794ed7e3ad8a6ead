// Rows of colours below each other: before a look, and after.
#pragma once

#include "converter/panels/panel.h"

namespace converter {

/// Linear Rec.709 light as codes of a look's input.
std::vector<lutlib::RgbD> codes_of_light(const ShownLook& look, std::vector<lutlib::RgbD> light);
/// The sRGB codes that show code values, or linear Rec.709 light.
std::vector<lutlib::RgbD> in_srgb(std::vector<lutlib::RgbD> codes,
                                  const lutlib::Encoding& encoding);
std::vector<lutlib::RgbD> shown_srgb(std::vector<lutlib::RgbD> light);

/// A figure of bands, the first on top, from 0 to 1 each.
class Bands {
  public:
    /// Names stand beside the bands, or above them.
    Bands(const std::string& title, bool names_above) : names_above_(names_above) {
        figure_.title = title;
    }
    /// sRGB codes; `texts`, a note below each, are as many or none.
    void add(const std::string& name, const std::vector<lutlib::RgbD>& srgb,
             const std::vector<std::string>& labels = {},
             const std::vector<std::string>& texts = {});
    plot::Figure figure();

  private:
    static constexpr std::size_t most_letters = 40;

    plot::Figure figure_;
    bool names_above_;
    double below_ = 0; ///< how far down the last one ends
};

} // namespace converter
