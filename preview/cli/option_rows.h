// The options of the command line as rows: what settings of the frame the tables of
// preview/finish/picture_settings.h do not have.
#pragma once

#include "preview/cli/options.h"
#include "preview/finish/setting_rows.h"

#include <span>
#include <variant>

namespace preview {

/// An option and the member that it sets; of a switch that else is as usual, "--NAME,!--no-NAME".
struct OptionRow {
    using Member =
        std::variant<bool& (*)(Options&), int& (*)(Options&), std::uint32_t& (*)(Options&),
                     float& (*)(Options&), double& (*)(Options&), std::string& (*)(Options&),
                     std::optional<bool>& (*)(Options&)>;

    const char* flag = nullptr;
    const char* help = nullptr;
    Needs needs;
    Member of;
    double min = 0, max = 0;    ///< of numbers; equal: any
    const char* type = nullptr; ///< of texts, in the help; null: TEXT
    const char* one_of[2] = {}; ///< of texts: the only values that there are
};

/// An option that may be given several times.
struct ListRow {
    const char* flag = nullptr;
    const char* help = nullptr;
    Needs needs;
    const char* type = nullptr; ///< in the help
    char between = '\0';        ///< several values at once; 0: one
    /// Adds one value. Throws lutlib::UsageError.
    void (*take)(Options& options, const std::string& text) = nullptr;
};

/// In the order of the help: those without a heading, and those under "Picture".
std::span<const OptionRow> option_rows();
std::span<const OptionRow> picture_option_rows();

/// Choices among rows of tables that no panel has.
std::span<const ChoiceRow<Options>> option_choices();

std::span<const ListRow> option_lists();

/// What people are told an option is called, of the names of a row's flag: "--engine-b".
std::string main_name(std::string_view flag);

/// An option by its main name, and what it needs.
struct OptionNeeds {
    std::string name;
    Needs needs;
};
/// Of every option that any table has, in the order of the help.
std::vector<OptionNeeds> option_needs();

} // namespace preview
