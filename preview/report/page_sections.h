// Parts of a report's page between its plots and its table, as markup.
#pragma once

#include "preview/report/report.h"

#include <string>
#include <vector>

namespace preview::report {

std::vector<std::string> page_sections(const RendererReport& report);

} // namespace preview::report
