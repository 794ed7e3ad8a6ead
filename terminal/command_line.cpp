#include "terminal/command_line.h"

#include "lutlib/closest_name.h"
#include "lutlib/error.h"
#include "terminal/parts.h"
#include "terminal/table.h"

#include <algorithm>
#include <sstream>
#include <unistd.h>

namespace terminal {
namespace {

// CLI11 looks at options in the order of their declaration.
void run_as_typed(const CLI::App& app) {
    for (CLI::Option* const option : app.parse_order()) {
        option->run_callback();
    }
    for (const CLI::App* const verb : app.get_subcommands()) {
        run_as_typed(*verb);
    }
}

const CLI::App& verb_of(const CLI::App& app) {
    const std::vector<CLI::App*> verbs = app.get_subcommands();
    return verbs.empty() ? app : *verbs.front();
}

std::string told(const std::vector<std::string>& words) {
    std::string out = "this was not expected:";
    for (const std::string& word : words) {
        out += " " + word;
    }
    return out;
}

bool is_like_option(const std::string& word) {
    return word.size() > 2 && word.starts_with("--");
}

std::string no_such_option(const CLI::App& app, const std::string& word) {
    const std::string option = word.substr(0, word.find('='));
    std::vector<std::string> names;
    for (const CLI::Option* const known : flags_of(verb_of(app))) {
        for (const std::string& name : names_of(*known)) {
            names.push_back(name);
        }
    }
    const std::vector<std::string_view> all(names.begin(), names.end());
    const std::string_view meant = lutlib::closest_name(option, all);
    return "there is no option '" + option + "'" +
           (meant.empty() ? "" : "; did you mean " + std::string(meant) + "?");
}

std::string where_to_look(const CLI::App& app) {
    const CLI::App& verb = verb_of(app);
    const std::string name = app.get_name();
    return "'" + (&verb == &app ? name + " --help" : name + " help " + verb.get_name()) +
           "' shows what there is";
}

[[noreturn]] void refuse(const CLI::App& app, const std::string& what) {
    throw lutlib::UsageError(what + (what.ends_with('?') ? " " : "; ") + where_to_look(app));
}

} // namespace

bool is_word_of(std::string_view word, int argc, const char* const* argv) {
    return std::find(argv, argv + argc, word) != argv + argc;
}

std::optional<std::string> parse(CLI::App& app, int argc, const char* const* argv) {
    try {
        try {
            app.parse(argc, argv);
            return std::nullopt;
        } catch (const CLI::Success&) {
            throw;
        } catch (const CLI::ParseError&) {
            run_as_typed(app);
            throw;
        } catch (const lutlib::UsageError&) {
            run_as_typed(app);
            throw;
        }
    } catch (const CLI::Success& asked) {
        std::ostringstream words;
        app.exit(asked, words, words);
        std::string out = words.str();
        while (out.ends_with("\n\n")) {
            out.pop_back();
        }
        const std::size_t columns = columns_of(STDOUT_FILENO);
        return columns > 0 ? wrapped_help(out, columns) : out;
    } catch (const CLI::ParseError& error) {
        const std::vector<std::string> more = app.remaining(true);
        const bool is_extra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
        // What is required may be missing because its name was misspelled.
        const bool may_be_misspelled =
            is_extra || dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
        const auto option = std::find_if(more.begin(), more.end(), is_like_option);
        refuse(app, may_be_misspelled && option != more.end() ? no_such_option(app, *option)
                    : is_extra                                ? told(more)
                                                              : error.what());
    }
}

} // namespace terminal
