#include "preview/cli/check_mode.h"

#include "lutlib/io/terminal.h"
#include "preview/check/check.h"
#include "preview/cli/check_report.h"
#include "preview/cli/studied_input.h"

#include <fmt/format.h>

namespace preview {

namespace {

/// Small enough for a software device, and odd sizes of levels among what bloom halves.
constexpr Size usual_check_size{192, 108};
constexpr std::uint32_t usual_check_shadow_size = 256;

/// With what is usual for a check where nothing else is asked for.
Situation checked_situation(const Options& options, const gpu::Device& device) {
    Options sized = options;
    if (options.size.empty()) {
        sized.size = fmt::format("{}x{}", usual_check_size.width, usual_check_size.height);
    }
    Situation out = situation_of(sized, device);
    if (out.settings.shadow_size == 0) {
        out.settings.shadow_size = usual_check_shadow_size;
    }
    return out;
}

} // namespace

bool check_renderer(const Options& options) {
    gpu::DeviceOptions wanted;
    wanted.wanted = options.device;
    wanted.validation = options.validate;
    const gpu::Device device(wanted);
    Situation situation = checked_situation(options, device);
    const StudiedLooks looks(device, options, situation.has_light());
    looks.put_into(situation);

    Checker checker(device, std::move(situation));
    const CheckReport report = run_check(checker, [&](const std::string& row) {
        if (options.verbose) {
            lutlib::io::print_err("lutpreview: " + row + "\n");
        }
    });
    const std::size_t rows = report.extremes.size() + report.plants.size() + report.nudges.size();
    const Size size = checker.situation().settings.output;
    if (options.json) {
        lutlib::io::print_out(to_json(report, device.name(), size));
    } else {
        terminal::Table table = table_of(report, options.quiet);
        table.heading(fmt::format("{} of {} rows fail on {} at {}x{}", report.failed(), rows,
                                  device.name(), size.width, size.height));
        terminal::print(table);
    }
    for (const std::string& message : device.validation_messages()) {
        lutlib::io::print_err("lutpreview: " + message + "\n");
    }
    return report.failed() == 0;
}

} // namespace preview
