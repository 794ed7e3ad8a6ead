#include "preview/panels/look_strip.h"

#include "preview/editor/commands.h"
#include "preview/editor/folder_list.h"
#include "preview/panels/thumbnail.h"
#include "preview/panels/ui.h"

#include "lutlib/error.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>

namespace preview::panels {

namespace {

constexpr float strip_gap = 0.5F; // heights of the text between two looks

/// The folder whose looks are shown; empty: none is known.
std::string folder_of(const Ui& ui) {
    if (!ui.look_strip.folder.empty()) {
        return ui.look_strip.folder;
    }
    return std::filesystem::path(file_of_look(ui.history.draft())).parent_path().string();
}

void list_anew(Ui& ui) {
    LookStrip& strip = ui.look_strip;
    const std::string folder = folder_of(ui);
    if (folder != strip.listing.folder) {
        strip.no_looks.clear();
        strip.is_outdated = true;
    }
    if (strip.is_outdated) {
        strip.listing = folder.empty() ? LookFolder{} : looks_in(folder);
        strip.is_outdated = false;
    }
    for (const auto& [key, fact] : ui.thumbnails.facts) {
        const std::filesystem::path path(key.name);
        if (fact.is_no_look && path.parent_path() == folder) {
            strip.no_looks.insert(path.filename().string());
        }
    }
    std::erase_if(strip.listing.names,
                  [&](const std::string& name) { return strip.no_looks.count(name) > 0; });
}

std::string path_of(const LookStrip& strip, std::size_t place) {
    return path_in(strip.listing.folder, strip.listing.names[place]);
}

void load(Ui& ui, const std::string& path) {
    attempt(ui, [&] {
        open_look(ui.history.draft(), lutlib::io::Look::open(path));
        remember_file(ui.recent, path);
    });
}

void ask_for_folder(Ui& ui) {
    ask_for_file(ui,
                 {.title = "The looks of which folder?",
                  .button = "Take this folder",
                  .picks_folder = true,
                  .kind = 1,
                  .chosen = [&ui](const std::string& folder) { ui.look_strip.folder = folder; }},
                 folder_of(ui).empty() ? "" : folder_of(ui) + "/");
}

void heading(Ui& ui) {
    LookStrip& strip = ui.look_strip;
    if (ImGui::SmallButton("Close")) {
        strip.is_open = false;
    }
    mark(ui, "strip.close");
    ImGui::SameLine();
    if (ImGui::SmallButton("Another folder ...")) {
        ask_for_folder(ui);
    }
    mark(ui, "strip.folder");
    if (!strip.folder.empty()) {
        ImGui::SameLine();
        if (ImGui::SmallButton("The look's own")) {
            strip.folder.clear();
        }
        mark(ui, "strip.own");
    }
    ImGui::SameLine();
    const std::size_t count = strip.listing.names.size(), others = strip.no_looks.size();
    std::string text =
        fmt::format("{} {} in {}", count, count == 1 ? "look" : "looks",
                    strip.listing.folder.empty() ? "no folder" : strip.listing.folder);
    if (others > 0) {
        text += fmt::format("; left out: {}",
                            others == 1 ? "1 file that is no look"
                                        : fmt::format("{} files that are no looks", others));
    }
    ImGui::TextDisabled("%s", text.c_str());
}

/// Why there is nothing to see; empty where there is.
std::string nothing_because(const LookStrip& strip) {
    if (strip.listing.folder.empty()) {
        return "Open or save a look, or choose a folder.";
    }
    return !strip.listing.reason.empty() ? strip.listing.reason
           : strip.listing.names.empty() ? "This folder has no looks: choose another."
                                         : "";
}

/// A look's picture over its name; whether it was clicked.
bool entry(Ui& ui, std::size_t place, bool is_current) {
    const LookStrip& strip = ui.look_strip;
    const std::string& name = strip.listing.names[place];
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = std::floor(em(thumbnail_width)), height = std::floor(em(thumbnail_height));
    const bool is_clicked =
        ImGui::InvisibleButton(name.c_str(), {width, height + ImGui::GetTextLineHeight()});
    mark(ui, "strip." + name);
    const bool is_hovered = ImGui::IsItemHovered();
    place_thumbnail(ui, {ThumbnailKind::file, path_of(strip, place)}, low.x, low.y);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 name_low{low.x, low.y + height};
    list.PushClipRect(name_low, {low.x + width, name_low.y + ImGui::GetTextLineHeight()}, true);
    list.AddText(name_low, ImGui::GetColorU32(is_current ? ImGuiCol_Text : ImGuiCol_TextDisabled),
                 name.c_str(), name.c_str() + name.size());
    list.PopClipRect();
    if (is_current || is_hovered) {
        const ImVec2 high{low.x + width, low.y + height};
        list.AddRect({low.x - 2, low.y - 2}, {high.x + 2, high.y + 2},
                     ImGui::GetColorU32(is_current ? ImGuiCol_CheckMark : ImGuiCol_Border), 0, 0,
                     2);
    }
    if (is_hovered) {
        const auto fact = ui.thumbnails.facts.find({ThumbnailKind::file, path_of(strip, place)});
        const bool is_told = fact != ui.thumbnails.facts.end() && !fact->second.reason.empty();
        ImGui::SetTooltip("%s%s%s", name.c_str(), is_told ? "\n" : "",
                          is_told ? fact->second.reason.c_str() : "");
    }
    return is_clicked;
}

/// What of the strip is in sight, and a click on it.
void entries(Ui& ui) {
    LookStrip& strip = ui.look_strip;
    const std::string current = file_of_look(ui.history.draft());
    const std::optional<std::size_t> at = place_of(strip.listing, current);
    const float step = std::floor(em(thumbnail_width) + em(strip_gap)), left = 3;
    const float room = ImGui::GetWindowWidth();
    if (at && strip.scrolled_to != current) {
        const float begin = static_cast<float>(*at) * step;
        if (begin < ImGui::GetScrollX() || begin + step > ImGui::GetScrollX() + room) {
            ImGui::SetScrollX(std::max(begin - (room - step) / 2, 0.0F));
        }
    }
    strip.scrolled_to = current;
    if (ImGui::IsWindowHovered() && ImGui::GetIO().MouseWheel != 0) {
        ImGui::SetScrollX(ImGui::GetScrollX() - step * ImGui::GetIO().MouseWheel);
    }
    const auto count = strip.listing.names.size();
    const auto first =
        std::min(static_cast<std::size_t>(std::max(ImGui::GetScrollX() / step, 0.0F)), count);
    const auto last = std::min(count, first + static_cast<std::size_t>(std::ceil(room / step)) + 1);
    const ImVec2 origin = ImGui::GetCursorPos();
    std::optional<std::size_t> clicked;
    for (std::size_t place = first; place < last; ++place) {
        ImGui::SetCursorPos({origin.x + left + static_cast<float>(place) * step, origin.y + left});
        if (entry(ui, place, at == place)) {
            clicked = place;
        }
    }
    ImGui::SetCursorPos(origin);
    ImGui::Dummy({left + static_cast<float>(count) * step, 1}); // how far it can be scrolled
    show_thumbnails(ui);
    if (clicked) {
        load(ui, path_of(strip, *clicked));
    }
}

} // namespace

float look_strip_height(const Ui& ui) {
    if (!ui.look_strip.is_open) {
        return 0;
    }
    const ImGuiStyle& style = ImGui::GetStyle();
    return std::floor(em(thumbnail_height) + 2 * ImGui::GetTextLineHeight() +
                      2 * style.WindowPadding.y + style.ItemSpacing.y + style.ScrollbarSize +
                      em(0.5F));
}

void look_strip(Ui& ui, const Rect& area) {
    if (area.height < 1) {
        return;
    }
    list_anew(ui);
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    ImGui::Begin("Looks under the picture", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
    heading(ui);
    const std::string nothing = nothing_because(ui.look_strip);
    if (nothing.empty()) {
        ImGui::BeginChild("looks", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar);
        entries(ui);
        ImGui::EndChild();
    } else {
        ImGui::TextWrapped("%s", nothing.c_str());
        mark(ui, "strip.nothing");
    }
    ImGui::End();
}

void toggle_look_strip(Ui& ui) {
    LookStrip& strip = ui.look_strip;
    strip.is_open = !strip.is_open;
    strip.is_outdated = true;
    strip.scrolled_to.clear();
}

void open_look_beside(Ui& ui, int step) {
    LookStrip& strip = ui.look_strip;
    strip.is_outdated = strip.is_outdated || !strip.is_open; // then nobody watches the folder
    list_anew(ui);
    std::optional<std::size_t> at = place_of(strip.listing, file_of_look(ui.history.draft()));
    const std::size_t count = strip.listing.names.size();
    const std::size_t others = count - (at ? 1 : 0);
    for (std::size_t tried = 0; tried < others; ++tried) {
        at = place_beside(at, step, count);
        try {
            const std::string path = path_of(strip, *at);
            if (const auto look = lutlib::io::Look::open_if_look(path)) {
                open_look(ui.history.draft(), *look);
                remember_file(ui.recent, path);
                return;
            }
        } catch (const lutlib::Error&) { // the strip tells why
        }
    }
    ui.errors.add(count == 0 ? nothing_because(strip)
                             : "choose another folder: no other look of " + strip.listing.folder +
                                   " can be read");
}

} // namespace preview::panels
