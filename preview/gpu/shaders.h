// The shaders that the build compiled, checked and embedded, by file name ("tonemap.comp").
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace preview::gpu {

struct ShaderCode {
    std::string_view name;
    std::span<const std::uint32_t> words;
};

/// Every embedded shader; defined in a file that the build writes.
std::span<const ShaderCode> shaders();

} // namespace preview::gpu
