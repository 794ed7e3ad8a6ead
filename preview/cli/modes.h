// What lutpreview can be asked to do: one function a mode.
#pragma once

#include "preview/cli/options.h"

namespace preview {

/// Does what the options ask for: the one of the modes below. Throws lutlib::Error, and UsageError
/// for options that do not go together. Whether all that was checked holds, where something was.
bool run(const Options& options);

/// Prints the tables and the devices.
void print_list();
/// Draws a look as the cube of its nodes into the output file.
void render_cube(const Options& options);
/// Renders one frame without a window into the output file, and prints what was asked for of it.
void render(const Options& options);
/// Opens the window until it is closed.
void open_window(const Options& options);

} // namespace preview
