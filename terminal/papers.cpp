#include "terminal/papers.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "terminal/parts.h"

#include <algorithm>
#include <filesystem>

namespace terminal {

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

std::vector<const CLI::Option*> flags_of(const CLI::App& app) {
    return app.get_options([](const CLI::Option* option) {
        return !option->get_positional() && !option->get_group().empty();
    });
}

std::vector<std::string> names_of(const CLI::Option& option) {
    std::vector<std::string> out;
    for (const std::string& name : option.get_lnames()) {
        out.push_back("--" + name);
    }
    for (const std::string& name : option.get_snames()) {
        out.push_back("-" + name);
    }
    return out;
}

std::vector<const CLI::App*> verbs_of(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); });
}

const std::vector<std::string>* values_of(const Papers& papers, const CLI::Option& option) {
    const std::vector<std::string> names = names_of(option);
    for (const OptionValues& row : papers.values) {
        if (std::find(names.begin(), names.end(), row.option) != names.end()) {
            return &row.values;
        }
    }
    return nullptr;
}

bool asks_for_papers(int argc, const char* const* argv) {
    return argc == 3 && std::string_view(argv[1]) == "--write-papers";
}

PaperFiles papers_of(const Papers& papers) {
    const std::string name = papers.app.get_name();
    PaperFiles out{{"man/man1/" + name + ".1", man_page(papers, papers.app, name)},
                   {"bash-completion/completions/" + name, bash_completion(papers)},
                   {"zsh/vendor-completions/_" + name, zsh_completion(papers)},
                   {"fish/vendor_completions.d/" + name + ".fish", fish_completion(papers)}};
    for (const CLI::App* const verb : verbs_of(papers.app)) {
        const std::string page = name + "-" + verb->get_name();
        out.emplace_back("man/man1/" + page + ".1", man_page(papers, *verb, page));
    }
    return out;
}

void write_papers(const Papers& papers, const std::string& folder) {
    namespace fs = std::filesystem;
    for (const auto& [path, text] : papers_of(papers)) {
        const fs::path file = fs::path(folder) / path;
        std::error_code failed;
        fs::create_directories(file.parent_path(), failed);
        if (failed) {
            throw lutlib::Error("the folder cannot be made: " + failed.message(),
                                {file.parent_path().string(), 0, {}});
        }
        lutlib::io::write_file(file.string(), text);
    }
}

} // namespace terminal
