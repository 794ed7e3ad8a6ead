// Descriptors of settings: what a flag, a slider or a list has to know of a member of a struct. The
// default is the member's own initialiser.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace preview {

/// A number of the struct S.
template <class S>
struct NumberRow {
    std::string_view flag; ///< on the command line, without dashes
    std::string_view label;
    std::string_view unit = {};
    std::string_view help;
    double min = 0, max = 1;
    /// The range that a slider shows; equal: the whole.
    double slider_min = 0, slider_max = 0;
    bool is_logarithmic = false; ///< the slider
    float& (*of)(S& settings) = nullptr;

    float value(const S& settings) const {
        S copy = settings;
        return of(copy);
    }
};

/// A row that a choice offers.
struct Option {
    std::string_view name; ///< on the command line
    std::string_view text; ///< in lists
};

/// A choice among the rows of a table, in the struct S.
template <class S>
struct ChoiceRow {
    std::string_view flag;  ///< on the command line, without dashes
    std::string_view label; ///< of the list in a panel
    std::string_view kind;  ///< "tone map": what refusals call it
    std::string_view title; ///< "Tone maps": what --list calls the options
    std::string_view help;
    std::vector<Option> (*options)() = nullptr;
    /// The number of the option that is chosen; null where nobody asks.
    std::size_t (*chosen)(const S& settings) = nullptr;
    void (*choose)(S& settings, std::size_t option) = nullptr;
};

/// A row's text: its help where it has one, else its label.
template <class Row>
std::string_view text_of(const Row& row) {
    if constexpr (requires { row.help; }) {
        return row.help;
    } else {
        return row.label;
    }
}

/// The rows of a table as options.
template <class Rows>
std::vector<Option> options_of(const Rows& rows) {
    std::vector<Option> out;
    for (const auto& row : rows) {
        out.push_back({row.name, text_of(row)});
    }
    return out;
}

/// A choice that is kept as a pointer to a row of `rows()`.
template <class S, auto member, auto rows>
constexpr ChoiceRow<S> choice_of(std::string_view flag, std::string_view label,
                                 std::string_view kind, std::string_view title,
                                 std::string_view help) {
    return {.flag = flag,
            .label = label,
            .kind = kind,
            .title = title,
            .help = help,
            .options = [] { return options_of(rows()); },
            .chosen =
                [](const S& settings) {
                    return static_cast<std::size_t>(settings.*member - rows().data());
                },
            .choose = [](S& settings, std::size_t option) { settings.*member = &rows()[option]; }};
}

} // namespace preview
