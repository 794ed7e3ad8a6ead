#include "preview/window/window_frame.h"

#include "preview/frame/frame_effects.h"

#include <imgui.h>

#include <algorithm>
#include <cstring>

namespace preview {

namespace {

/// Whether both frames have the same HDR picture.
bool same_light(const FrameSettings& a, const FrameSettings& b) {
    return std::memcmp(&a.orbit, &b.orbit, sizeof a.orbit) == 0 && a.exposure == b.exposure &&
           a.without == b.without && a.occlusion == b.occlusion && a.zoom.scale == b.zoom.scale &&
           picture_size(a.output, *a.compare) == picture_size(b.output, *b.compare);
}

std::vector<std::uint32_t> words_of(const std::vector<std::byte>& bytes) {
    std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
    std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::uint32_t));
    return words;
}

std::optional<DifferenceFigures> figures_of(const Executor& executor, Size picture) {
    const std::vector<std::uint32_t> counted = words_of(executor.finished_buffer("figures"));
    if (counted.empty()) {
        return std::nullopt;
    }
    return difference_figures(counted, std::uint64_t{picture.width} * picture.height);
}

} // namespace

vk::Rect2D output_area(const panels::Rect& area, vk::Extent2D window) {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    const auto x = std::min(static_cast<std::uint32_t>(area.x * scale.x), window.width - 2);
    const auto y = std::min(static_cast<std::uint32_t>(area.y * scale.y), window.height - 1);
    const auto width = std::max(static_cast<std::uint32_t>(area.width * scale.x) & ~1U, 2U);
    const auto height = std::max(static_cast<std::uint32_t>(area.height * scale.y), 1U);
    return {{static_cast<int>(x), static_cast<int>(y)},
            {std::min(width, (window.width - x) & ~1U), std::min(height, window.height - y)}};
}

ScopeAreas scope_areas(const panels::Ui& ui, vk::Extent2D window) {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    ScopeAreas areas;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const panels::Rect& place = ui.scopes_shown.places[i];
        const auto x = static_cast<std::uint32_t>(std::max(place.x * scale.x, 0.0F));
        const auto y = static_cast<std::uint32_t>(std::max(place.y * scale.y, 0.0F));
        const auto width = static_cast<std::uint32_t>(place.width * scale.x);
        const auto height = static_cast<std::uint32_t>(place.height * scale.y);
        if (x < window.width && y < window.height && width > 0 && height > 0) {
            areas[i] = vk::Rect2D(
                {static_cast<int>(x), static_cast<int>(y)},
                {std::min(width, window.width - x), std::min(height, window.height - y)});
        }
    }
    return areas;
}

FrameSettings window_settings(const panels::Ui& ui, FrameSettings given, Size output) {
    const editor::State& state = ui.history.draft();
    FrameSettings settings = std::move(given);
    settings.output = output;
    settings.orbit = state.orbit;
    static_cast<PictureSettings&>(settings) = state;
    settings.compare = ui.held != nullptr ? ui.held : state.compare;
    if (settings.heat_scale < 0 && ui.facts.measured.figures) {
        settings.heat_scale = heat_scale_for(*ui.facts.measured.figures);
    }
    settings.scope_side = state.scopes_seen.side;
    settings.scope_region = state.scopes_seen.region;
    settings.scope_logarithmic = state.scopes_seen.logarithmic;
    settings.scope_gain = state.scopes_seen.gain;
    settings.scope_levels = panels::scope_levels(ui);
    settings.scope_figures = ui.scopes_shown.figures;
    if (ui.pointer) {
        settings.probe = {std::clamp(ui.pointer->x, 0, static_cast<int>(output.width) - 1),
                          std::clamp(ui.pointer->y, 0, static_cast<int>(output.height) - 1)};
    }
    settings.seconds = ui.seconds;
    settings.view = debug_view_named(ui.debug_view);
    settings.axes = ui.shows_curves ? &state.recipe.input : nullptr;
    return settings;
}

void FrameReader::forget() {
    hdr_maximum_.reset();
    frames_of_light_ = 0;
}

std::optional<float> FrameReader::hdr_maximum_for(const FrameSettings& settings,
                                                  const std::vector<PointLight>& lights,
                                                  const Surroundings& surroundings) {
    if (!same_light(settings, measured_for_) || lights != lights_ ||
        surroundings != surroundings_) {
        forget();
        measured_for_ = settings;
        lights_ = lights;
        surroundings_ = surroundings;
    }
    return hdr_maximum_;
}

namespace {

/// Why no scope counts that somebody looks at.
std::string_view no_scopes_because(const Graph& graph, const panels::Ui& ui) {
    const editor::ScopeChoice& choice = ui.history.draft().scopes_seen;
    for (const Withheld& item : graph.withheld()) {
        const Scope* const scope = lutlib::find_named(scopes, item.name);
        if (scope != nullptr && choice.seen[index_of(*scope)]) {
            return item.reason;
        }
    }
    return {};
}

} // namespace

bool FrameReader::read(Executor& executor, const Graph& graph, const FrameHandles& handles,
                       panels::Ui& ui) {
    const std::string_view no_scopes = no_scopes_because(graph, ui);
    const bool is_news = ui.facts.no_scopes != no_scopes;
    if (is_news) {
        ui.facts.no_scopes = no_scopes;
    }
    ui.facts.explanation = explain(graph, executor.plan()) + order_text(handles);
    if (ui.shows_passes) {
        ui.facts.passes.clear();
        for (const StepTime& step : executor.timings()) {
            ui.facts.passes.push_back({step.name, step.milliseconds});
        }
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
    panels::Measured measured;
    if (handles.figures) {
        measured.figures = figures_of(executor, size_of(graph, handles.graded));
    }
    if (handles.probe) {
        measured.probe = probe_from(executor.finished_buffer("probe"));
    }
    if (handles.axis_counts) {
        measured.axis_counts = words_of(executor.finished_buffer("axis counts"));
    }
    if (measured == ui.facts.measured) {
        return is_news;
    }
    ui.facts.measured = std::move(measured);
    return true;
}

} // namespace preview
