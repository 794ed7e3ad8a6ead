// Rows of descriptor tables and the names by which people ask for them. A row has a member `name`;
// a table is any range of rows or of pointers to rows that outlives the call.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace lutlib {

enum class Letters { exact, any_case };

/// Whether two names are equal; any_case takes ASCII letters for equal to their capitals.
constexpr bool same_name(std::string_view a, std::string_view b, Letters letters = Letters::exact) {
    const auto capital = [](char c) { return c >= 'a' && c <= 'z' ? c - 'a' + 'A' : +c; };
    return letters == Letters::exact ? a == b : std::ranges::equal(a, b, {}, capital, capital);
}

/// What is said beside a name that is none of these: "there are piccolo, unreal", or "did you mean
/// unreal? There are piccolo, unreal" where two edits (one, of names of up to three letters) make a
/// name of what was asked for. After a hundred names: "and 30 more".
std::string what_there_is(std::string_view name, std::span<const std::string_view> names);
/// "there is no engine 'unrael'; " and the above. `kind` is the singular of what the rows are.
std::string no_such_name(std::string_view kind, std::string_view name,
                         std::span<const std::string_view> names);
/// Throws no_such_name() as a UsageError.
[[noreturn]] void refuse_name(std::string_view kind, std::string_view name,
                              std::span<const std::string_view> names);

/// "a, b, c".
std::string listed(std::span<const std::string_view> names);

/// A row, of a table of rows or of pointers to them.
template <class Entry>
constexpr const auto& row_of(const Entry& entry) {
    if constexpr (std::is_pointer_v<Entry>) {
        return *entry;
    } else {
        return entry;
    }
}

template <std::ranges::input_range Rows>
std::vector<std::string_view> name_list(const Rows& rows) {
    std::vector<std::string_view> out;
    for (const auto& entry : rows) {
        out.emplace_back(row_of(entry).name);
    }
    return out;
}

/// The names of all rows: "a, b, c".
template <std::ranges::input_range Rows>
std::string names_of(const Rows& rows) {
    return listed(name_list(rows));
}

/// A pointer to the row of this name, null when there is none.
template <std::ranges::input_range Rows>
constexpr auto find_named(const Rows& rows, std::string_view name, Letters letters = Letters::exact)
    -> decltype(&row_of(*std::ranges::begin(rows))) {
    for (const auto& entry : rows) {
        if (same_name(row_of(entry).name, name, letters)) {
            return &row_of(entry);
        }
    }
    return nullptr;
}

/// The row of this name in a table that the compiler knows; a program that asks for another is
/// none.
template <class Row, std::size_t count>
consteval const Row& row_named(const std::array<Row, count>& rows, std::string_view name) {
    const Row* const row = find_named(rows, name);
    return row ? *row : throw "there is no row of this name";
}

/// The row of this name. Throws the UsageError of no_such_name() when there is none.
template <std::ranges::input_range Rows>
const auto& require_named(const Rows& rows, std::string_view kind, std::string_view name,
                          Letters letters = Letters::exact) {
    const auto* const row = find_named(rows, name, letters);
    if (!row) {
        refuse_name(kind, name, name_list(rows));
    }
    return *row;
}

} // namespace lutlib
