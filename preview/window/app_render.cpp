#include "preview/window/app_parts.h"

#include "lutlib/error.h"
#include "lutlib/io/reason.h"
#include "preview/editor/solo.h"
#include "preview/editor/stills.h"
#include "preview/frame/frame.h"
#include "preview/frame/measured.h"
#include "preview/window/present.h"

#include <algorithm>
#include <array>
#include <utility>

namespace preview {

void App::request_looks() {
    const editor::State& state = ui_.history.draft();
    editor::LookRequest request{shown_recipe(state), state.sides, state.picture};
    if (baking_ && editor::same(request, requested_)) {
        return;
    }
    requested_ = request;
    baking_ = true;
    baker_.request(std::move(request));
}

/// One that the GPU has no room for is taken off its side.
void App::take_stills() {
    for (std::size_t i = 0; i < screen_->stills.size(); ++i) {
        const editor::Side& side = ui_.history.draft().sides[i];
        const auto& still = side.source == editor::SideSource::still ? side.still : nullptr;
        if (screen_->stills[i].still == still) {
            continue;
        }
        drawn_.reset();
        try {
            screen_->set_still(i, still);
        } catch (const std::exception& error) {
            const auto* const of_vulkan = dynamic_cast<const vk::SystemError*>(&error);
            if (of_vulkan != nullptr && is_lost(*of_vulkan)) {
                throw;
            }
            ui_.errors.add("choose a smaller picture as a still than " + still->path + ": " +
                           lutlib::io::reason_of(error));
            take_still_off(ui_.history.draft(), i);
        }
    }
}

void App::take_looks() {
    const std::optional<editor::BakedLooks> baked = baker_.take();
    if (!baked) {
        return;
    }
    ui_.facts.bake_milliseconds = baked->milliseconds;
    frames_due_ = frames_after_event;
    if (!baked->error.empty()) {
        ui_.errors.add(baked->error);
        return;
    }
    for (std::size_t i = 0; i < screen_->looks.size(); ++i) {
        screen_->looks[i].set(baked->sides[i]);
        ui_.facts.look_notes[i] = baked->sides[i].note;
        ui_.facts.look_standings[i] = baked->sides[i].encodings;
        ui_.facts.tables[i] = baked->sides[i].table;
        ui_.facts.shown_codes[i] = baked->sides[i].shown;
    }
    drawn_.reset();
}

/// An intermediate that this frame has not is said once, and the picture is shown again.
FrameHandles App::declared(Graph& graph, const FrameInputs& inputs, FrameSettings& settings) {
    try {
        return build_frame(graph, inputs, settings);
    } catch (const lutlib::UsageError&) {
        if (settings.view == nullptr) {
            throw;
        }
        ui_.errors.add("choose another intermediate, or another scene: this one makes no '" +
                       std::exchange(ui_.debug_view, {}) + "'");
        settings.view = nullptr;
        graph = Graph();
        return build_frame(graph, inputs, settings);
    }
}

FrameInputs App::frame_inputs() const {
    const editor::State& state = ui_.history.draft();
    FrameInputs inputs = screen_->shown->inputs();
    inputs.lights = &state.lights;
    inputs.surroundings = &state.surroundings;
    inputs.look_a = screen_->looks[0].look();
    inputs.look_b = screen_->looks[1].look();
    for (std::size_t i = 0; i < inputs.stills.size(); ++i) {
        const std::optional<GpuPicture>& still = screen_->stills[i].picture;
        inputs.stills[i] = still ? &*still : nullptr;
    }
    return inputs;
}

/// All of it as it is finished, without the names that the window writes over a comparison.
void App::save_picture(const std::string& path) {
    const FrameInputs inputs = frame_inputs();
    FrameSettings settings = window_settings(ui_, setup_.frame, ui_.picture_size());
    settings.zoom = {};
    settings.picture_view = &picture_views().front();
    settings.keeps_light = false;
    settings.probe.reset();
    settings.axes = nullptr;
    settings.raster =
        setup_.raster->on(screen_->device, picture_size(settings.output, *settings.compare));
    screen_->device.vk().waitIdle();
    const std::vector<std::string> lost =
        setup_.save_picture(screen_->device, inputs, settings, *screen_->shown->shown(), path);
    ui_.report = "saved " + path + ", " + std::to_string(settings.output.width) + "x" +
                 std::to_string(settings.output.height) + "\n";
    for (const std::string& phrase : lost) {
        ui_.report += "  lost: " + phrase + "\n";
    }
}

/// A step of undo. The dark and display-encoded pictures keep their exposure. A place is one of
/// what is seen, the mean that of the whole picture.
void App::meter(const std::optional<ProbePlace>& place) {
    const vk::Extent2D seen = output_area(ui_.picture_place, screen_->swapchain.extent()).extent;
    FrameSettings settings = window_settings(
        ui_, setup_.frame, place ? Size{seen.width, seen.height} : ui_.picture_size());
    settings.keeps_light = false;
    settings.raster =
        setup_.raster->on(screen_->device, picture_size(settings.output, *settings.compare));
    const std::optional<float> metered =
        metered_exposure(screen_->executor, frame_inputs(), settings, place);
    if (metered) {
        ui_.history.draft().exposure = *metered;
        ui_.history.settle();
    } else {
        ui_.errors.add("show something that shines: there is no light to meter");
    }
    drawn_.reset();
    wake();
}

/// For the next frame, behind what this one waits for.
void App::draw_thumbnail() {
    const bool is_more = thumbnails_.draw(
        ui_, *screen_, frame_inputs(), window_settings(ui_, setup_.frame, {1, 1}), *setup_.raster);
    frames_due_ = is_more ? std::max(frames_due_, 1) : frames_due_;
}

/// From the next frame on they show what this one has counted.
void App::freeze_scopes(const FrameHandles& handles, const ScopeLevels& levels) {
    if (frozen_.take(screen_->executor, handles, screen_->frozen)) {
        ui_.facts.frozen_levels = levels;
    } else {
        ui_.scopes_shown.are_frozen = false;
        ui_.errors.add("show something that the scopes count before you freeze them" +
                       (ui_.facts.no_scopes.empty() ? "" : ": " + ui_.facts.no_scopes));
    }
    wake();
}

void App::render(const panels::Rect& area) {
    Screen& screen = *screen_;
    const vk::Extent2D window = screen.swapchain.extent();
    const vk::Rect2D output = output_area(area, window);
    const ScopeAreas scope_places = scope_areas(ui_, window);
    FrameSettings settings =
        window_settings(ui_, setup_.frame, {output.extent.width, output.extent.height});
    settings.raster =
        setup_.raster->on(screen.device, picture_size(settings.output, *settings.compare));
    for (std::size_t i = 0; i < scopes.size(); ++i) {
        settings.scope_sizes[i] = {scope_places[i].extent.width, scope_places[i].extent.height};
    }
    if (!ui_.scopes_shown.are_frozen) {
        frozen_.thaw();
        ui_.facts.frozen_levels.reset();
    }
    settings.keeps_scopes = ui_.scopes_shown.are_frozen && !frozen_.is_frozen();
    const editor::State& state = ui_.history.draft();
    FrameInputs inputs = frame_inputs();
    inputs.kept_scopes = frozen_.on(screen.device, screen.frozen);
    const std::array names{title_of(state.sides[0]), title_of(state.sides[1])};
    inputs.names = {names[0], names[1]};
    inputs.hdr_maximum = reader_.hdr_maximum_for(settings, state.lights, state.surroundings);
    Graph graph;
    const FrameHandles handles = declared(graph, inputs, settings);

    const std::optional<std::uint32_t> image = screen.swapchain.acquire();
    if (!image) {
        events_.resized = true;
        frames_due_ = frames_after_event;
        return;
    }
    FrameEnd end;
    end.waits = {screen.swapchain.acquired()};
    end.signals = {screen.swapchain.finished(*image)};
    end.record = [&](const vk::raii::CommandBuffer& commands) {
        std::vector<Placed> pictures{{&screen.executor.image(handles.output), output.offset}};
        for (std::size_t i = 0; i < scopes.size(); ++i) {
            if (handles.scope_pictures[i]) {
                pictures.push_back(
                    {&screen.executor.image(handles.scope_pictures[i]), scope_places[i].offset});
            }
        }
        record_present(commands, pictures, screen.swapchain.image(*image));
        screen.overlay.record(commands, screen.swapchain, *image,
                              screen.thumbnails ? &*screen.thumbnails : nullptr);
    };
    if (drawn_ && *drawn_ == graph) {
        screen.executor.repeat(end);
    } else {
        screen.executor.render(graph, end);
    }
    if (!screen.swapchain.present(*image)) {
        events_.resized = true;
        frames_due_ = frames_after_event;
    }
    if (reader_.read(screen.executor, graph, handles, ui_)) {
        frames_due_ = std::max(frames_due_, 1);
    }
    if (settings.keeps_scopes) {
        freeze_scopes(handles, settings.scope_levels);
    }
    drawn_ = std::move(graph);
}

} // namespace preview
