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
    Member of;
    double min = 0, max = 0;    ///< of numbers; equal: any
    const char* type = nullptr; ///< of texts, in the help; null: TEXT
    const char* one_of[2] = {}; ///< of texts: the only values that there are
};

/// In the order of the help: those without a heading, and those under "Picture".
std::span<const OptionRow> option_rows();
std::span<const OptionRow> picture_option_rows();

/// Choices among rows of tables that no panel has.
std::span<const ChoiceRow<Options>> option_choices();

} // namespace preview
