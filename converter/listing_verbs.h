// Verbs that list what there is.
#pragma once

#include "converter/command.h"

namespace converter {

Run declare_formats(Verb& verb);
Run declare_operators(Verb& verb);

} // namespace converter
