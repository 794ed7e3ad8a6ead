// Looks in and out of files. What that loses goes to standard error.
#pragma once

#include "lutlib/io/look.h"

#include <memory>
#include <string>

namespace converter {

/// A look of any kind. Throws Error, UsageError.
lutlib::io::Look open_look(const std::string& path, const lutlib::io::LookOptions& options = {});
/// The same of bytes that have been read from `path`.
lutlib::io::Look open_look(std::string bytes, const std::string& path);

/// The look as a table, for verbs that work on one.
std::shared_ptr<const lutlib::Lut> table_of(const lutlib::io::Look& look);
std::shared_ptr<const lutlib::Lut> read_table(const std::string& path);

/// The recipe, or an empty one on top of the look as a table.
lutlib::Recipe recipe_of(const lutlib::io::Look& look);

/// Writes a LUT in the format of the path's extension, a .cube to standard output.
void write_look(const lutlib::Lut& lut, const std::string& path);

} // namespace converter
