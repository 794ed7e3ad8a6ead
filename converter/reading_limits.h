// How strangers' files are read: --no-sandbox, --max-memory and --allow-outside, of every verb that
// reads any.
#pragma once

#include "converter/verb.h"

namespace converter {

void declare_reading_limits(Verb& verb);
/// As the options say, once they are read. Says on standard error that there is no sandbox.
void apply_reading_limits();

} // namespace converter
