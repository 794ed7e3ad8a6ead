// What a report tells of each row, for every form that it is told in.
#pragma once

#include "preview/report/report.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace preview::report {

struct RowMetric {
    const char* name;
    std::optional<double> (*of)(const Row& row); ///< empty: the row has none
    bool is_tabled = true;                       ///< else in JSON and CSV alone
};
std::span<const RowMetric> row_metrics();

/// "1280x720"
std::string size_text(Size size);
double milliseconds_of(const lutlib::Timing& time);

/// Of an axis: what milliseconds those are.
std::string time_label(const RendererReport& report);

/// The row whose settings are taken where nobody says otherwise; null: none of them is.
const Row* usual_row(std::span<const Row> group);

/// Rows of one study, input and size, as they stand one behind the other.
std::vector<std::span<const Row>> groups_of(const RendererReport& report);

/// Of the front of a group the row behind which more time buys least for its price: the one that
/// lies farthest below the straight line between the front's ends in logarithms. Null for a front
/// of less than three.
const Row* knee_of(std::span<const Row> group, std::size_t first);

/// Whether no other row of its group beats it. `index`: its own in the report.
inline bool is_on_front(const Row& row, std::size_t index) {
    return row.dominated_by == index;
}

/// One sentence: what to take.
std::string recommendation_text(const RendererReport& report);

/// "occlusion: 16 samples; bloom: ..."
std::string combination_text(const Choice& choice, const Combination& combination);

} // namespace preview::report
