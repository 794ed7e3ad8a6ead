#include "preview/editor/kept_cameras.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "preview/editor/settings_folder.h"
#include "preview/scene/camera_settings.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace preview::editor {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::size_t most_bytes = std::size_t{64} << 20U;
constexpr float farthest = 1e6F; // metres from the origin; sums of such are finite
constexpr float least_near = 1e-5F, most_near = 1e3F;

// Names of files need not be UTF-8, which JSON is.
std::string dump(const json& value) {
    return value.dump(2, ' ', false, json::error_handler_t::replace);
}

std::string key_of(const std::string& input) {
    std::error_code unknown;
    const fs::path whole = fs::absolute(input, unknown).lexically_normal();
    const bool is_file = scene_named(input) == nullptr && !unknown;
    return json::parse(dump(is_file ? whole.string() : input)).get<std::string>();
}

json json_of(const NamedCamera& camera) {
    const Orbit& orbit = camera.orbit;
    json out{{"name", camera.name},
             {"target", {orbit.target.x, orbit.target.y, orbit.target.z}},
             {"near", orbit.near_plane}};
    for (const NumberRow<Orbit>& row : camera_numbers()) {
        out[std::string(row.flag)] = row.value(orbit);
    }
    return out;
}

NamedCamera camera_from(const json& from) {
    NamedCamera out{from.at("name").get<std::string>(), {}};
    const json& target = from.at("target");
    for (int i = 0; i < 3; ++i) {
        out.orbit.target[i] =
            std::clamp(target.at(static_cast<std::size_t>(i)).get<float>(), -farthest, farthest);
    }
    out.orbit.near_plane =
        std::clamp(from.value("near", out.orbit.near_plane), least_near, most_near);
    for (const NumberRow<Orbit>& row : camera_numbers()) {
        float& number = row.of(out.orbit);
        number = std::clamp(from.value(std::string(row.flag), number), static_cast<float>(row.min),
                            static_cast<float>(row.max));
    }
    return out;
}

auto named(std::vector<NamedCamera>& cameras, const std::string& name) {
    return std::find_if(cameras.begin(), cameras.end(),
                        [&](const NamedCamera& camera) { return camera.name == name; });
}

std::string free_name(std::vector<NamedCamera>& cameras) {
    for (std::size_t number = 1;; ++number) {
        std::string out = "kept " + std::to_string(number);
        if (named(cameras, out) == cameras.end()) {
            return out;
        }
    }
}

/// Nothing when there is no file.
CamerasByInput cameras_at(const std::string& path) {
    std::error_code unknown;
    if (path.empty() || !fs::exists(path, unknown)) {
        return {};
    }
    try {
        return cameras_from(lutlib::io::read_file(path, most_bytes));
    } catch (const lutlib::Error& error) {
        throw lutlib::Error("mend or delete it (the next camera that is kept puts it aside): " +
                                error.message(),
                            {path, 0, {}});
    }
}

} // namespace

std::string text_of(const CamerasByInput& cameras) {
    json all = json::object();
    for (const auto& [input, list] : cameras) {
        json& out = all[input] = json::array();
        for (const NamedCamera& camera : list) {
            out.push_back(json_of(camera));
        }
    }
    return dump({{"cameras", all}}) + "\n";
}

CamerasByInput cameras_from(const std::string& text) {
    CamerasByInput out;
    try {
        const json all = json::parse(text);
        for (const auto& [input, list] : all.at("cameras").items()) {
            for (const json& camera : list) {
                out[input].push_back(camera_from(camera));
            }
        }
    } catch (const json::exception&) {
        throw lutlib::Error("these are no cameras that a window has kept");
    }
    return out;
}

KeptCameras::KeptCameras(std::string path) : path_(std::move(path)) {}

std::optional<KeptCameras::Stamp> KeptCameras::stamp() const {
    std::error_code no_time, no_size;
    const Stamp out{fs::last_write_time(path_, no_time), fs::file_size(path_, no_size)};
    return no_time || no_size ? std::nullopt : std::optional(out);
}

bool KeptCameras::is_outdated() const {
    return !path_.empty() && stamp() != taken_;
}

void KeptCameras::take_file() {
    if (path_.empty()) {
        return;
    }
    const bool was_broken = std::exchange(is_broken_, true);
    taken_ = stamp(); // before it is read: what is written meanwhile is read again
    try {
        cameras_ = cameras_at(path_);
        is_broken_ = false;
    } catch (const lutlib::Error&) {
        if (!was_broken) {
            throw;
        }
    }
}

std::vector<NamedCamera> KeptCameras::of(const std::string& input) {
    take_file();
    const auto found = cameras_.find(key_of(input));
    return found != cameras_.end() ? found->second : std::vector<NamedCamera>();
}

/// Under a name that nothing has, which it returns.
std::string KeptCameras::put_aside() const {
    std::string to = path_ + ".broken";
    std::error_code failed;
    for (int number = 2; fs::exists(fs::symlink_status(to, failed)); ++number) {
        to = path_ + ".broken" + std::to_string(number);
    }
    fs::rename(path_, to, failed);
    if (failed) {
        throw lutlib::Error("move it away, or delete it: " + failed.message(), {path_, 0, {}});
    }
    return to;
}

std::string KeptCameras::write() {
    std::string aside;
    if (path_.empty()) {
        return aside;
    }
    try {
        if (is_broken_) {
            aside = put_aside();
            is_broken_ = false;
        }
        lutlib::io::write_file(path_, text_of(cameras_));
        taken_ = stamp();
        return aside;
    } catch (const lutlib::Error& error) {
        path_.clear();
        throw lutlib::Error("write down the cameras that you keep, for they last until this "
                            "window closes: " +
                            std::string(error.what()));
    }
}

void KeptCameras::keep(const std::string& input, NamedCamera camera) {
    bool is_damaged_since = false;
    try {
        take_file();
    } catch (const lutlib::Error&) {
        is_damaged_since = true;
    }
    std::vector<NamedCamera>& list = cameras_[key_of(input)];
    if (camera.name.empty()) {
        camera.name = free_name(list);
    }
    if (const auto found = named(list, camera.name); found != list.end()) {
        found->orbit = camera.orbit;
    } else if (list.size() < most_of_one) {
        list.push_back(std::move(camera));
    } else {
        throw lutlib::Error("forget another camera of this scene first: it has " +
                            std::to_string(most_of_one));
    }
    const std::string aside = write();
    if (is_damaged_since) {
        throw lutlib::Error("look after what others have put in the place of the cameras that are "
                            "kept, which is in " +
                            aside + " now: those that this window knows are kept again");
    }
}

void KeptCameras::forget(const std::string& input, const std::string& name) {
    take_file();
    const auto list = cameras_.find(key_of(input));
    if (list == cameras_.end()) {
        return;
    }
    const auto found = named(list->second, name);
    if (found == list->second.end()) {
        return;
    }
    list->second.erase(found);
    if (list->second.empty()) {
        cameras_.erase(list);
    }
    write();
}

std::string cameras_path() {
    const fs::path folder = settings_folder();
    return folder.empty() ? std::string() : (folder / "cameras.json").string();
}

std::vector<NamedCamera> cameras_kept_of(const std::string& input) {
    return KeptCameras(cameras_path()).of(input);
}

} // namespace preview::editor
