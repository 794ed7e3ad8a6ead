// What the panel Files and the palette do with the look and the picture.
#pragma once

#include <cstddef>
#include <string>

namespace preview::panels {

struct Ui;

/// Files that are offered while nobody has named another.
std::string usual_recipe_file(const Ui& ui);
std::string usual_lut_file(const Ui& ui);
std::string usual_strip_file(const Ui& ui);
std::string usual_picture_file(const Ui& ui);

/// A LUT, and a strip for the chosen engine: each shows what it loses before it is written.
void export_lut(Ui& ui, const std::string& path);
void export_strip(Ui& ui, const std::string& path);
void save_picture(Ui& ui, const std::string& path);

// The same to a file that is chosen.
void ask_to_export_lut(Ui& ui);
/// For that one of engine_lookups(), which is then the chosen one.
void ask_to_export_strip(Ui& ui, std::size_t engine);
void ask_to_save_picture(Ui& ui);

} // namespace preview::panels
