#include "preview/window/window_memory.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "preview/editor/folder_list.h"
#include "preview/editor/settings_folder.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace preview {

namespace {

using nlohmann::json;

constexpr std::string_view no_memory = "the window opens as for the first time, for this is not "
                                       "what a window remembers; it is kept as "
                                       "window.json.broken";
constexpr const char* broken_ending = ".broken";

// Desktops and windows are smaller, and sums of two do not overflow.
constexpr int farthest = 1 << 20;

int coordinate(const json& from, const char* name, int least) {
    return static_cast<int>(std::clamp(from.at(name).get<double>(), static_cast<double>(least),
                                       static_cast<double>(farthest)));
}

float number(const json& from, const char* name, float usual, float least, float most) {
    return std::clamp(from.value(name, usual), least, most);
}

} // namespace

std::string text_of(const WindowMemory& memory) {
    json out{{"maximised", memory.is_maximised},
             {"recent files", memory.recent},
             {"text scale", memory.text_scale},
             {"panels' width", memory.panels_width},
             {"strip of looks", {{"open", memory.has_strip}, {"folder", memory.strip_folder}}}};
    if (memory.area) {
        out["area"] = {{"x", memory.area->x},
                       {"y", memory.area->y},
                       {"width", memory.area->width},
                       {"height", memory.area->height}};
    }
    // Names of files need not be UTF-8, which JSON is.
    return out.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

WindowMemory memory_from(const std::string& text) {
    WindowMemory out;
    try {
        const json all = json::parse(text);
        if (const auto area = all.find("area"); area != all.end()) {
            out.area = {coordinate(*area, "x", -farthest), coordinate(*area, "y", -farthest),
                        coordinate(*area, "width", 1), coordinate(*area, "height", 1)};
        }
        out.is_maximised = all.value("maximised", out.is_maximised);
        out.recent = all.value("recent files", out.recent);
        out.recent.resize(std::min(out.recent.size(), editor::most_recent_files));
        out.text_scale =
            number(all, "text scale", out.text_scale, least_text_scale, most_text_scale);
        out.panels_width = number(all, "panels' width", out.panels_width, 0, most_panels_width);
        if (const auto strip = all.find("strip of looks"); strip != all.end()) {
            out.has_strip = strip->value("open", out.has_strip);
            out.strip_folder = strip->value("folder", out.strip_folder);
        }
    } catch (const json::exception&) {
        throw lutlib::Error(std::string(no_memory));
    }
    return out;
}

MemoryFile::MemoryFile(std::string path) : path_(std::move(path)) {
    std::error_code unknown;
    if (path_.empty() || !std::filesystem::exists(path_, unknown)) {
        return;
    }
    constexpr std::size_t most_bytes = std::size_t{1} << 16U;
    try {
        memory_ = memory_from(lutlib::io::read_file(path_, most_bytes));
    } catch (const lutlib::Error& error) {
        is_broken_ = true;
        notice_ = error.where().file.empty() ? error.in_file(path_).what() : error.what();
    }
}

void MemoryFile::keep(const WindowMemory& memory) {
    if (path_.empty() || (memory == memory_ && !is_broken_)) {
        return;
    }
    memory_ = memory;
    try {
        if (is_broken_) {
            std::error_code stays;
            std::filesystem::rename(path_, path_ + broken_ending, stays);
            is_broken_ = false;
        }
        lutlib::io::write_file(path_, text_of(memory));
    } catch (const lutlib::Error&) {
        path_.clear();
        throw;
    }
}

std::string memory_path() {
    const std::filesystem::path folder = editor::settings_folder();
    return folder.empty() ? std::string() : (folder / "window.json").string();
}

} // namespace preview
