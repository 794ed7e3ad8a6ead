// `shader --inline`: a look itself in the code of a shader.
#pragma once

#include <string>

namespace converter {

struct InlineRequest {
    std::string look, language, output;
    double max_delta_e = 1;
};

/// Writes the smallest form that stays within the error, and says which; the answer is an ExitCode.
/// Throws UsageError; Error for a look of which none does, with the figure that would do.
int write_inline_shader(const InlineRequest& request);

} // namespace converter
