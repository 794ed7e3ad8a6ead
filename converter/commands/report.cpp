// lutconv report: what every way of keeping a look costs in error, time and bytes.
#include "converter/report.h"
#include "converter/command.h"
#include "converter/look_files.h"
#include "converter/recipe_options.h"
#include "converter/stiff_page.h"
#include "converter/survey_page.h"
#include "converter/unused.h"
#include "converter/usage.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/named.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace converter {
namespace {

namespace io = lutlib::io;

constexpr std::array<std::string_view, 1> suites{"stiff"};

struct ReportOptions {
    std::string input, suite, output, json, csv, input_encoding, output_encoding, gpu_times;
    std::vector<int> sizes;
    double promise = 1;
    bool unclamped = false;
};

// A bar on a terminal; nothing where standard error is a file.
class ProgressBar {
  public:
    ~ProgressBar() {
        if (drawn_) {
            std::fputs("\r\033[K", stderr);
        }
    }

    void draw(double share, const std::string& doing) {
        const int percent = static_cast<int>(100 * share);
        if (!terminal_ || (percent == percent_ && doing == doing_)) {
            return;
        }
        percent_ = percent;
        doing_ = doing;
        drawn_ = true;
        constexpr int width = 32;
        const auto full = static_cast<std::size_t>(width * share);
        std::fputs(
            fmt::format("\r[{:<{}}] {:3} % {}\033[K", std::string(full, '#'), width, percent, doing)
                .c_str(),
            stderr);
        std::fflush(stderr);
    }

  private:
    const bool terminal_ = isatty(STDERR_FILENO) != 0;
    bool drawn_ = false;
    int percent_ = -1;
    std::string doing_;
};

struct Report {
    std::string html, csv, words;
    nlohmann::ordered_json json;
};

Report report_on_look(const ReportOptions& o) {
    lutlib::Recipe recipe = recipe_of(open_look(o.input));
    if (!o.input_encoding.empty()) {
        recipe.input = encoding_of(o.input_encoding, "--input-encoding");
    }
    if (!o.output_encoding.empty()) {
        recipe.output = encoding_of(o.output_encoding, "--output-encoding");
    }
    ProgressBar bar;
    lutlib::SurveySettings settings;
    settings.promise = o.promise;
    settings.unclamped = o.unclamped;
    if (!o.sizes.empty()) {
        settings.sizes = o.sizes;
        settings.own_size = false;
    }
    const lutlib::Survey survey = lutlib::survey(
        recipe, settings, [&](double share, const std::string& doing) { bar.draw(share, doing); });
    const std::string name = std::filesystem::path(io::input_name(o.input)).filename().string();
    std::optional<GpuTimes> gpu;
    if (!o.gpu_times.empty()) {
        gpu = read_gpu_times(o.gpu_times, survey);
    }
    return {survey_html(survey, name, gpu), survey_csv(survey),
            fmt::format("{} combinations\n{}\n", survey.rows.size(), recommendation_text(survey)),
            survey_json(survey, name, gpu)};
}

Report report_on_suite(const ReportOptions& o) {
    ProgressBar bar;
    lutlib::StiffSettings settings;
    if (!o.sizes.empty()) {
        settings.sizes = o.sizes;
        std::sort(settings.sizes.begin(), settings.sizes.end());
    }
    const lutlib::StiffSurvey survey = lutlib::survey_stiff_suite(
        settings, [&](double share, const std::string& doing) { bar.draw(share, doing); });
    return {stiff_html(survey), stiff_csv(survey), fmt::format("{} curves\n", survey.curves.size()),
            stiff_json(survey)};
}

int run_report(const ReportOptions& o, const Verb& verb) {
    if (o.input.empty() == o.suite.empty()) {
        throw lutlib::UsageError("report takes either a look or --suite " + lutlib::listed(suites));
    }
    if (!o.suite.empty() && o.suite != suites.front()) {
        lutlib::refuse_name("suite", o.suite, suites);
    }
    const std::string shown = standard_output_of(std::array{o.output, o.json, o.csv});
    const bool of_look = o.suite.empty();
    const std::string why_not = "it is about a look, and the suite has no look";
    tell_unused(verb, {{"--max-delta-e", of_look, why_not},
                       {"--input-encoding", of_look, why_not},
                       {"--output-encoding", of_look, why_not},
                       {"--gpu-times", of_look, why_not},
                       {"--unclamped", of_look, why_not}});
    const Report report = o.suite.empty() ? report_on_look(o) : report_on_suite(o);
    nlohmann::ordered_json made{{"made_by", "lutconv"}};
    made.update(report.json);
    const std::string figures = json_text(made);
    std::vector<io::FileToWrite> files{{o.output, report.html}};
    if (!o.json.empty()) {
        files.push_back({o.json, figures});
    }
    if (!o.csv.empty()) {
        files.push_back({o.csv, report.csv});
    }
    io::write_files(files);
    print(report.words, shown);
    return ok;
}

} // namespace

Run declare_report(Verb& verb) {
    const auto o = std::make_shared<ReportOptions>();
    verb.add_option("LOOK", o->input, "a LUT or recipe file, or - for standard input");
    verb.add_option("--suite", o->suite,
                    "instead of a look: stiff, functions that are hard for lattices");
    verb.add_output("-o,--output", o->output, "the HTML page, or - for standard output").required();
    verb.add_output("--json", o->json, "every figure as JSON, into this file");
    verb.add_output("--csv", o->csv, "every figure as CSV, into this file");
    verb.add_option(
            "--sizes", o->sizes,
            "only these lattice sizes (default: of a look 8 16 17 25 32 33 49 64 65 and the one "
            "it is baked to, of the suite 8 12 16 24 33 48 65)")
        .takes(Takes::cube_size);
    verb.add_option("--max-delta-e", o->promise, "largest dE2000 that the recommendation may have")
        .takes(Takes::above_zero)
        .capture_default_str();
    verb.add_option("--input-encoding", o->input_encoding,
                    encoding_help("what the look's input is"));
    verb.add_option("--output-encoding", o->output_encoding, "what its results are encoded in");
    verb.add_option("--gpu-times", o->gpu_times,
                    "a file of what preview_bench --json prints: its lookups' times on a GPU too");
    verb.add_flag("--unclamped", o->unclamped,
                  "where displays take the output: errors of what lies outside 0..1 too, which no "
                  "display shows (for looks whose output goes on being worked on)");
    return [o, &verb] { return run_report(*o, verb); };
}

} // namespace converter
