// Angles in floats, as the scenes' geometry has them.
#pragma once

#include <numbers>

namespace preview {

inline constexpr float pi = std::numbers::pi_v<float>;

} // namespace preview
