// A report's figures for programs.
#pragma once

#include "preview/report/report.h"

#include <string>

namespace preview::report {

/// Every figure of the page.
std::string to_json(const RendererReport& report);
/// Its rows, a line each under a line of names.
std::string to_csv(const RendererReport& report);

} // namespace preview::report
