// A file chosen in a folder, among those of late, or by typing.
#pragma once

#include "preview/editor/folder_list.h"

#include <functional>
#include <string>

namespace preview::panels {

struct Ui;

struct FileDialog {
    std::string title;         ///< empty: it is not open
    std::string button;        ///< what choosing does
    bool saves = false;        ///< the file need not be there
    bool picks_folder = false; ///< the folder that is open is chosen, not a file
    std::string folder{};      ///< absolute
    std::string typed{};       ///< a name, or what narrows the list
    std::size_t kind = 0;
    bool wants_focus = false; ///< for what is typed
    std::size_t at = 0;       ///< the row that Enter takes where a file is opened
    editor::FolderList list{};
    std::string listed{}; ///< folder and kind that `list` is of
    std::function<void(const std::string& path)> chosen{};
};

/// Opens the dialog; `name` may have a folder, else it begins in the one of the newest file.
void ask_for_file(Ui& ui, FileDialog dialog, const std::string& name = {});
/// A look, picture or model to open.
void ask_to_open(Ui& ui);
/// Saves the recipe to a file that is chosen.
void ask_to_save(Ui& ui);
/// An ASC CDL for the look, or the look's into a file.
void ask_for_correction(Ui& ui);
void ask_to_save_correction(Ui& ui);

/// Draws it while it is open.
void file_dialog(Ui& ui);

} // namespace preview::panels
