// A report as one self-contained page (lutlib/plot/page.h).
#pragma once

#include "preview/report/report.h"

#include <string>

namespace preview::report {

std::string to_html(const RendererReport& report);

} // namespace preview::report
