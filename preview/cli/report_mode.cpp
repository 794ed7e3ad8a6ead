#include "preview/cli/report_mode.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/look.h"
#include "lutlib/io/output_names.h"
#include "lutlib/io/terminal.h"
#include "lutlib/named.h"
#include "preview/cli/studied_input.h"
#include "preview/report/columns.h"
#include "preview/report/figures.h"
#include "preview/report/page.h"
#include "terminal/table.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>

namespace preview {

namespace {

/// Of which one is odd in both directions, so that no level of a pyramid halves evenly.
constexpr std::array<Size, 3> gpu_sizes{{{160, 90}, {321, 181}, {640, 360}}};
constexpr std::array<Size, 3> cpu_sizes{{{48, 27}, {65, 37}, {80, 45}}};
constexpr int gpu_rounds = 25, cpu_rounds = 3;
constexpr std::uint32_t least_side = 16;

/// WIDTHxHEIGHT, or several with commas between them.
std::vector<Size> sizes_of(const Options& options, bool is_cpu) {
    const auto& usual = is_cpu ? cpu_sizes : gpu_sizes;
    std::vector<Size> out(usual.begin(), usual.end());
    if (!options.size.empty()) {
        out.clear();
        for (std::size_t at = 0; at <= options.size.size();) {
            const std::size_t end = std::min(options.size.find(',', at), options.size.size());
            const Size size = parse_size("--size", options.size.substr(at, end - at));
            if (size.width < least_side || size.height < least_side) {
                throw lutlib::UsageError(
                    fmt::format("--size: a report needs at least {0}x{0} pixels", least_side));
            }
            out.push_back(size);
            at = end + 1;
        }
    }
    return out;
}

/// Those that --passes names.
std::vector<const report::Study*> passes_of(const Options& options) {
    struct Named {
        std::string_view name;
        const report::Study* study;
    };
    std::vector<Named> rows;
    for (const report::Study* const study : report::studies()) {
        rows.push_back({study->name, study});
    }
    std::vector<const report::Study*> out;
    for (std::size_t at = 0; !options.passes.empty() && at <= options.passes.size();) {
        const std::size_t end = std::min(options.passes.find(',', at), options.passes.size());
        out.push_back(
            lutlib::require_named(rows, "pass", options.passes.substr(at, end - at)).study);
        at = end + 1;
    }
    return out;
}

/// The file beside the page that has the same name with another ending.
std::string beside(const std::string& page, const char* ending) {
    return std::filesystem::path(page).replace_extension(ending).string();
}

report::StudiedLook look_of(const Options& options) {
    const std::string& path =
        options.look_b.empty() || options.look_b == "none" ? options.look_a : options.look_b;
    if (path.empty() || path == "none") {
        return report::usual_studied_look();
    }
    const auto look = lutlib::io::Look::open(path);
    return {look.title().empty() ? path : look.title(), look.table().lut, look.exact()};
}

void print_for_people(const Options& options, const report::RendererReport& made) {
    terminal::Table table;
    table.heading(report::recommendation_text(made));
    if (!options.quiet) {
        table.row({"pass", "size", "usual", "picture L2", "dE2000 p99",
                   made.is_cpu ? "CPU ms" : "ms", "knee"});
        std::size_t first = 0;
        for (const std::span<const report::Row> group : report::groups_of(made)) {
            const report::Row* const usual = report::usual_row(group);
            const report::Row* const knee = report::knee_of(group, first);
            if (usual != nullptr && usual->input == made.input) {
                table.row({std::string(usual->study->name), report::size_text(usual->size),
                           usual->variant, fmt::format("{:.3g}", usual->picture.relative_l2),
                           fmt::format("{:.3g}", usual->picture.delta_e_2000.p99),
                           fmt::format("{:.3g}", report::milliseconds_of(usual->time)),
                           knee != nullptr ? knee->variant : "-"});
            }
            first += group.size();
        }
    }
    terminal::print(table);
}

/// The page and what is asked for beside it; without a page the one thing that is asked for is
/// printed.
void write(const Options& options, const report::RendererReport& made) {
    if (options.output.empty()) {
        lutlib::io::print_out(options.json ? to_json(made) : to_csv(made));
        return;
    }
    const std::string page = to_html(made), json = options.json ? to_json(made) : "",
                      csv = options.csv ? to_csv(made) : "";
    const std::string json_path = beside(options.output, ".json"),
                      csv_path = beside(options.output, ".csv");
    std::vector<lutlib::io::FileToWrite> files{{options.output, page}};
    if (options.json) {
        files.push_back({json_path, json});
    }
    if (options.csv) {
        files.push_back({csv_path, csv});
    }
    lutlib::io::write_files(files);
    print_for_people(options, made);
}

void refuse_what_does_not_go_together(const Options& options) {
    if (options.output.empty() && options.json == options.csv) {
        throw lutlib::UsageError("report needs -o FILE for its page, or one of --json and --csv, "
                                 "which it then prints");
    }
    if (options.output == lutlib::io::standard_stream) {
        throw lutlib::UsageError("report writes its page into a file: name one with -o");
    }
    const std::string ending = lutlib::io::extension_of(options.output);
    if ((options.json && ending == "json") || (options.csv && ending == "csv")) {
        throw lutlib::UsageError("-o names the page, beside which --json and --csv write files of "
                                 "its name: let it end in .html");
    }
    if (options.budget_ms > 0 && options.max_delta_e > 0) {
        throw lutlib::UsageError(
            "--budget-ms and --max-delta-e both say what the choice must keep: "
            "drop one of them");
    }
}

} // namespace

bool report_renderer(const Options& options) {
    refuse_what_does_not_go_together(options);
    gpu::DeviceOptions wanted;
    wanted.wanted = options.device;
    wanted.validation = options.validate;
    const gpu::Device device(wanted);
    report::Renderer renderer(device);
    const report::StudyTools tools{renderer, look_of(options)};
    report::ReportSettings settings;
    settings.sizes = sizes_of(options, renderer.is_cpu());
    settings.only = passes_of(options);
    settings.rounds = renderer.is_cpu() ? cpu_rounds : gpu_rounds;
    if (options.budget_ms > 0) {
        settings.budget = options.budget_ms * 1e-3;
    }
    if (options.max_delta_e > 0) {
        settings.max_delta_e = options.max_delta_e;
    }
    Options sized = options;
    sized.size = report::size_text(settings.sizes.back());
    Situation situation = situation_of(sized, device);
    const StudiedLooks looks(device, options, situation.has_light());
    looks.put_into(situation);
    // One picture is reported on, not a comparison.
    situation.look_a = situation.look_b != nullptr ? situation.look_b : situation.look_a;
    situation.look_b = nullptr;
    for (const std::string& read : situation.shown->files) {
        lutlib::io::require_another_than(read, "what is shown", options.output);
    }
    const report::RendererReport made =
        report::make_report(tools, situation, settings, [&](const std::string& doing) {
            if (options.verbose) {
                lutlib::io::print_err("lutpreview: " + doing + "\n");
            }
        });
    if (!options.passes.empty()) {
        for (const report::LeftOutStudy& none : made.left_out) {
            lutlib::io::print_err(fmt::format("lutpreview: {} of --passes is not measured: {}\n",
                                              none.study->name, none.reason));
        }
    }
    write(options, made);
    for (const std::string& message : device.validation_messages()) {
        lutlib::io::print_err("lutpreview: " + message + "\n");
    }
    return !made.choice || made.choice->is_kept;
}

} // namespace preview
