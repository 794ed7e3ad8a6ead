// What is known of a learnt look, as one page.
#pragma once

#include "converter/match_run.h"

#include <string>

namespace converter {

/// Its errors, the part of the colour cube that the pictures show, and where in them it misses.
std::string match_html(const Matched& matched, const std::string& look);

} // namespace converter
