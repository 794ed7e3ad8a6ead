#include "preview/report/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace preview::report {

namespace {

using Number = std::optional<double>;

constexpr std::array<RowMetric, 14> metric_rows{{
    {"pass L2", [](const Row& r) { return r.pass ? Number(r.pass->relative_l2) : Number(); }},
    {"picture L2", [](const Row& r) { return Number(r.picture.relative_l2); }},
    {"dE2000 mean", [](const Row& r) { return Number(r.picture.delta_e_2000.mean); }},
    {"dE2000 p99", [](const Row& r) { return Number(r.picture.delta_e_2000.p99); }},
    {"dE2000 max", [](const Row& r) { return Number(r.picture.delta_e_2000.max); }},
    {"dE-ITP mean", [](const Row& r) { return Number(r.picture.delta_e_itp.mean); }, false},
    {"dE-ITP p99", [](const Row& r) { return Number(r.picture.delta_e_itp.p99); }},
    {"dE-ITP max", [](const Row& r) { return Number(r.picture.delta_e_itp.max); }, false},
    {"largest code", [](const Row& r) { return Number(r.picture.largest); }, false},
    {"drift", [](const Row& r) { return r.pass ? Number(r.pass->drift) : Number(); }},
    {"asymmetry", [](const Row& r) { return r.pass ? r.pass->asymmetry : Number(); }},
    {"centroid", [](const Row& r) { return r.pass ? r.pass->centroid_shift : Number(); }},
    {"unrest", [](const Row& r) { return r.pass ? r.pass->unrest : Number(); }},
    {"ms", [](const Row& r) { return Number(1e3 * r.time.median); }},
}};

bool is_same_group(const Row& a, const Row& b) {
    return a.study == b.study && a.input == b.input && a.size == b.size;
}

double log_of(double value) {
    return std::log10(std::max(value, 1e-12));
}

} // namespace

std::span<const RowMetric> row_metrics() {
    return metric_rows;
}

std::string size_text(Size size) {
    return fmt::format("{}x{}", size.width, size.height);
}

double milliseconds_of(const lutlib::Timing& time) {
    return 1e3 * time.median;
}

std::string time_label(const RendererReport& report) {
    return report.is_cpu ? "milliseconds of a CPU, no GPU's" : "GPU milliseconds";
}

const Row* usual_row(std::span<const Row> group) {
    const auto found =
        std::find_if(group.begin(), group.end(), [](const Row& row) { return row.is_usual; });
    return found == group.end() ? nullptr : &*found;
}

std::vector<std::span<const Row>> groups_of(const RendererReport& report) {
    std::vector<std::span<const Row>> out;
    const std::span<const Row> rows(report.rows);
    for (std::size_t first = 0; first < rows.size();) {
        std::size_t end = first;
        while (end < rows.size() && is_same_group(rows[end], rows[first])) {
            ++end;
        }
        out.push_back(rows.subspan(first, end - first));
        first = end;
    }
    return out;
}

const Row* knee_of(std::span<const Row> group, std::size_t first) {
    std::vector<const Row*> front;
    for (std::size_t i = 0; i < group.size(); ++i) {
        if (is_on_front(group[i], first + i)) {
            front.push_back(&group[i]);
        }
    }
    if (front.size() < 3) {
        return nullptr;
    }
    std::sort(front.begin(), front.end(),
              [](const Row* a, const Row* b) { return a->time.median < b->time.median; });
    const auto x = [](const Row* row) { return log_of(row->time.median); };
    const auto y = [](const Row* row) { return log_of(row->picture.relative_l2); };
    const Row *const start = front.front(), *const end = front.back();
    const Row* knee = nullptr;
    double deepest = 0;
    for (const Row* const row : front) {
        const double share = (x(row) - x(start)) / std::max(x(end) - x(start), 1e-12);
        const double below = std::lerp(y(start), y(end), share) - y(row);
        if (below > deepest) {
            deepest = below;
            knee = row;
        }
    }
    return knee;
}

std::string combination_text(const Choice& choice, const Combination& combination) {
    std::string out;
    for (std::size_t i = 0; i < choice.passes.size(); ++i) {
        out += fmt::format("{}{}: {}", i > 0 ? "; " : "", choice.passes[i],
                           choice.options[i][combination.options[i]].name);
    }
    return out;
}

std::string recommendation_text(const RendererReport& report) {
    if (!report.choice) {
        return "No pass that was measured has settings to choose among.";
    }
    const Choice& c = *report.choice;
    return fmt::format(
        "Take {}: {}. Measured as a whole: dE2000 {:.3g} at 99 % of the pixels (mean {:.3g}), "
        "{:.3g} ms{}; the usual settings: dE2000 {:.3g} (mean {:.3g}), {:.3g} ms.",
        combination_text(c, c.measured.predicted), c.why, c.measured.error.delta_e_2000.p99,
        c.measured.error.delta_e_2000.mean, milliseconds_of(c.measured.time),
        report.is_cpu ? " of a CPU" : "", c.usual.error.delta_e_2000.p99,
        c.usual.error.delta_e_2000.mean, milliseconds_of(c.usual.time));
}

} // namespace preview::report
