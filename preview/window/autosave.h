// The look that is being edited, kept beside the window's settings until it is saved, so that no
// end of the program loses it.
#pragma once

#include "preview/editor/model.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace preview {

class Autosave {
  public:
    /// In this folder; empty: nothing is kept.
    explicit Autosave(std::filesystem::path folder);

    /// The file of each look that a program has left here which ended without closing. Programs
    /// that still run are left alone.
    std::vector<std::string> found() const;

    /// Writes the recipe when it is unsaved and another than the last time; removes the file when
    /// it is saved. Throws lutlib::Error.
    void keep(const editor::State& state);
    /// The look in this file of found() is kept here from now on. Throws lutlib::Error where
    /// another window has taken it.
    void adopt(const std::filesystem::path& left);
    /// The window is closed by its user: what was not saved is not wanted.
    void forget();
    /// The file, where it holds a look now.
    const std::optional<std::filesystem::path>& kept() const { return kept_; }

  private:
    std::filesystem::path own_path() const;
    std::filesystem::path folder_;
    std::optional<std::filesystem::path> kept_;
    lutlib::Recipe last_;
};

} // namespace preview
