// Completions: the verbs, then the options of the verb, then an option's values, else files.
#include "terminal/parts.h"

namespace terminal {
namespace {

std::string joined(const std::vector<std::string>& words, const char* between = " ") {
    std::string out;
    for (const std::string& word : words) {
        out += (out.empty() ? "" : between) + word;
    }
    return out;
}

std::vector<std::string> all_names(const CLI::App& app) {
    std::vector<std::string> out;
    for (const CLI::Option* const option : flags_of(app)) {
        for (const std::string& name : names_of(*option)) {
            out.push_back(name);
        }
    }
    return out;
}

std::string without(std::string text, std::string_view characters) {
    for (char& c : text) {
        c = characters.find(c) == std::string_view::npos ? c : ' ';
    }
    return text;
}

// Between the quotes of a shell, in which `apostrophe` stands for one.
std::string quoted(const std::string& text, std::string_view apostrophe) {
    std::string out = "'";
    for (const char c : text) {
        c == '\'' ? out.append(apostrophe) : out.append(1, c);
    }
    return out + "'";
}
constexpr std::string_view in_zsh = R"('\'')", in_fish = R"(\')";

bool takes_value(const CLI::Option& option) {
    return option.get_items_expected_max() > 0;
}

// A short text in which nothing but an apostrophe means something to zsh or fish.
std::string short_help(const std::string& description) {
    return without(first_line(description), "\"[]:\\`$");
}

std::string verb_names(const Papers& papers) {
    std::vector<std::string> out;
    for (const CLI::App* const verb : verbs_of(papers.app)) {
        out.push_back(verb->get_name());
    }
    return joined(out);
}

} // namespace

std::string bash_completion(const Papers& papers) {
    const std::string name = papers.app.get_name(), verbs = verb_names(papers);
    std::string out = "# bash completion for " + name + ", made from its help\n_" + name +
                      "() {\n    local current=${COMP_WORDS[COMP_CWORD]}"
                      " before=${COMP_WORDS[COMP_CWORD-1]} words=\n    COMPREPLY=()\n"
                      // --option=value is three words to bash.
                      "    if [ \"$current\" = = ]; then\n        current=\n"
                      "    elif [ \"$before\" = = ]; then\n"
                      "        before=${COMP_WORDS[COMP_CWORD-2]}\n    fi\n"
                      "    case $before in\n";
    for (const OptionValues& row : papers.values) {
        out += "    " + row.option + ")\n        COMPREPLY=($(compgen -W \"" + joined(row.values) +
               "\" -- \"$current\"))\n        return\n        ;;\n";
    }
    out += "    esac\n";
    if (!verbs.empty()) {
        out += "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n        words=\"help " + verbs + " " +
               joined(all_names(papers.app)) + "\"\n" +
               "    elif [ \"${COMP_WORDS[1]}\" = help ]; then\n        words=\"" + verbs +
               "\"\n    elif [[ $current == -* ]]; then\n        case ${COMP_WORDS[1]} in\n";
        for (const CLI::App* const verb : verbs_of(papers.app)) {
            out +=
                "        " + verb->get_name() + ") words=\"" + joined(all_names(*verb)) + "\" ;;\n";
        }
        out += "        esac\n    fi\n";
    } else {
        out += "    [[ $current == -* ]] && words=\"" + joined(all_names(papers.app)) + "\"\n";
    }
    return out +
           "    if [ -n \"$words\" ]; then\n        COMPREPLY=($(compgen -W \"$words\" -- "
           "\"$current\"))\n    else\n        compopt -o filenames 2>/dev/null\n        "
           "COMPREPLY=($(compgen -f -- \"$current\"))\n" +
           (papers.words.empty() ? ""
                                 : "        COMPREPLY+=($(compgen -W \"" + joined(papers.words) +
                                       "\" -- \"$current\"))\n") +
           "    fi\n}\ncomplete -F _" + name + " " + name + "\n";
}

namespace {

std::string zsh_arguments(const Papers& papers, const CLI::App& app, const std::string& indent) {
    std::string out = indent + "_arguments \\\n";
    for (const CLI::Option* const option : flags_of(app)) {
        for (const std::string& name : names_of(*option)) {
            const bool takes = takes_value(*option);
            // A long option's value may also stand behind "=".
            std::string spec = "*" + name + (takes && name.starts_with("--") ? "=" : "") + "[" +
                               short_help(option->get_description()) + "]";
            if (takes) {
                const auto* const values = values_of(papers, *option);
                spec += values ? ":value:(" + joined(*values) + ")" : ":value:_files";
            }
            out += indent + "    " + quoted(spec, in_zsh) + " \\\n";
        }
    }
    return out + indent +
           (papers.words.empty() ? "    '*:file:_files'\n"
                                 : "    '*:file:_alternative \"words:word:(" +
                                       joined(papers.words) + ")\" \"files:file:_files\"'\n");
}

std::string fish_options(const Papers& papers, const CLI::App& app, const std::string& when) {
    std::string out;
    for (const CLI::Option* const option : flags_of(app)) {
        out += "complete -c " + papers.app.get_name() + when;
        for (const std::string& name : option->get_lnames()) {
            out += " -l " + name;
        }
        for (const std::string& name : option->get_snames()) {
            out += " -s " + name;
        }
        if (takes_value(*option)) {
            const auto* const values = values_of(papers, *option);
            out += values ? " -x -a '" + joined(*values) + "'" : " -r -F";
        }
        out += " -d " + quoted(short_help(option->get_description()), in_fish) + "\n";
    }
    return out;
}

} // namespace

std::string zsh_completion(const Papers& papers) {
    const std::string name = papers.app.get_name();
    std::string out = "#compdef " + name + "\n# zsh completion, made from the program's help\n";
    if (verbs_of(papers.app).empty()) {
        return out + zsh_arguments(papers, papers.app, "");
    }
    out += "local -a verbs=(\n    'help:Show what a verb does'\n";
    for (const CLI::App* const verb : verbs_of(papers.app)) {
        out += "    " +
               quoted(verb->get_name() + ":" + short_help(verb->get_description()), in_zsh) + "\n";
    }
    out += ")\nif (( CURRENT == 2 )); then\n    _describe verb verbs\n    return\nfi\n"
           "case $words[2] in\nhelp) _describe verb verbs ;;\n";
    for (const CLI::App* const verb : verbs_of(papers.app)) {
        out += verb->get_name() + ")\n    shift words\n    (( CURRENT-- ))\n" +
               zsh_arguments(papers, *verb, "    ") + "    ;;\n";
    }
    return out + "esac\n";
}

std::string fish_completion(const Papers& papers) {
    const std::string name = papers.app.get_name(), verbs = verb_names(papers);
    std::string out = "# fish completion for " + name + ", made from its help\n";
    if (verbs.empty()) {
        return out + fish_options(papers, papers.app, "") +
               (papers.words.empty()
                    ? ""
                    : "complete -c " + name + " -a '" + joined(papers.words) + "'\n");
    }
    const std::string first = " -n 'not __fish_seen_subcommand_from help " + verbs + "'";
    out += "complete -c " + name + first + " -f -a help -d 'Show what a verb does'\n";
    for (const CLI::App* const verb : verbs_of(papers.app)) {
        out += "complete -c " + name + first + " -f -a " + verb->get_name() + " -d " +
               quoted(short_help(verb->get_description()), in_fish) + "\n";
    }
    out += "complete -c " + name + " -n '__fish_seen_subcommand_from help' -f -a '" + verbs + "'\n";
    for (const CLI::App* const verb : verbs_of(papers.app)) {
        out += fish_options(papers, *verb,
                            " -n '__fish_seen_subcommand_from " + verb->get_name() + "'");
    }
    return out;
}

} // namespace terminal
