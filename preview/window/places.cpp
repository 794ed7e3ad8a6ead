#include "preview/window/places.h"

#include "lutlib/io/file.h"

#include <fmt/format.h>
#include <imgui.h>

namespace preview {

void write_places(const panels::Ui& ui, const std::string& path) {
    if (path.empty()) {
        return;
    }
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    std::string text = fmt::format("frame {} 0 0 0\nthumbnails-drawn {} 0 0 0\n",
                                   ImGui::GetFrameCount(), ui.thumbnails.drawn);
    if (ImGui::IsMousePosValid(&mouse)) {
        text += fmt::format("mouse {:.0f} {:.0f} 0 0\n", mouse.x, mouse.y);
    }
    for (const auto& [name, place] : ui.places) {
        text += fmt::format("{} {:.0f} {:.0f} {:.0f} {:.0f}\n", name, place.x, place.y, place.width,
                            place.height);
    }
    lutlib::io::write_file(path, text);
}

} // namespace preview
