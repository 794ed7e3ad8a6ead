// What people call engines.
#pragma once

#include "lutlib/engine/engine.h"

#include <span>
#include <string_view>

namespace lutlib {

/// Another name of an engine, in small letters and without what stands between words.
struct EngineAlias {
    std::string_view name;
    std::string_view engine; ///< Engine::name
};
std::span<const EngineAlias> engine_aliases();

/// The engine of a name, of its label or of an alias, in letters of any case and whatever stands
/// between words: "unreal", "UE5", "Unity URP", "three.js". Null when there is none.
const Engine* engine_called(std::string_view words);
/// The same. Throws the UsageError of no_such_name().
const Engine& require_engine(std::string_view words);

} // namespace lutlib
