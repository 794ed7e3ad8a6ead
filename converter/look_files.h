// Looks in and out of files. What is lost in reading goes to standard error.
#pragma once

#include "converter/verb.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/look.h"
#include "lutlib/metrics/breaks.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace converter {

/// --layout NAME: the layout of the pictures that this run reads as looks.
void declare_layout(Verb& verb);
/// Says, once all looks are read, that one was named and none of them is a picture.
void tell_unused_layout();

inline constexpr std::string_view identity_word = "identity";
/// The look that changes nothing.
lutlib::io::Look identity_look();

/// A look of any kind. Throws Error, UsageError.
lutlib::io::Look open_look(const std::string& path, const lutlib::io::LookOptions& options = {});
/// The same without a word, for who reports what was guessed and lost by itself. Several threads
/// may do so at once.
lutlib::io::Look open_quietly(const std::string& path, const lutlib::io::LookOptions& options);
/// The same; nothing for a file that is no look, as io::Look::open_if_look() says.
std::optional<lutlib::io::Look> open_if_look_quietly(const std::string& path,
                                                     const lutlib::io::LookOptions& options);
/// The same of bytes that have been read from `path`.
lutlib::io::Look open_look(std::string bytes, const std::string& path);

/// What was guessed in reading a look, lost and not acted on, on standard error.
void tell_of(const lutlib::io::Look& look);
/// What was guessed of a table from `path` and what of its file is not acted on, on standard error;
/// open_look() does so by itself.
void tell_of(const lutlib::Lut& table, const std::string& path);

/// The look as a table, for verbs that work on one.
std::shared_ptr<const lutlib::Lut> table_of(const lutlib::io::Look& look);
std::shared_ptr<const lutlib::Lut> read_table(const std::string& path);

/// The recipe, or an empty one on top of the look as a table.
lutlib::Recipe recipe_of(const lutlib::io::Look& look);

/// What a LUT became in a file.
struct WrittenLook {
    std::shared_ptr<const lutlib::Lut> lut; ///< the tables of the file
    std::vector<lutlib::Loss> losses;       ///< what it could not keep
    lutlib::Transform read; ///< the file, by its reader; of `lut` where nothing was lost
    lutlib::Breaks breaks;  ///< of `read`
};

/// What a file of this format and these losses holds.
WrittenLook written_as(const lutlib::FileFormat& format, lutlib::io::Encoded file);

/// Writes a LUT in the format of the path's extension, a .cube to standard output, and `others` of
/// the same run, all or none. Says on standard error who does not read the file.
WrittenLook write_look(const lutlib::Lut& lut, const std::string& path,
                       std::span<const lutlib::io::FileToWrite> others = {});

/// Says on standard error what was lost, for verbs whose report does not.
void tell_losses(const WrittenLook& written, const std::string& path);

} // namespace converter
