#include "preview/cli/check_mode.h"

#include "lutlib/io/terminal.h"
#include "preview/check/check.h"
#include "preview/cli/check_report.h"
#include "preview/cli/look_options.h"
#include "preview/look/gpu_look.h"

#include <fmt/format.h>

#include <memory>
#include <optional>

namespace preview {

namespace {

/// Small enough for a software device, and odd sizes of levels among what bloom halves.
constexpr Size usual_check_size{192, 108};
constexpr std::uint32_t usual_check_shadow_size = 256;

/// A look as the frame's passes read it; nothing where it would change nothing.
std::optional<GpuLook> checked_look(const gpu::Device& device, const std::string& path,
                                    const LookUse& use) {
    const LoadedLook look = load_look(path, use);
    return look.skip_reason.empty() ? std::optional<GpuLook>(std::in_place, device, look.data)
                                    : std::nullopt;
}

Situation situation_of(const Options& options, const gpu::Device& device) {
    Situation out;
    out.shown = std::make_shared<const Shown>(shown_of(options));
    Options sized = options;
    if (options.size.empty()) {
        sized.size = fmt::format("{}x{}", usual_check_size.width, usual_check_size.height);
    }
    out.settings = settings_of(sized, out.shown->picture_size());
    if (out.settings.shadow_size == 0) {
        out.settings.shadow_size = usual_check_shadow_size;
    }
    out.settings.raster =
        options.raster->on(device, picture_size(out.settings.output, *out.settings.compare));
    out.lights = lights_of(options, out.shown->scene);
    if (out.shown->scene) {
        out.settings.orbit = orbit_of(options, *out.shown->scene);
        out.surroundings = surroundings_of(options, *out.shown->scene);
    }
    return out;
}

} // namespace

bool check_renderer(const Options& options) {
    gpu::DeviceOptions wanted;
    wanted.wanted = options.device;
    wanted.validation = options.validate;
    const gpu::Device device(wanted);
    Situation situation = situation_of(options, device);
    const bool has_light = situation.has_light();
    const auto look_a = checked_look(device, options.look_a, use_a(options, has_light));
    const auto look_b = checked_look(device, options.look_b, use_b(options, has_light));
    situation.look_a = look_a ? &*look_a : nullptr;
    situation.look_b = look_b ? &*look_b : nullptr;

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
