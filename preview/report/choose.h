// A report's choice for a budget or an error, from its rows.
#pragma once

#include "preview/report/report.h"

namespace preview::report {

/// Of the input itself at the largest of the sizes. Empty where no pass has anything to choose.
std::optional<Choice> choice_of(const StudyTools& tools, const Situation& situation,
                                const ReportSettings& settings, const std::vector<Row>& rows);

} // namespace preview::report
