#include "preview/editor/commands.h"

#include "lutlib/error.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/io/recipe_file.h"
#include "lutlib/recipe/bake_recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace preview::ui {

namespace {

namespace io = lutlib::io;

lutlib::Lut lut_at(const std::string& path) {
    return io::read_lut(path).lut;
}

std::string source_name(const State& state) {
    return state.recipe_path.empty() ? "the recipe" : state.recipe_path;
}

} // namespace

bool is_look_file(const std::string& path) {
    const std::string bytes = io::read_file(path);
    if (io::is_recipe(bytes))
        return true;
    try {
        io::decode_lut(bytes, path);
        return true;
    } catch (const lutlib::Error&) {
        // A file that says that it is a LUT is one, however broken; its error is for open_look().
        const std::string extension = io::extension_of(path);
        const auto formats = io::file_formats();
        return std::any_of(formats.begin(), formats.end(), [&](const lutlib::FileFormat* format) {
            return format->extensions.contain(extension) && !format->picture;
        });
    }
}

void open_look(State& state, const std::string& path) {
    const std::string bytes = io::read_file(path);
    State next = state;
    if (io::is_recipe(bytes)) {
        next.recipe = io::recipe_from(bytes, path, lut_at);
        next.recipe_path = path;
        next.base_path = io::base_path(next.recipe, path);
    } else {
        next.recipe = {};
        io::set_base(next.recipe, path, lut_at);
        next.recipe.title = next.recipe.base_lut->title;
        next.recipe_path.clear();
        next.base_path = path;
    }
    const auto shows_recipe = [](const Side& side) {
        return side.source == SideSource::recipe || side.source == SideSource::baked;
    };
    if (!shows_recipe(next.sides[0]) && !shows_recipe(next.sides[1]))
        next.sides[1].source = SideSource::recipe;
    state = std::move(next);
}

void open_side(Side& side, const std::string& path) {
    side.lut = std::make_shared<const lutlib::Lut>(lut_at(path));
    side.path = path;
    side.source = SideSource::file;
}

void save_recipe(State& state, const std::string& path) {
    io::save_recipe(state.recipe, path, state.base_path);
    state.recipe_path = path;
}

std::string export_strip(const State& state, const Side& side, const std::string& path) {
    const lutlib::Engine& engine = *side.engine->engine;
    const lutlib::Transform look = lutlib::Transform::of(state.recipe);
    const lutlib::Bake baked =
        lutlib::bake(look, engine, side.size > 0 ? side.size : engine.default_size,
                     side.bits > 0 ? side.bits : engine.default_bits);
    io::write_file(
        path, io::picture_bytes(baked, {source_name(state), state.recipe.title, "tetrahedral"}));
    const lutlib::Domain usual =
        state.recipe.base_lut ? state.recipe.base_lut->domain() : lutlib::Domain{};
    return io::bake_report(source_name(state), path, baked,
                           state.recipe.bake.domain.value_or(usual), io::measure_bake(baked, look));
}

std::string export_lut(const State& state, const std::string& path) {
    lutlib::Lut lut = lutlib::bake_recipe(state.recipe);
    lut.title = state.recipe.title;
    const io::Encoded written = io::write_lut(path, lut);
    std::string report = fmt::format("{} -> {}\n", source_name(state), path);
    if (written.losses.empty())
        report += "  nothing was lost to the format\n";
    for (const lutlib::Loss& loss : written.losses)
        report += fmt::format("  lost: {}: {:.4g} {}\n", loss.what, loss.figure, loss.unit);
    return report;
}

} // namespace preview::ui
