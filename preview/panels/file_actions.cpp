#include "preview/panels/file_actions.h"

#include "preview/editor/commands.h"
#include "preview/panels/ui.h"

#include <filesystem>

namespace preview::panels {

namespace {

const GpuLookup& chosen_engine(const Ui& ui) {
    return *engine_lookups()[ui.export_engine];
}

/// Asks where to, and gives `write` a name with an ending.
void ask(Ui& ui, const char* title, const std::string& usual,
         void (*write)(Ui& ui, const std::string& path)) {
    const std::string ending = std::filesystem::path(usual).extension().string();
    ask_for_file(ui,
                 {.title = title,
                  .button = "Save",
                  .saves = true,
                  .chosen =
                      [&ui, ending, write](const std::string& path) {
                          const bool ends = std::filesystem::path(path).has_extension();
                          write(ui, ends ? path : path + ending);
                      }},
                 usual);
}

} // namespace

std::string usual_recipe_file(const Ui& ui) {
    const State& state = ui.history.draft();
    return state.recipe_path.empty() ? look_name(state) + ".json" : state.recipe_path;
}

std::string usual_lut_file(const Ui& ui) {
    return look_name(ui.history.draft()) + "-export.cube";
}

std::string usual_strip_file(const Ui& ui) {
    return look_name(ui.history.draft()) + "-" + std::string(chosen_engine(ui).name) + ".png";
}

std::string usual_picture_file(const Ui& ui) {
    return look_name(ui.history.draft()) + "-picture.png";
}

void export_lut(Ui& ui, const std::string& path) {
    begin_export(ui, [state = ui.history.draft(), choice = ui.exporting.lut, path] {
        return prepare_lut(state, choice, path);
    });
}

void export_strip(Ui& ui, const std::string& path) {
    begin_export(ui, [state = ui.history.draft(), choice = ui.exporting.strip,
                      &engine = *chosen_engine(ui).engine,
                      path] { return prepare_strip(state, engine, choice, path); });
}

void save_picture(Ui& ui, const std::string& path) {
    attempt_writing(ui, path, [&ui, path] { ui.save_picture_to = path; });
}

void ask_to_export_lut(Ui& ui) {
    ask(ui, "Export the look as a LUT", usual_lut_file(ui), &export_lut);
}

void ask_to_export_strip(Ui& ui, std::size_t engine) {
    ui.export_engine = engine;
    ui.exporting.strip = {}; // another engine may not have those nodes and bits
    ask(ui, "Export a strip", usual_strip_file(ui), &export_strip);
}

void ask_to_save_picture(Ui& ui) {
    ask(ui, "Save the picture", usual_picture_file(ui), &save_picture);
}

} // namespace preview::panels
