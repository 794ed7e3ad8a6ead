// Descriptors of settings: what a flag, a slider or a list has to know of a member of a struct. The
// default is the member's own initialiser. Plain: any folder may have such rows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace preview {

/// One thing that a setting may need; setting_needs.h has their names.
enum class Need : std::uint8_t;

/// What a setting needs of a run so as to change something in it. Without a default: each row says
/// it, or that there is no such thing.
class Needs {
  public:
    constexpr Needs(Need need) : bits_(bit(need)) {}
    /// Of what changes something in every run.
    static constexpr Needs nothing() { return Needs(std::uint64_t{0}); }
    constexpr bool has(Need need) const { return (bits_ & bit(need)) != 0; }
    constexpr Needs operator|(Needs other) const { return Needs(bits_ | other.bits_); }
    friend constexpr bool operator==(Needs, Needs) = default;

  private:
    explicit constexpr Needs(std::uint64_t bits) : bits_(bits) {}
    static constexpr std::uint64_t bit(Need need) {
        return std::uint64_t{1} << static_cast<unsigned>(need);
    }
    std::uint64_t bits_;
};
constexpr Needs operator|(Need a, Needs b) {
    return Needs(a) | b;
}

/// A number of the struct S.
template <class S>
struct NumberRow {
    std::string_view flag; ///< on the command line, without dashes
    std::string_view label;
    std::string_view unit = {};
    std::string_view help;
    Needs needs;
    double min = 0, max = 1;
    /// The range that a slider shows; equal: the whole.
    double slider_min = 0, slider_max = 0;
    bool is_logarithmic = false; ///< the slider
    float& (*of)(S& settings) = nullptr;
    /// What a negative value stands for, where it does, and how people call that.
    float (*own)(const S& settings) = nullptr;
    std::string_view own_name = {};

    bool is_own(const S& settings) const { return own != nullptr && set_value(settings) < 0; }
    /// With what a negative value stands for.
    float value(const S& settings) const {
        return is_own(settings) ? own(settings) : set_value(settings);
    }

  private:
    float set_value(S settings) const { return of(settings); }
};

/// A switch of the struct S.
template <class S>
struct SwitchRow {
    std::string_view flag; ///< on the command line, without dashes
    std::string_view label;
    std::string_view help;
    Needs needs;
    bool& (*of)(S& settings) = nullptr;
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
    Needs needs;
    std::vector<Option> (*options)() = nullptr;
    /// The number of the option that is chosen; null where nobody asks.
    std::size_t (*chosen)(const S& settings) = nullptr;
    void (*choose)(S& settings, std::size_t option) = nullptr;
};

/// The row of that flag, which must be there.
template <class Row>
const Row& row_of(std::span<const Row> rows, std::string_view flag) {
    return *std::find_if(rows.begin(), rows.end(),
                         [&](const Row& row) { return row.flag == flag; });
}

/// "0.04", or "the method's own (0.04)" for one that stands for that.
std::string number_text(float value, std::string_view own_name);

/// A line for each number: "setting   exposure 0 stops".
template <class S>
std::string settings_lines(std::span<const NumberRow<S>> rows, const S& settings) {
    std::string out;
    for (const NumberRow<S>& row : rows) {
        const std::string_view own_name = row.is_own(settings) ? row.own_name : std::string_view();
        out += "setting   " + std::string(row.flag) + " " +
               number_text(row.value(settings), own_name) + (row.unit.empty() ? "" : " ") +
               std::string(row.unit) + "\n";
    }
    return out;
}

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
                                 std::string_view help, Needs needs) {
    return {.flag = flag,
            .label = label,
            .kind = kind,
            .title = title,
            .help = help,
            .needs = needs,
            .options = [] { return options_of(rows()); },
            .chosen =
                [](const S& settings) {
                    return static_cast<std::size_t>(settings.*member - rows().data());
                },
            .choose = [](S& settings, std::size_t option) { settings.*member = &rows()[option]; }};
}

} // namespace preview
