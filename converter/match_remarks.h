// What a person should know of a learnt look besides its figures.
#pragma once

#include "converter/match_run.h"

#include <string>
#include <vector>

namespace converter {

/// A sentence each: that it goes beyond AFTER's codes, that nothing was graded, that it has learnt
/// from few pixels.
std::vector<std::string> remarks_of(const Matched& matched);

} // namespace converter
