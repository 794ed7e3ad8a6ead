// lutpreview: renders a scene or a picture, finishes it as an engine would and shows two looks.
// Errors are caught here and nowhere else.
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/image.h"
#include "lutlib/io/png.h"
#include "preview/cli/headless.h"
#include "preview/cli/options.h"
#include "preview/frame/shown.h"
#include "preview/look/look_file.h"
#include "preview/window/app.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <optional>

namespace preview {
namespace {

enum ExitCode { ok = 0, bad_input = 2, bad_usage = 3 };

/// The lookup that the options name; null: the look's own.
const GpuLookup* lookup_of(const Options& options) {
    const GpuLookup* const lookup =
        options.engine.empty() ? nullptr : gpu_lookup_named(options.engine);
    if (lookup == nullptr && !options.engine.empty())
        throw lutlib::UsageError("no lookup is named '" + options.engine + "'; --list names them");
    return lookup;
}

std::optional<GpuLook> load_side(const gpu::Device& device, const std::string& path,
                                 const Options& options, std::string& notes, const char* side) {
    const LoadedLook look = load_look(path, lookup_of(options));
    for (const std::string& line : look.told) {
        std::fprintf(stderr, "lutpreview: %s: %s\n", path.c_str(), line.c_str());
        notes += "look " + std::string(side) + ": " + line + "\n";
    }
    if (!look.note.empty())
        notes += "look " + std::string(side) + ": " + look.note + "\n";
    if (look.skip_reason.empty() || (options.force_all && path != "none" && !path.empty()))
        return std::optional<GpuLook>(std::in_place, device, look.data);
    if (path != "none" && !path.empty())
        notes += "left out  look " + std::string(side) + ": " + look.skip_reason + "\n";
    return std::nullopt;
}

void write_picture(const std::string& path, const Rendered& rendered) {
    lutlib::io::PngImage image;
    image.width = static_cast<int>(rendered.size.width);
    image.height = static_cast<int>(rendered.size.height);
    image.srgb_tag = true;
    for (std::size_t at = 0; at < rendered.rgba.size(); at += 4)
        image.samples.insert(image.samples.end(), rendered.rgba.begin() + static_cast<long>(at),
                             rendered.rgba.begin() + static_cast<long>(at) + 3);
    if (path == lutlib::io::standard_stream || lutlib::io::extension_of(path) == "png") {
        lutlib::io::write_file(path, lutlib::io::write_png(image));
        return;
    }
    lutlib::io::FloatImage floats{image.width, image.height, {}, 3, false, {}};
    for (const std::uint8_t code : rendered.rgba)
        floats.rgba.push_back(static_cast<float>(code) / 255);
    lutlib::io::write_image(path, floats, {lutlib::io::Depth::uint8, false, {}});
}

bool writes_light(const std::string& path) {
    const std::string extension = lutlib::io::extension_of(path);
    return extension == "exr" || extension == "hdr";
}

void write_light(const std::string& path, const Rendered& rendered) {
    const lutlib::io::FloatImage image{static_cast<int>(rendered.hdr_size.width),
                                       static_cast<int>(rendered.hdr_size.height),
                                       rendered.hdr,
                                       3,
                                       false,
                                       lutlib::io::Depth::half};
    lutlib::io::write_image(path, image, {lutlib::io::Depth::half, false, {}});
}

void print_list() {
    std::fputs(listing().c_str(), stdout);
    std::puts("Devices (--device)");
    std::size_t number = 0;
    for (const gpu::DeviceInfo& device : gpu::list_devices()) {
        std::printf("  %-20zu %s, %s%s%s\n", number, device.name.c_str(), device.kind.c_str(),
                    device.usable ? "" : "; lacks ", device.missing.c_str());
        ++number;
    }
}

Rendered cube_picture(const Options& options) {
    const LoadedLook look =
        load_look(options.cube_view == "a" ? options.look_a : options.look_b, lookup_of(options));
    Rendered out;
    out.size = settings_of(options, {}).output;
    CubeDrawing drawing;
    draw_cube(cube_nodes(look.table ? *look.table : lutlib::Lut{}, options.cube_nodes),
              options.cube, static_cast<float>(out.size.width), static_cast<float>(out.size.height),
              drawing);
    out.rgba =
        rasterised(drawing, static_cast<int>(out.size.width), static_cast<int>(out.size.height));
    return out;
}

int run(const Options& options) {
    if (options.list) {
        print_list();
        return ok;
    }
    if (!options.cube_view.empty()) {
        if (options.output.empty())
            throw lutlib::UsageError("--cube-view needs -o FILE");
        write_picture(options.output, cube_picture(options));
        return ok;
    }
    const bool prints = options.explain || options.timings || !options.probe.empty();
    if (!options.headless && !prints && options.output.empty()) {
        run_window(options);
        return ok;
    }
    if (options.headless && options.output.empty() && !prints)
        throw lutlib::UsageError("--headless needs -o FILE, --timings, --probe or --explain");

    gpu::DeviceOptions device_options;
    device_options.wanted = options.device;
    device_options.validation = options.validate;
    const gpu::Device device(device_options);
    const auto shown = std::make_shared<const Shown>(load_shown(options.input, options.seconds));
    std::string notes; // lines of --explain
    for (const std::string& line : shown->left_out) {
        notes += "left out  of " + shown->name + ": " + line + "\n";
        if (!options.explain)
            std::fprintf(stderr, "lutpreview: %s: left out: %s\n", shown->name.c_str(),
                         line.c_str());
    }
    FrameSettings settings = settings_of(options, shown->picture_size());
    const std::vector<PointLight> lights = lights_of(options, shown->scene);
    if (shown->scene) {
        settings.exposure += shown->scene->exposure;
        settings.orbit = orbit_of(options, *shown->scene);
    } else if (shown->display_encoded()) {
        settings.tonemap = nullptr;
    }
    settings.raster = raster_of(options, device, picture_size(settings.output, *settings.compare));
    settings.keep_hdr = writes_light(options.output);
    const auto look_a = load_side(device, options.look_a, options, notes, "A");
    const auto look_b = load_side(device, options.look_b, options, notes, "B");
    const GpuShown on_gpu(device, shown);
    FrameInputs inputs = on_gpu.inputs();
    inputs.lights = &lights;
    inputs.look_a = look_a ? &*look_a : nullptr;
    inputs.look_b = look_b ? &*look_b : nullptr;

    Executor executor(device);
    if (!options.output.empty() || options.explain || settings.probe) {
        const Rendered rendered = render_frame(executor, inputs, settings);
        if (options.explain)
            std::printf("%s%s", rendered.explanation.c_str(), notes.c_str());
        if (rendered.probe)
            std::fputs(options.json ? probe_json(*rendered.probe, *settings.probe).c_str()
                                    : probe_table(*rendered.probe, *settings.probe).c_str(),
                       stdout);
        if (rendered.figures)
            std::printf("dE2000  mean %.3f  p95 %.3f  p99 %.3f  max %.3f\n", rendered.figures->mean,
                        rendered.figures->p95, rendered.figures->p99, rendered.figures->max);
        if (!options.output.empty() && settings.keep_hdr && settings.view == nullptr &&
            settings.scope == nullptr)
            write_light(options.output, rendered);
        else if (!options.output.empty())
            write_picture(options.output, rendered);
    }
    if (options.timings) {
        const Timings timings = time_frames(executor, inputs, settings, options.frames);
        std::fputs(options.json ? to_json(timings, device.name(), settings.output).c_str()
                                : to_table(timings).c_str(),
                   stdout);
    }
    for (const std::string& message : device.validation_messages())
        std::fprintf(stderr, "lutpreview: %s\n", message.c_str());
    return ok;
}

int complain(const char* message, int code) {
    std::fprintf(stderr, "lutpreview: %s\n", message);
    return code;
}

} // namespace
} // namespace preview

int main(int argc, char** argv) {
    CLI::App app("Renders a scene or a picture, finishes it in an engine's order (bloom, tone map, "
                 "LUT, antialiasing) and shows two looks side by side.\n"
                 "Exit codes: 0 ok, 2 bad input, 3 bad usage.",
                 "lutpreview");
    preview::Options options;
    preview::declare(app, options);
    try {
        app.parse(argc, argv);
        return preview::run(options);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? preview::ok : preview::bad_usage;
    } catch (const lutlib::UsageError& error) {
        return preview::complain(error.what(), preview::bad_usage);
    } catch (const std::exception& error) {
        return preview::complain(error.what(), preview::bad_input);
    }
}
