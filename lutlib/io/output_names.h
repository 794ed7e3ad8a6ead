// The names of new files, made of those that they come from: `out/{name}.{ext}`.
#pragma once

#include "lutlib/io/inputs.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lutlib::io {

/// A field of a template and what stands for it, beside those that every input gives.
using NameField = std::pair<std::string_view, std::string>;

/// The fields that every input gives: {name}, its file's name without the extension; {ext}, its
/// extension; {frame}, the digits of its number. Other words in braces stay as they are.
class OutputTemplate {
  public:
    /// `fields` are the names of those that path_for() gets besides. A folder ("out/", or one that
    /// is there) stands for its file `in_folder`, where that is given.
    explicit OutputTemplate(std::string text, std::vector<std::string_view> fields = {},
                            const std::string& in_folder = "{name}.{ext}");

    /// Whether inputs can have outputs of different names. It has a field, or a FramePattern.
    bool varies() const { return varies_; }
    bool has(std::string_view field) const;
    const std::string& text() const { return text_; }

    /// Throws UsageError where it wants a number and the input has none.
    std::string path_for(const InputFile& input, std::span<const NameField> fields = {}) const;

  private:
    std::string text_;
    bool varies_ = false;
};

/// From a file to a file.
struct Route {
    InputFile from;
    std::string to;
};

/// Refuses outputs of one name, several to standard output among them, and an output that another
/// route reads. Throws UsageError.
void require_distinct(std::span<const Route> routes);

/// Refuses an output that is the file `input`, which messages call `what`, such as "the look".
/// Throws UsageError.
void require_another_than(const std::string& input, std::string_view what,
                          const std::string& output);

/// Refuses two names of one file, whatever each of them is. Devices and pipes take several outputs.
/// Throws UsageError.
void require_distinct(std::span<const std::string> outputs);

/// Makes the folders of the files. Throws Error.
void make_folders(std::span<const Route> routes);

/// Whether a file is there, not empty, and newer than all of these. Files are written whole or not
/// at all, so then it is done.
bool is_up_to_date(const std::string& path, std::span<const std::string> inputs);

} // namespace lutlib::io
