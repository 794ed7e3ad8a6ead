#include "preview/window/gui.h"

#include "preview/editor/settings_folder.h"
#include "preview/panels/theme.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui/backends/imgui_impl_glfw.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace preview {

namespace {

constexpr float font_size = 14;

/// Dear ImGui asserts that a font file is there and is one.
bool is_font(const std::string& path) {
    char start[4] = {};
    std::ifstream(path, std::ios::binary).read(start, sizeof start);
    const std::string_view magic(start, sizeof start);
    return magic == std::string_view("\0\1\0\0", 4) || magic == "OTTO" || magic == "ttcf";
}

} // namespace

Gui::Gui(GLFWwindow* window, std::string layout_path, const std::string& font)
    : window_(window), layout_path_(std::move(layout_path)), font_path_(font) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = layout_path_.empty() ? nullptr : layout_path_.c_str();
    if (!is_font(font)) {
        font_path_.clear();
        notice_ =
            "the font " + font +
            " is missing or is not a font (Debian: fonts-dejavu-core); using the built-in font";
    }
    ImGui_ImplGlfw_InitForVulkan(window, false);
}

void Gui::set_scale(float scale) {
    scale_ = scale;
    ImGuiIO& io = ImGui::GetIO();
    // The window's coordinates are not its pixels everywhere.
    int window = 0, framebuffer = 0;
    glfwGetWindowSize(window_, &window, nullptr);
    glfwGetFramebufferSize(window_, &framebuffer, nullptr);
    const float pixels = window > 0 && framebuffer > 0
                             ? static_cast<float>(framebuffer) / static_cast<float>(window)
                             : 1;
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    panels::apply_theme();
    style.WindowRounding = 0;
    style.FrameRounding = 3;
    style.ScaleAllSizes(scale / pixels);
    io.FontGlobalScale = 1 / pixels;
    io.Fonts->Clear();
    const float size = std::round(font_size * scale);
    if (font_path_.empty() || io.Fonts->AddFontFromFileTTF(font_path_.c_str(), size) == nullptr) {
        ImFontConfig built_in;
        built_in.SizePixels = size;
        io.Fonts->AddFontDefault(&built_in);
    }
}

Gui::~Gui() {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Gui::feed(const editor::InputEvent& event) {
    using Kind = editor::InputEvent::Kind;
    ImGuiIO& io = ImGui::GetIO();
    held_ = event.held;
    switch (event.kind) {
    case Kind::move:
        mouse_x_ = event.x;
        mouse_y_ = event.y;
        break;
    case Kind::wheel:
        io.MouseWheelH += event.x;
        io.MouseWheel += event.y;
        break;
    case Kind::button:
        if (const auto index = static_cast<std::size_t>(event.code); index < buttons_.size()) {
            buttons_[index] = event.down;
        }
        break;
    case Kind::key:
        ImGui_ImplGlfw_KeyCallback(window_, event.code, event.scancode,
                                   event.down ? GLFW_PRESS : GLFW_RELEASE, event.modifiers);
        break;
    case Kind::character:
        io.AddInputCharacter(static_cast<unsigned>(event.code));
        break;
    }
}

void Gui::begin_frame(const std::vector<editor::InputEvent>& events) {
    for (const editor::InputEvent& event : events) {
        feed(event);
    }
    ImGui_ImplGlfw_NewFrame();
    // The backend looks at where the mouse is now; the events tell where it was.
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {mouse_x_, mouse_y_};
    for (std::size_t i = 0; i < buttons_.size(); ++i) {
        io.MouseDown[i] = buttons_[i];
    }
    io.KeyCtrl = held_.ctrl;
    io.KeyShift = held_.shift;
    io.KeyAlt = held_.alt;
    io.KeySuper = held_.super;
    ImGui::NewFrame();
}

std::string layout_path() {
    const std::filesystem::path folder = editor::settings_folder();
    return folder.empty() ? std::string() : (folder / "layout.ini").string();
}

} // namespace preview
