// An engine's lookup as shader code, made from the engine's row: a function that takes a colour and
// fetches texels of the engine's LUT picture.
#pragma once

#include "lutlib/engine/engine.h"
#include "lutlib/interpolation/interpolation.h"

#include <span>
#include <string>
#include <string_view>

namespace lutlib {

enum class ShaderDialect { glsl, hlsl, metal, godot, reshade };

struct ShaderLanguage {
    ShaderDialect kind;
    std::string_view name;
    std::string_view label;
    std::string_view file; ///< what a file of it is usually called
    /// What is known of the code: who compiles and runs it in the tests, or that nobody does.
    std::string_view trial;
};
std::span<const ShaderLanguage> shader_languages();

struct ShaderRequest {
    const Engine& engine;
    const ShaderLanguage& language;
    int size;                    ///< nodes per axis; the engine's layout must have such a picture
    Interpolation interpolation; ///< between the nodes
};

/// The text of a file with the function lut_lookup, which maps codes to codes as
/// LatticeReader of reader_of() does, that of an engine that filters light among them: inputs are
/// held to 0..1, NaN and -Inf read as 0. Texels are fetched, unfiltered, so that no sampler has a
/// part in it. Comments say which picture it reads and how that must be loaded.
std::string shader_code(const ShaderRequest& request);

} // namespace lutlib
