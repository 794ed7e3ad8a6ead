// The renderer's report: for every pass what its settings cost in error and time on this device,
// the choice for a budget, what leaving out saves, and how costs grow.
#pragma once

#include "preview/report/budget.h"
#include "preview/report/glare.h"
#include "preview/report/growth.h"
#include "preview/report/leaving_out.h"
#include "preview/report/study.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace preview::report {

struct ReportSettings {
    std::vector<Size> sizes;
    /// Those that are made, and nothing else; empty: all, what leaving out saves and how costs
    /// grow.
    std::vector<const Study*> only;
    int rounds = 15;                   ///< of timings
    std::optional<double> budget;      ///< seconds a frame
    std::optional<double> max_delta_e; ///< dE2000 that 99 % of the pixels do not exceed
};

/// One variant of a pass on one input.
struct Row {
    const Study* study = nullptr;
    std::string input;
    Size size;
    std::string variant;
    bool is_usual = false, is_choice = true;
    std::optional<PassError> pass{}; ///< of variants that have the pass
    PictureError picture{};
    lutlib::Timing time{};
    std::size_t dominated_by = 0; ///< a row of the same study, input and size; itself: none
};

/// A study that this input has nothing of.
struct LeftOutStudy {
    const Study* study = nullptr;
    std::string reason;
};

struct RendererReport {
    std::string input, device, look;
    bool is_cpu = false; ///< a software device: its times are a CPU's
    ReportSettings settings;
    std::vector<Row> rows;
    std::vector<LeftOutStudy> left_out;
    GlareModel glare;
    std::optional<Choice> choice;
    std::vector<SavingRow> savings;
    std::vector<Growth> growth;
};

/// Told of what is measured next.
using Progress = std::function<void(const std::string& doing)>;

/// Everything about what `situation` shows, which is prepared as studied() says.
RendererReport make_report(const StudyTools& tools, const Situation& situation,
                           const ReportSettings& settings, const Progress& progress);

/// The rows of one study, on the input itself and where it takes them on test pictures. Adds the
/// study to `left_out` where the input has nothing of it.
std::vector<Row> rows_of(const StudyTools& tools, const Study& study, const Situation& situation,
                         const ReportSettings& settings, std::vector<LeftOutStudy>& left_out);

/// The situation as every study begins with it: in floats, every pass drawn in every frame.
Situation studied(Situation situation, Size size);

} // namespace preview::report
