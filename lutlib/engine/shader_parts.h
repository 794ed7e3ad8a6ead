// What shader code is put together from: the words of each language, and lookups between nodes.
#pragma once

#include "lutlib/engine/shader_code.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace lutlib {

/// What differs between the languages. In code, $3 is a vector of three floats, $i2 and $i3 vectors
/// of integers, $const begins a constant, $inline a function, $p and $a hand a texture on, and $at
/// is where to fetch.
struct ShaderWords {
    ShaderDialect kind;
    std::string_view vec3, ivec2, ivec3, constant, function, parameter, argument;
    /// Around the values of an array of $count of a $type.
    std::string_view list, list_end;
    std::string_view begins;   ///< of every file
    std::string_view declares; ///< the texture
    std::string_view fetch, ends;
};
const ShaderWords& words_of(const ShaderLanguage& language);

/// From `place`, in units of nodes, and LUT_SIZE to `found`, by lut_node($an).
std::string_view interpolation_code(Interpolation kind);

/// Each first by its second, in the order given.
void replace_words(std::string& code,
                   std::span<const std::pair<std::string_view, std::string>> words);

/// The words that need no picture: $const, $inline, $i2, $i3, $3.
void replace_common_words(std::string& code, const ShaderWords& words);

/// Lines of a comment, no longer than a page is wide.
std::string shader_comment(const std::string& words);
/// A line of it that is to be copied.
std::string shader_command(const std::string& words);

/// The row for which a condition holds; a logic_error where there is none.
template <class Rows, class Condition>
const auto& row_where(const Rows& rows, Condition condition, const char* what) {
    const auto* const row = std::find_if(rows.begin(), rows.end(), condition);
    if (row == rows.end()) {
        throw std::logic_error(std::string("no shader code for this ") + what);
    }
    return *row;
}

} // namespace lutlib
