// A program's man pages and its completions for bash, zsh and fish, from the descriptors that its
// help is made from.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace terminal {

/// An option's values that a shell offers; of the others it offers files.
struct OptionValues {
    std::string option; ///< "--engine"
    std::vector<std::string> values;
};

struct Papers {
    const CLI::App& app; ///< with every verb's options declared
    std::string version;
    std::vector<OptionValues> values{};
    std::vector<std::string> words{}; ///< that may stand, without verbs, where a file may
};

/// Whether the command line asks for nothing but these, as the build does: PROGRAM --write-papers
/// FOLDER.
bool asks_for_papers(int argc, const char* const* argv);

/// Files by their paths below a prefix's share/: man/man1/NAME.1 and man/man1/NAME-VERB.1,
/// bash-completion/completions/NAME, zsh/vendor-completions/_NAME,
/// fish/vendor_completions.d/NAME.fish.
using PaperFiles = std::vector<std::pair<std::string, std::string>>;
PaperFiles papers_of(const Papers& papers);

/// Writes them below `folder`. Throws lutlib::Error.
void write_papers(const Papers& papers, const std::string& folder);

} // namespace terminal
