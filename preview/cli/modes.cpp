#include "preview/cli/modes.h"

#include "lutlib/error.h"
#include "lutlib/io/box/box.h"
#include "lutlib/io/file.h"
#include "lutlib/io/references.h"
#include "lutlib/io/terminal.h"
#include "preview/cli/check_mode.h"
#include "preview/cli/look_options.h"
#include "preview/cli/option_listing.h"
#include "preview/cli/picture_file.h"
#include "preview/cli/rendering.h"
#include "preview/cli/report_mode.h"
#include "preview/cli/sequence.h"
#include "preview/frame/measured.h"
#include "preview/frame/shown.h"
#include "preview/look/look_file.h"
#include "terminal/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

namespace preview {

namespace {

/// A line for the kind of the surroundings and each number that it has.
std::string surroundings_text(const Surroundings& surroundings) {
    const SurroundingsInfo& row = surroundings_kinds()[static_cast<std::size_t>(surroundings.kind)];
    return "setting   surroundings " + std::string(row.name) + "\n" +
           settings_lines(row.numbers, surroundings);
}

void tell_written(const Options& options, const std::string& path) {
    if (options.verbose) {
        tell(lutlib::io::output_name(path));
    }
}

/// Says once what the frame leaves out of what was asked for; the explanation has it anyhow.
void tell_left_out(const Options& options, const std::vector<Withheld>& withheld,
                   std::set<std::string>& told) {
    for (const std::string& line : left_out(asked_parts(options), withheld)) {
        if (told.insert(unused_option(line)).second && !options.explain) {
            tell(line);
        }
    }
}

/// The options of which the rendering has told already that they change nothing.
std::set<std::string> told_by(const Rendering& rendering) {
    std::set<std::string> out;
    for (const std::string& line : rendering.unused) {
        out.insert(unused_option(line));
    }
    return out;
}

/// Takes the exposure that --meter asks for.
void meter(const Options& options, Rendering& rendering, Executor& executor) {
    if (options.meter.empty() || rendering.shown->display_encoded()) {
        return;
    }
    FrameSettings& settings = rendering.settings;
    std::optional<ProbePlace> place;
    if (options.meter != "all") {
        place =
            parse_place("--meter", options.meter, picture_size(settings.output, *settings.compare));
    }
    const std::optional<float> metered =
        metered_exposure(executor, rendering.inputs(), settings, place);
    if (!metered) {
        throw lutlib::UsageError("--meter finds no light there: name another texel, or all");
    }
    const NumberRow<PictureSettings>& row = picture_number("exposure");
    settings.exposure = std::clamp(settings.exposure + *metered, static_cast<float>(row.min),
                                   static_cast<float>(row.max));
    tell(fmt::format("metered: --exposure {:.2f}", static_cast<double>(settings.exposure)));
}

void render_once(const Options& options, const Rendering& rendering, Executor& executor,
                 Report& report, std::set<std::string>& told) {
    FrameSettings settings = rendering.settings;
    const Rendered rendered = render_frame(executor, rendering.inputs(), settings);
    tell_left_out(options, rendered.withheld, told);
    report.probe = rendered.probe;
    report.place = settings.probe.value_or(ProbePlace{});
    report.figures = rendered.figures;
    if (rendered.figures) {
        settings.heat_scale = rendered.heat_scale;
    }
    if (options.explain) {
        report.explanation =
            rendered.explanation + rendering.notes + settings_text(settings) +
            (rendering.shown->scene ? settings_lines(camera_numbers(), settings.orbit) +
                                          surroundings_text(rendering.surroundings)
                                    : "");
    }
    if (!options.output.empty()) {
        write_frame(options.output, rendering, rendered);
        tell_written(options, options.output);
    }
}

/// The frame at a moment. The scene's meshes, which the GPU has, are the same at every moment.
void render_moment(const Options& options, const Rendering& rendering, Executor& executor,
                   double seconds, const std::string& path, std::set<std::string>& told) {
    FrameSettings settings = rendering.settings;
    settings.seconds = seconds;
    FrameInputs inputs = rendering.inputs();
    std::optional<Scene> scene;
    std::vector<PointLight> lights;
    Surroundings surroundings = rendering.surroundings;
    surroundings.seconds = seconds;
    inputs.surroundings = &surroundings;
    if (const SceneInfo* const info = scene_named(options.input)) {
        scene = scene_at(*info, seconds);
        lights = lights_of(options, scene);
        inputs.scene = &*scene;
        inputs.lights = &lights;
    }
    const Rendered rendered = render_frame(executor, inputs, settings);
    tell_left_out(options, rendered.withheld, told);
    write_frame(path, rendering, rendered);
}

void render_sequence(const Options& options, const Rendering& rendering, Executor& executor,
                     const FrameRange& range) {
    int written = 0;
    std::set<std::string> told = told_by(rendering);
    for (int frame = range.first; frame <= range.last; ++frame) {
        const std::string path = frame_path(options.output, frame);
        if (!options.resume || !is_frame_there(path)) {
            render_moment(options, rendering, executor,
                          options.seconds + frame / options.frame_rate, path, told);
            tell_written(options, path);
            ++written;
        }
    }
    const int there = range.last - range.first + 1 - written;
    if (!options.quiet) {
        tell(std::to_string(written) + " frames written" +
             (there > 0 ? ", " + std::to_string(there) + " were there" : ""));
    }
}

/// Beside a picture on standard output there is room for people's eyes only.
void print(const Options& options, const Report& report) {
    const std::string text = options.json ? to_json(report) : to_text(report);
    options.output == lutlib::io::standard_stream ? lutlib::io::print_err(text)
                                                  : lutlib::io::print_out(text);
}

void print_validation(const gpu::Device& device) {
    for (const std::string& message : device.validation_messages()) {
        tell(message);
    }
}

} // namespace

void print_list() {
    terminal::Table table = listing();
    table.heading("Devices (--device)");
    std::size_t number = 0;
    for (const gpu::DeviceInfo& device : gpu::list_devices()) {
        table.row(
            {std::to_string(number), fmt::format("{}, {}{}{}", device.name, device.kind,
                                                 device.usable ? "" : "; lacks ", device.missing)});
        ++number;
    }
    terminal::print(table);
}

void render_cube(const Options& options) {
    if (options.output.empty()) {
        throw lutlib::UsageError("--cube-view needs -o FILE");
    }
    refuse_hashes(options.output);
    refuse_looks_as_output(options);
    const LoadedLook look = options.cube_view == "a"
                                ? load_look(options.look_a, use_a(options, true))
                                : load_look(options.look_b, use_b(options, true));
    Rendered out;
    out.size = settings_of(options, {}).output;
    CubeDrawing drawing;
    draw_cube(cube_nodes(look.table ? *look.table : lutlib::Lut{}, options.cube_nodes),
              options.cube, static_cast<float>(out.size.width), static_cast<float>(out.size.height),
              drawing);
    out.rgba =
        rasterised(drawing, static_cast<int>(out.size.width), static_cast<int>(out.size.height));
    write_picture(options.output, out, file_format(options.output, options.depth));
}

void render(const Options& options) {
    const bool prints = options.explain || options.timings || !options.probe.empty();
    if (options.output.empty() && !prints) {
        throw lutlib::UsageError("--headless needs -o FILE, --timings, --probe or --explain");
    }
    const FramesAsked frames = parse_frames(options.frames);
    if (frames.range) {
        frame_path(options.output, 0);
        if (prints) {
            throw lutlib::UsageError("a sequence of --frames prints nothing: drop --explain, "
                                     "--timings and --probe, or the range");
        }
    } else {
        refuse_hashes(options.output);
    }
    Rendering rendering(options);
    tell_empty_view(rendering);
    if (options.json && !prints && rendering.settings.compare != &compare_difference) {
        throw lutlib::UsageError(
            "--json has nothing to print: add --timings, --probe, --explain or "
            "--compare diff");
    }
    if (options.verbose) {
        tell("rendered by " + rendering.device.name());
    }
    Executor executor(rendering.device);
    meter(options, rendering, executor);
    if (frames.range) {
        render_sequence(options, rendering, executor, *frames.range);
        print_validation(rendering.device);
        return;
    }
    Report report;
    std::set<std::string> told = told_by(rendering);
    if (!options.output.empty() || options.explain || rendering.settings.probe) {
        render_once(options, rendering, executor, report, told);
    }
    if (options.timings) {
        report.timings =
            time_frames(executor, rendering.inputs(), rendering.settings, frames.count);
        tell_left_out(options, report.timings->withheld, told);
        report.device = rendering.device.name();
        report.size = rendering.settings.output;
    }
    if (options.quiet && !options.json) {
        report.figures.reset();
    }
    print(options, report);
    print_validation(rendering.device);
}

bool run(const Options& options) {
    lutlib::io::box::set_used(!options.no_sandbox);
    lutlib::io::box::set_memory(static_cast<std::size_t>(options.max_memory * (1 << 30)));
    lutlib::io::allow_references_outside(options.allow_outside);
    if (options.no_sandbox) {
        tell("files are read without a sandbox");
    }
    for (const std::string& line : options.unused) {
        tell(line);
    }
    if (options.study != nullptr) {
        return options.study->writes_page ? report_renderer(options) : check_renderer(options);
    }
    if (options.list) {
        print_list();
    } else if (!options.cube_view.empty()) {
        render_cube(options);
    } else if (opens_window(options)) {
        open_window(options);
    } else {
        render(options);
    }
    return true;
}

} // namespace preview
