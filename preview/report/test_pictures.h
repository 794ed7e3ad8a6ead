// Pictures of light that are hard on what follows: made by formulas, at any size, and a step of a
// slow pan later.
#pragma once

#include "preview/frame/shown.h"

#include <optional>
#include <span>
#include <string_view>

namespace preview::report {

struct TestPicture {
    std::string_view name, help;
    /// `pan`: by how many texels the camera has turned to the right.
    ShownPicture (*make)(Size size, int pan);
    /// The only texel that shines, where there is one.
    std::optional<Size> (*impulse)(Size size) = nullptr;
};

std::span<const TestPicture> test_pictures();
const TestPicture* test_picture_named(std::string_view name);

} // namespace preview::report
