// The line under the picture: the colour under the mouse before the looks and after each side's, as
// codes, how far apart they are and, in a wide window, as values.
#include "preview/panels/status_line.h"

#include "preview/panels/ui.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace preview::panels {

namespace {

constexpr StatusForm forms_of_line[] = {
    {.place = true, .values = true, .before = true, .a = true, .differences = ToldDifferences::all},
    {.place = true, .before = true, .a = true, .differences = ToldDifferences::all},
    {.before = true, .a = true, .differences = ToldDifferences::all},
    {.before = true, .differences = ToldDifferences::of_b, .is_without_a = true},
    {.before = true, .a = true},
    {.before = true, .is_without_a = true},
    {.a = true},
    {},
};

constexpr const char* invitations[] = {
    "point at the picture for its colour before and after the looks",
    "point at the picture for its colour", "point at the picture"};

constexpr float gap_within = 0.43F, gap_of_parts = 1.14F; // heights of the text

/// As wide as any: what a line has does not change with the colours in it.
constexpr ProbePlace widest_place{8888, 8888};
constexpr lutlib::RgbD widest_color{1, 1, 1};
constexpr Probe widest_probe{widest_color, widest_color, widest_color, widest_color};
constexpr std::string_view widest_differences = "188.88";

float text_width(const std::string& text) {
    return ImGui::CalcTextSize(text.c_str()).x;
}

/// Drawn as part_width() has it.
void draw_part(const StatusPart& part) {
    if (part.color != nullptr) {
        const Codes codes = codes_of(*part.color);
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float side = ImGui::GetTextLineHeight();
        ImGui::GetWindowDrawList()->AddRectFilled(corner, {corner.x + side, corner.y + side},
                                                  IM_COL32(codes.r, codes.g, codes.b, 255));
        ImGui::Dummy({side, side});
        ImGui::SameLine(0, em(gap_within));
    }
    if (part.is_dim) {
        ImGui::TextDisabled("%s", part.text.c_str());
    } else {
        ImGui::TextUnformatted(part.text.c_str());
    }
    if (!part.values.empty()) {
        ImGui::SameLine(0, em(gap_within));
        ImGui::TextDisabled("%s", part.values.c_str());
    }
}

float part_width(const StatusPart& part) {
    return (part.color != nullptr ? ImGui::GetTextLineHeight() + em(gap_within) : 0) +
           text_width(part.text) +
           (part.values.empty() ? 0 : em(gap_within) + text_width(part.values));
}

float form_width(const StatusForm& form) {
    float width = -em(gap_of_parts);
    for (const StatusPart& part : status_parts(form, widest_place, widest_probe)) {
        width += part_width(part) + em(gap_of_parts);
    }
    const std::size_t figures = form.differences == ToldDifferences::all    ? 3
                                : form.differences == ToldDifferences::of_b ? 1
                                                                            : 0;
    return width + static_cast<float>(figures) *
                       (text_width(std::string(widest_differences)) - text_width("0.00"));
}

void draw_parts(Ui& ui, const std::vector<StatusPart>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i > 0) {
            ImGui::SameLine(0, em(gap_of_parts));
        }
        draw_part(parts[i]);
        mark(ui, "status." + parts[i].name);
    }
}

void invite(Ui& ui, float width) {
    const auto* const fits = std::find_if(std::begin(invitations), std::end(invitations) - 1,
                                          [&](const char* it) { return text_width(it) <= width; });
    ImGui::TextDisabled("%s", *fits);
    mark(ui, "status.invitation");
}

/// What the line had no room for, once the mouse is on it and no longer on the picture.
void tell_all(const Ui& ui) {
    if (!ui.status_told.empty() && ImGui::IsWindowHovered()) {
        ImGui::BeginTooltip();
        ImGui::TextUnformatted(ui.status_told.c_str());
        ImGui::EndTooltip();
    }
}

} // namespace

std::span<const StatusForm> status_forms() {
    return forms_of_line;
}

const StatusForm& status_form(float width, bool has_a,
                              const std::function<float(const StatusForm& form)>& width_of) {
    const auto* const fits = std::find_if(
        std::begin(forms_of_line), std::end(forms_of_line) - 1, [&](const StatusForm& form) {
            return !(form.is_without_a && has_a) && width_of(form) <= width;
        });
    return *fits;
}

std::vector<StatusPart> status_parts(const StatusForm& form, ProbePlace at, const Probe& probe) {
    std::vector<StatusPart> out;
    if (form.place) {
        out.push_back({"place", fmt::format("{:4}, {:4}", at.x, at.y), true});
    }
    const auto add = [&](const char* name, const lutlib::RgbD& color) {
        const Codes codes = codes_of(color);
        out.push_back({name, fmt::format("{} {:3} {:3} {:3}", name, codes.r, codes.g, codes.b),
                       false, &color,
                       form.values ? fmt::format("{:.4f} {:.4f} {:.4f}", color.r, color.g, color.b)
                                   : std::string()});
    };
    if (form.before) {
        add("before", probe.before);
    }
    if (form.a) {
        add("A", probe.a);
    }
    add("B", probe.b);
    const ProbeDifferences differences = differences_of(probe);
    if (form.differences == ToldDifferences::all) {
        out.push_back({"differences",
                       fmt::format("dE2000 A {:.2f}  B {:.2f}  A-B {:.2f}", differences.before_a,
                                   differences.before_b, differences.a_b)});
    } else if (form.differences == ToldDifferences::of_b) {
        out.push_back({"differences", fmt::format("dE2000 B {:.2f}", differences.before_b)});
    }
    return out;
}

void status_line(Ui& ui, const Rect& area) {
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {em(0.57F), em(0.36F)});
    ImGui::Begin("Status", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                     ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    const float width = ImGui::GetContentRegionAvail().x;
    if (ui.pointer && ui.facts.measured.probe) {
        const Probe& probe = *ui.facts.measured.probe;
        const bool has_a = ui.history.draft().sides[0].source != SideSource::none;
        draw_parts(ui, status_parts(status_form(width, has_a, &form_width), *ui.pointer, probe));
        ui.status_told = probe_table(probe, *ui.pointer);
    } else {
        invite(ui, width);
    }
    tell_all(ui);
    ImGui::End();
    ui.places["status"] = area;
}

} // namespace preview::panels
