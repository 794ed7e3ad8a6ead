// What a compiled shader expects of the pass that runs it, read from its SPIR-V by SPIRV-Cross.
#pragma once

#include "preview/gpu/shaders.h"
#include "preview/gpu/types.h"

#include <cstdint>
#include <map>
#include <set>

namespace preview {

struct ShaderBinding {
    BindingType type = BindingType::none;
    // Of images.
    bool volume = false, array = false, integer = false;
    friend bool operator==(const ShaderBinding&, const ShaderBinding&) = default;
};

struct ShaderInterface {
    std::map<std::uint32_t, ShaderBinding> bindings; ///< by number; all of set 0
    std::set<std::uint32_t> constants;               ///< ids of specialisation constants
    std::uint32_t push_bytes = 0;
};

/// Throws std::runtime_error for a descriptor outside of set 0, and for two at one number.
ShaderInterface interface_of(const gpu::ShaderCode& shader);

} // namespace preview
