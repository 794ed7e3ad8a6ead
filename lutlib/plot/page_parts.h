// What every page carries: its rules and its script.
#pragma once

#include <string>

namespace plot {

std::string page_style();
std::string page_script();

} // namespace plot
