#include "preview/window_frame.h"

#include <cstring>

namespace preview {

namespace {

/// Whether both frames have the same HDR picture.
bool same_light(const FrameSettings& a, const FrameSettings& b) {
    return std::memcmp(&a.orbit, &b.orbit, sizeof a.orbit) == 0 && a.exposure == b.exposure &&
           a.without == b.without &&
           picture_size(a.output, *a.compare) == picture_size(b.output, *b.compare);
}

std::optional<DifferenceFigures> figures_of(const Executor& executor, Size picture) {
    const std::vector<std::byte> bytes = executor.finished_buffer("figures");
    std::vector<std::uint32_t> counted(bytes.size() / sizeof(std::uint32_t));
    std::memcpy(counted.data(), bytes.data(), counted.size() * sizeof(std::uint32_t));
    if (counted.empty())
        return std::nullopt;
    return difference_figures(counted, std::uint64_t{picture.width} * picture.height);
}

} // namespace

FrameSettings window_settings(const ui::Ui& ui, const Options& options, const gpu::Device& device,
                              Size output) {
    const ui::State& state = ui.history.draft();
    const Shown& shown = *state.shown;
    FrameSettings settings;
    settings.output = output;
    settings.orbit = state.orbit;
    settings.exposure = state.exposure + (shown.scene ? shown.scene->exposure : 0);
    settings.tonemap = shown.display_encoded() ? nullptr : state.tonemap;
    settings.bloom = state.bloom;
    settings.bloom_settings = state.bloom_settings;
    settings.compare = ui.held != nullptr ? ui.held : state.compare;
    settings.split = state.split;
    settings.heat_scale = state.heat_scale;
    settings.without = state.without;
    settings.shadow_size = options.shadow_size;
    settings.force_all = options.force_all;
    settings.raster = raster_of(options, device, picture_size(output, *settings.compare));
    return settings;
}

void FrameReader::forget() {
    hdr_maximum_.reset();
    frames_of_light_ = 0;
}

std::optional<float> FrameReader::hdr_maximum_for(const FrameSettings& settings,
                                                  const std::vector<PointLight>& lights) {
    if (!same_light(settings, measured_for_) || lights != lights_) {
        forget();
        measured_for_ = settings;
        lights_ = lights;
    }
    return hdr_maximum_;
}

void FrameReader::read(Executor& executor, const Graph& graph, const FrameHandles& handles,
                       ui::Ui& ui) {
    ui.facts.explanation = explain(graph, executor.plan());
    if (ui.shows_passes) {
        ui.facts.passes.clear();
        for (const StepTime& step : executor.timings())
            ui.facts.passes.push_back({step.name, step.milliseconds});
    }
    // Once every frame in flight has this light, the newest that has finished measured it.
    if (++frames_of_light_ >= frames_in_flight_ && !hdr_maximum_) {
        const std::vector<std::byte> bytes = executor.finished_buffer("hdr maximum");
        if (bytes.size() == sizeof(float)) {
            float maximum = 0;
            std::memcpy(&maximum, bytes.data(), sizeof maximum);
            hdr_maximum_ = maximum;
        }
    }
    ui.facts.figures.reset();
    if (handles.figures)
        ui.facts.figures = figures_of(executor, size_of(graph, handles.graded));
}

} // namespace preview
