// What a verb of lutconv is, and the table of them.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <functional>
#include <span>
#include <string_view>

namespace converter {

enum ExitCode : int { ok = 0, verification_failed = 1, bad_input = 2, bad_usage = 3 };

/// Runs a parsed verb and returns an ExitCode. Throws lutlib::Error.
using Run = std::function<int()>;

struct Command {
    std::string_view name;
    std::string_view help;
    /// Declares the verb's options on its own sub-command; the returned function runs it.
    Run (*declare)(CLI::App& app);
    bool reads_looks = true; ///< and so takes --layout
};

/// Every verb, in the order of the help.
std::span<const Command> commands();

Run declare_apply(CLI::App& app);
Run declare_bake(CLI::App& app);
Run declare_blend(CLI::App& app);
Run declare_compare(CLI::App& app);
Run declare_compose(CLI::App& app);
Run declare_check(CLI::App& app);
Run declare_convert(CLI::App& app);
Run declare_edit(CLI::App& app);
Run declare_encodings(CLI::App& app);
Run declare_engines(CLI::App& app);
Run declare_eval(CLI::App& app);
Run declare_identity(CLI::App& app);
Run declare_info(CLI::App& app);
Run declare_invert(CLI::App& app);
Run declare_report(CLI::App& app);
Run declare_resample(CLI::App& app);
Run declare_verify(CLI::App& app);

} // namespace converter
