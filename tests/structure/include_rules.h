// Which folder may include which, and the lines of source files that do otherwise.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace structure {

/// A part of the tree: a folder (its own files, not those of folders in it), or files of it whose
/// paths begin alike, as "preview/gpu/size.*".
struct Part {
    std::string_view name;
    /// Parts that it may include; "lutlib/*" is lutlib and every part of it. It may include itself.
    std::vector<std::string_view> uses;
    /// Beginnings of `#include <...>` that it must not reach, not even through others.
    std::vector<std::string_view> never = {};
    std::string_view with = {}; ///< another folder that belongs to it
};

/// The table. Arrows go one way: no part uses, over however many steps, one that uses it.
const std::vector<Part>& parts();

/// Source files by their paths in the repository, with '/'.
using Sources = std::map<std::string, std::string>;

/// Every .h and .cpp below the named folders of the repository.
Sources read_sources(const std::string& repository);

/// A line for each fault, as "preview/passes/x.h:5: includes ..., which preview/passes may not".
/// A fault is an #include "..." of what the table does not allow or of no file, a file of a part
/// that the table lacks, and a part's way to what it must never reach.
std::vector<std::string> faults(const std::vector<Part>& table, const Sources& sources);

/// A circle of parts as "a -> b -> a"; empty when there is none.
std::string circle_in(const std::vector<Part>& table);

} // namespace structure
