#include "preview/finish/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace preview {

Size fitted(Size picture, Size box) {
    const double scale = std::min(static_cast<double>(box.width) / picture.width,
                                  static_cast<double>(box.height) / picture.height);
    const auto side = [&](std::uint32_t length, std::uint32_t most) {
        return std::clamp(static_cast<std::uint32_t>(std::lround(length * scale)), 1U, most);
    };
    return {side(picture.width, box.width), side(picture.height, box.height)};
}

std::string fit_text(Size picture, Size box) {
    if (picture == box) {
        return {};
    }
    const Size extent = fitted(picture, box);
    const char* const bars = extent.width < box.width     ? ", with bars left and right"
                             : extent.height < box.height ? ", with bars above and below"
                                                          : "";
    return fmt::format("its {}x{} pixels are shown as {}x{}, to fit into {}x{}{}{}", picture.width,
                       picture.height, extent.width, extent.height, box.width, box.height, bars,
                       *bars != 0 ? ", which figures of a difference count as equal" : "");
}

} // namespace preview
