#include "preview/panels/exporting.h"

#include "lutlib/engine/engine.h"
#include "lutlib/limits.h"
#include "preview/panels/tip.h"
#include "preview/panels/ui.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <system_error>

namespace preview::panels {

namespace {

constexpr const char* title = "Write this file?";

void encoding_list(Ui& ui, const char* label, const std::string& place,
                   std::optional<lutlib::Encoding>& chosen) {
    const char* const own = "as the look has it";
    const bool open = ImGui::BeginCombo(label, chosen ? chosen->label().c_str() : own);
    mark(ui, place);
    if (!open) {
        return;
    }
    if (ImGui::Selectable(own, !chosen)) {
        chosen.reset();
    }
    for (const lutlib::Encoding& row : lutlib::encodings()) {
        if (ImGui::Selectable(row.label().c_str(), chosen == row)) {
            chosen = row;
        }
        mark(ui, place + "." + row.name());
    }
    ImGui::EndCombo();
}

/// Takes what is ready, or why it is not.
void poll(Ui& ui) {
    Exporting& exporting = ui.exporting;
    if (exporting.waiting.valid() &&
        exporting.waiting.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        attempt(ui, [&] { exporting.ready = exporting.waiting.get(); });
    }
}

} // namespace

void begin_export(Ui& ui, std::function<PreparedExport()> prepare) {
    ui.exporting.ready.reset();
    ui.exporting.waiting =
        std::async(std::launch::async, [wake = ui.wake, prepare = std::move(prepare)] {
            struct Waking {
                const std::function<void()>& wake;
                ~Waking() {
                    if (wake) {
                        wake();
                    }
                }
            } const waking{wake};
            return prepare();
        });
}

void lut_controls(Ui& ui) {
    ExportChoice& choice = ui.exporting.lut;
    ImGui::SliderInt("Nodes a side", &choice.size, 0, 129,
                     choice.size == 0 ? "the look's own" : "%d", ImGuiSliderFlags_AlwaysClamp);
    choice.size = choice.size == 1 ? lutlib::limits::min_cube_size : choice.size;
    mark(ui, "export-lut.size");
    tip("Nodes along an axis of the cube", "the look's own");
    encoding_list(ui, "Codes in", "export-lut.in", choice.encodings.input);
    encoding_list(ui, "Codes out", "export-lut.out", choice.encodings.output);
}

void strip_controls(Ui& ui, const lutlib::Engine& engine) {
    ExportChoice& choice = ui.exporting.strip;
    const auto offered = [](std::span<const int> all, int value) {
        return std::find(all.begin(), all.end(), value) != all.end();
    };
    const std::span<const int> sizes = engine.sizes;
    if (choice.size != 0 && !sizes.empty() && !offered(sizes, choice.size)) {
        choice.size = 0; // another engine was chosen since
    }
    const auto text_of_size = [&](int size) {
        return size == 0 ? std::to_string(engine.default_size) + " nodes, as usual"
                         : std::to_string(size) + " nodes";
    };
    if (!sizes.empty() && ImGui::BeginCombo("Size", text_of_size(choice.size).c_str())) {
        if (ImGui::Selectable(text_of_size(0).c_str(), choice.size == 0)) {
            choice.size = 0;
        }
        for (const int size : sizes) {
            if (ImGui::Selectable(text_of_size(size).c_str(), choice.size == size)) {
                choice.size = size;
            }
        }
        ImGui::EndCombo();
    }
    if (engine.sizes.empty()) {
        ImGui::SliderInt("Nodes of the strip", &choice.size, 0, 65,
                         choice.size == 0 ? "the engine's own" : "%d",
                         ImGuiSliderFlags_AlwaysClamp);
        mark(ui, "export-strip.size");
    }
    if (!offered(engine.bits, choice.bits)) {
        choice.bits = 0;
    }
    if (engine.bits.size() < 2) {
        return;
    }
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Bits");
    for (const int bits : engine.bits) {
        ImGui::SameLine();
        const bool is_chosen = bits == (choice.bits == 0 ? engine.default_bits : choice.bits);
        if (ImGui::RadioButton(std::to_string(bits).c_str(), is_chosen)) {
            choice.bits = bits;
        }
        mark(ui, "export-strip.bits." + std::to_string(bits));
    }
}

void export_dialog(Ui& ui) {
    poll(ui);
    Exporting& exporting = ui.exporting;
    if (exporting.is_busy() && !ui.asks_to_quit && !ImGui::IsPopupOpen(title)) {
        ImGui::OpenPopup(title);
    }
    ImGui::SetNextWindowSize({std::min(em(46), ImGui::GetIO().DisplaySize.x - em(1)), 0});
    if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoResize)) {
        return;
    }
    if (exporting.waiting.valid()) {
        ImGui::TextUnformatted("it is being made, and held against the look ...");
    }
    bool done = !exporting.is_busy();
    if (exporting.ready) {
        ImGui::TextWrapped("%s", exporting.ready->report.c_str());
        std::error_code unknown;
        const bool replaces = std::filesystem::exists(exporting.ready->path, unknown);
        if (replaces) {
            ImGui::TextWrapped("%s exists already.", exporting.ready->path.c_str());
        }
        if (ImGui::Button(replaces ? "Replace it" : "Write it")) {
            attempt(ui, [&] {
                write(*exporting.ready);
                ui.report = exporting.ready->report;
            });
            done = true;
        }
        mark(ui, "export.write");
        ImGui::SameLine();
        done |= ImGui::Button("Write nothing");
        mark(ui, "export.cancel");
    }
    if (done) {
        exporting.ready.reset();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

} // namespace preview::panels
