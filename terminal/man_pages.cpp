// Man pages, in the macros of man(7).
#include "terminal/parts.h"

#include <algorithm>

namespace terminal {
namespace {

std::string roff(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '\\') {
            out += "\\e";
        } else if (c == '-') {
            out += "\\-";
        } else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) {
            out += std::string("\\&") + c;
        } else {
            out += c;
        }
    }
    return out;
}

std::string bold(const std::string& text) {
    return "\\fB" + roff(text) + "\\fR";
}

std::string capitals(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](char c) {
        return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    return text;
}

// "--size, -s INT".
std::string heading_of(const CLI::Option& option) {
    std::string out;
    for (const std::string& name : names_of(option)) {
        out += (out.empty() ? "" : ", ") + bold(name);
    }
    if (option.get_items_expected_max() > 0 && !option.get_type_name().empty()) {
        out += " \\fI" + roff(option.get_type_name()) + "\\fR";
    }
    return out;
}

std::string synopsis(const CLI::App& app, const std::string& command) {
    std::string out = ".SH SYNOPSIS\n" + bold(command);
    for (const CLI::Option* const option : app.get_options()) {
        if (option->get_positional()) {
            const std::string name = "\\fI" + roff(option->get_name(true)) + "\\fR";
            out += option->get_required() ? " " + name : " [" + name + "]";
        } else if (option->get_required()) {
            out += " " + bold(names_of(*option).front()) + " \\fI" + roff(option->get_type_name()) +
                   "\\fR";
        }
    }
    if (!verbs_of(app).empty()) {
        out += " \\fIverb\\fR";
    }
    return out + " [options]\n";
}

std::string options_text(const CLI::App& app) {
    std::string out;
    for (const CLI::Option* const option : app.get_options()) {
        if (option->get_positional()) {
            out += ".TP\n\\fI" + roff(option->get_name(true)) + "\\fR\n" +
                   roff(option->get_description()) + "\n";
        }
    }
    out = out.empty() ? out : ".SH ARGUMENTS\n" + out;
    for (const std::string& group : app.get_groups()) {
        std::string rows;
        for (const CLI::Option* const option : flags_of(app)) {
            if (option->get_group() == group) {
                rows +=
                    ".TP\n" + heading_of(*option) + "\n" + roff(option->get_description()) + "\n";
            }
        }
        out += rows.empty() ? rows : ".SH \"" + roff(capitals(group)) + "\"\n" + rows;
    }
    return out;
}

std::string verbs_text(const CLI::App& app) {
    std::string out;
    for (const CLI::App* const verb : verbs_of(app)) {
        out += ".TP\n" + bold(verb->get_name()) + "\n" + roff(first_line(verb->get_description())) +
               "; see " + bold(app.get_name() + "-" + verb->get_name()) + "(1)\n";
    }
    return out.empty() ? out : ".SH VERBS\n" + out;
}

} // namespace

std::string man_page(const Papers& papers, const CLI::App& app, const std::string& name) {
    const bool is_verb = &app != &papers.app;
    const std::string command =
        is_verb ? papers.app.get_name() + " " + app.get_name() : app.get_name();
    std::string out = ".TH " + roff(capitals(name)) + " 1 \"\" \"" + papers.app.get_name() + " " +
                      papers.version + "\"\n.SH NAME\n" + roff(name) + " \\- " +
                      roff(first_line(app.get_description())) + "\n" + synopsis(app, command) +
                      ".SH DESCRIPTION\n" + roff(app.get_description()) + "\n" + verbs_text(app) +
                      options_text(app);
    if (!app.get_footer().empty()) {
        out += ".SH NOTES\n.nf\n" + roff(app.get_footer()) + "\n.fi\n";
    }
    if (is_verb) {
        out += ".SH SEE ALSO\n" + bold(papers.app.get_name()) + "(1)\n";
    }
    return out;
}

} // namespace terminal
