// What the window's states have of look files, when those change on disk. Tables are replaced in
// every state, so that undo brings back what a person did and not what a file was; a recipe that
// changed is a step of its own.
#pragma once

#include "preview/editor/file_follower.h"

namespace preview::editor {

/// The files of the looks that the state shows, as they are to be read again: the recipe's, its
/// base's, the sides'. What is no file, as standard input, is left out.
std::vector<FollowedFile> followed_looks(const State& state);

/// The base at `path` is `lut` now, in every state that has it.
void take_base(History& history, const std::string& path,
               const std::shared_ptr<const lutlib::Lut>& lut, const std::vector<std::string>& told);

/// The recipe's file holds `look` now, and what base it names. Makes a step, or, where there are
/// unsaved changes, none and is false: what is unsaved is then told from the file as it is now.
bool take_recipe(History& history, const lutlib::io::Look& look);

/// A side's look is `fresh` now, in every state that has that file on a side.
void take_side(History& history, const Side& fresh);

/// Whether the recipe's file holds what was opened or saved last, or is not there: writing over it
/// loses nobody's changes.
bool is_file_as_saved(const State& state);

/// Whether `offered` has still to be chosen or not: its file is the recipe's, which is unsaved.
bool is_offered(const State& state, const lutlib::io::Look& offered);
/// A step to the recipe that was offered.
void take_offered(History& history, const lutlib::io::Look& offered);

} // namespace preview::editor
