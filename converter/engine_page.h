// A page of an engine for people: what it wants, how to import it, how to check it, its shader.
#pragma once

#include "lutlib/engine/engine.h"

#include <span>
#include <string>

namespace converter {

/// "16 to 65", "8 or 16".
std::string list_of(std::span<const int> values);
/// The sizes that the engine takes, in words.
std::string sizes_of(const lutlib::Engine& engine);

/// Markdown, made from the engine's row alone; docs/engines/NAME.md is this text.
std::string engine_page(const lutlib::Engine& engine);

} // namespace converter
