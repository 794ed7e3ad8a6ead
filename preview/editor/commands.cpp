#include "preview/editor/commands.h"

#include "lutlib/error.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/look_text.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/io/recipe_file.h"
#include "lutlib/recipe/bake_recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace preview::editor {

namespace {

namespace fs = std::filesystem;
namespace io = lutlib::io;

std::string source_name(const State& state) {
    return state.recipe_path.empty() ? "the recipe" : state.recipe_path;
}

} // namespace

void open_look(State& state, const io::Look& look, const lutlib::LookEncodings& said) {
    State next = state;
    const bool is_recipe = look.recipe() != nullptr;
    next.recipe = look.as_recipe();
    next.recipe.title = look.title();
    next.solo.reset();
    next.saved = next.recipe;
    next.told = told_of(look);
    next.said = said;
    next.recipe_path = is_recipe ? look.path() : "";
    next.base_path = is_recipe ? io::base_path(next.recipe, look.path()) : look.path();
    const auto shows_recipe = [](const Side& side) {
        return side.source == SideSource::recipe || side.source == SideSource::baked;
    };
    if (!shows_recipe(next.sides[0]) && !shows_recipe(next.sides[1])) {
        next.sides[1].source = SideSource::recipe;
    }
    state = std::move(next);
}

void open_side(Side& side, const io::Look& look, const lutlib::LookEncodings& said) {
    side.lut = look.table().lut;
    side.path = look.path();
    side.files.clear();
    for (const io::LookFile& file : look.files()) {
        side.files.push_back(file.name);
    }
    side.said = said;
    side.told = told_of(look);
    side.source = SideSource::file;
}

std::string look_name(const State& state) {
    const std::string& path = !state.recipe_path.empty() ? state.recipe_path : state.base_path;
    return path.empty() ? "look" : fs::path(path).stem().string();
}

void save_recipe(History& history, const std::string& path) {
    State& state = history.draft();
    io::save_recipe(state.recipe, path, state.base_path);
    state.recipe_path = path;
    history.mark_saved();
}

std::string export_strip(const State& state, const Side& side, const std::string& path) {
    const lutlib::Engine& engine = *side.engine->engine;
    const lutlib::LookPlace place =
        io::place_in(engine, encodings_of(state.recipe), state.picture.convert);
    const lutlib::Transform look = place.applied().around(lutlib::Transform::of(state.recipe));
    const lutlib::Bake baked =
        lutlib::bake(look, engine, side.size > 0 ? side.size : engine.default_size,
                     side.bits > 0 ? side.bits : engine.default_bits);
    io::write_file(path, io::picture_bytes(baked, {.source = source_name(state),
                                                   .title = state.recipe.title,
                                                   .interpolation = "tetrahedral",
                                                   .encodings = names_of(place.shown()),
                                                   .look = names_of(place.look)}));
    const lutlib::Breaks breaks = io::placed(
        united(lutlib::no_breaks(),
               state.recipe.base_lut ? breaks_of(*state.recipe.base_lut) : lutlib::Breaks{}),
        place.applied());
    const lutlib::Viewing viewing = io::viewing_of(place);
    const lutlib::Domain usual =
        state.recipe.base_lut ? state.recipe.base_lut->domain() : lutlib::Domain{};
    return io::bake_report(
        source_name(state), path, baked, state.recipe.bake.domain.value_or(usual), place,
        lutlib::measure_lookup(baked.picture, engine, baked.size, look, breaks, viewing), viewing);
}

std::string strip_in(const std::string& folder, const State& state) {
    return (fs::path(folder) / (look_name(state) + ".png")).string();
}

bool is_replaceable(const State& state, const std::string& path) {
    std::error_code unknown;
    if (!fs::exists(fs::symlink_status(path, unknown))) {
        return true;
    }
    return fs::is_regular_file(path, unknown) && !fs::equivalent(path, state.base_path, unknown) &&
           io::is_own_picture(path);
}

std::string export_lut(const State& state, const std::string& path) {
    lutlib::Lut lut = lutlib::bake_recipe(state.recipe);
    lut.title = state.recipe.title;
    const io::Encoded written = io::write_lut(path, lut);
    std::string report = fmt::format("{} -> {}\n", source_name(state), path);
    if (written.losses.empty()) {
        report += "  nothing was lost to the format\n";
    }
    for (const lutlib::Loss& loss : written.losses) {
        report += fmt::format("  lost: {}: {:.4g} {}\n", loss.what, loss.figure, loss.unit);
    }
    return report;
}

} // namespace preview::editor
