// What a verb of lutconv is, and the table of them.
#pragma once

#include "converter/verb.h"

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
    Run (*declare)(Verb& verb);
    bool reads_looks = true; ///< and so takes --layout
    bool is_answer = false;  ///< its text is what was asked for, so that it has no --quiet
};

/// Every verb, in the order of the help.
std::span<const Command> commands();

Run declare_apply(Verb& verb);
Run declare_bake(Verb& verb);
Run declare_blend(Verb& verb);
Run declare_compare(Verb& verb);
Run declare_compose(Verb& verb);
Run declare_check(Verb& verb);
Run declare_convert(Verb& verb);
Run declare_edit(Verb& verb);
Run declare_encodings(Verb& verb);
Run declare_engines(Verb& verb);
Run declare_eval(Verb& verb);
Run declare_extract(Verb& verb);
Run declare_formats(Verb& verb);
Run declare_identity(Verb& verb);
Run declare_info(Verb& verb);
Run declare_invert(Verb& verb);
Run declare_match(Verb& verb);
Run declare_operators(Verb& verb);
Run declare_report(Verb& verb);
Run declare_resample(Verb& verb);
Run declare_shader(Verb& verb);
Run declare_sheet(Verb& verb);
Run declare_show(Verb& verb);
Run declare_verify(Verb& verb);

} // namespace converter
