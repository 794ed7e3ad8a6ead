// Cameras that a person has kept, by what they look at, in a file beside the window's settings.
#pragma once

#include "preview/scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace preview::editor {

/// By the scene's name or the model's whole path, each in the order in which they were kept.
using CamerasByInput = std::map<std::string, std::vector<NamedCamera>>;

/// As cameras_from() reads it.
std::string text_of(const CamerasByInput& cameras);
/// Of a file's text; numbers beyond their range are brought into it, what is missing is as usual.
/// Throws lutlib::Error when it is no such text.
CamerasByInput cameras_from(const std::string& text);

/// The cameras in their file, which other windows write, too: every step begins with what is there.
class KeptCameras {
  public:
    static constexpr std::size_t most_of_one = 100;

    /// Empty: they are kept until the window closes.
    explicit KeptCameras(std::string path);

    /// Of what goes by that name on the command line. Throws lutlib::Error once when the file is
    /// there and cannot be read; then those of this window alone are known.
    std::vector<NamedCamera> of(const std::string& input);
    /// Whether somebody else has written the file, or taken it away, since it was read or written.
    bool is_outdated() const;
    /// In place of one of the same name; without a name it gets one. A file that cannot be read is
    /// put aside first. Throws lutlib::Error where that is so since of(), and all is kept; where
    /// nothing can be written (and tries no more: it is
    /// kept until the window closes), or there are too many.
    void keep(const std::string& input, NamedCamera camera);
    /// Throws lutlib::Error likewise.
    void forget(const std::string& input, const std::string& name);

  private:
    /// What tells one state of the file from the next; empty: there is none.
    struct Stamp {
        std::filesystem::file_time_type time;
        std::uintmax_t size = 0;
        friend bool operator==(const Stamp&, const Stamp&) = default;
    };
    std::optional<Stamp> stamp() const;
    void take_file();
    std::string put_aside() const;
    /// Where it has put what was no cameras; empty: nothing.
    std::string write();

    std::string path_;
    bool is_broken_ = false; ///< what is there are no cameras
    CamerasByInput cameras_;
    std::optional<Stamp> taken_; ///< of the file as it was read or written last
};

/// Where they are kept. Empty when there is no settings_folder().
std::string cameras_path();

/// Those of the file, for a program without a window. Throws lutlib::Error.
std::vector<NamedCamera> cameras_kept_of(const std::string& input);

} // namespace preview::editor
