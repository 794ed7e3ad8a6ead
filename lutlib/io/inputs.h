// The files that a command line names: each by its path, folders of them, and sequences.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib::io {

struct InputFile {
    std::string path; ///< `-` is standard input
    /// The digits of its number, as its name has them: in the place of a pattern, else the last
    /// ones before its extension. Empty: none.
    std::string frame{};
    bool in_folder = false; ///< found in a folder that was named, not by its own name

    friend bool operator==(const InputFile&, const InputFile&) = default;
};

struct Inputs {
    std::vector<InputFile> files;
    bool are_listed = false; ///< found by a folder or a pattern, so that there could be others
    /// What was left out of folders, and which numbers a sequence lacks; a sentence each.
    std::vector<std::string> remarks{};
};

/// In the order of `words`; a folder's by name, a sequence's by number. A folder gives those of its
/// own files whose extension is `taken`; hidden ones never. A pattern (FramePattern) that is no
/// file's own name gives the files that there are, or those of `frames` (parse_frames()) whether
/// they are there or not. Throws Error for a folder or pattern without any file, UsageError for
/// `frames` without a pattern.
Inputs find_inputs(std::span<const std::string> words, const std::string& frames,
                   const std::function<bool(const std::string& extension)>& taken);

} // namespace lutlib::io
