// A folder with every file that the documents' command lines read, each small and of the kind that
// its name promises.
#pragma once

#include <filesystem>
#include <string>

namespace docs_test {

/// Fills an empty folder: luts/ as in the repository, and looks, strips, pictures and a model.
void fill_workplace(const std::filesystem::path& folder);

struct Ran {
    int exit_code = -1;
    std::string output; ///< standard output, then standard error
};

/// Runs a line of a shell there, with our programs before all others on the PATH.
Ran run_in(const std::filesystem::path& folder, const std::string& line);

} // namespace docs_test
