#include "preview/editor/look_export.h"

#include "lutlib/io/bake_report.h"
#include "lutlib/io/describe.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/look.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/metrics/compare.h"
#include "lutlib/recipe/bake_recipe.h"
#include "lutlib/resample/resample.h"
#include "lutlib/resample/sample_lut.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace preview::editor {

namespace {

namespace io = lutlib::io;

// Tables hold floats; text formats round to six decimals.
constexpr double rounding = 2e-6;

std::string source_name(const State& state) {
    return state.recipe_path.empty() ? "the recipe" : state.recipe_path;
}

/// Where the recipe itself may bend.
lutlib::Breaks breaks_of(const lutlib::Recipe& recipe) {
    return united(lutlib::no_breaks(),
                  recipe.base_lut ? lutlib::breaks_of(*recipe.base_lut) : lutlib::Breaks{});
}

/// The recipe as a table of the size and between the encodings that were chosen.
lutlib::Lut table_of(const lutlib::Recipe& recipe, const ExportChoice& choice,
                     const lutlib::Placement& placement) {
    lutlib::Recipe sized = recipe;
    if (choice.size > 0) {
        sized.bake.size = choice.size;
    }
    lutlib::Lut lut = lutlib::bake_recipe(sized);
    if (placement.converts()) {
        const int size = choice.size > 0 ? choice.size
                         : lut.cube      ? lut.cube->size
                                         : recipe.bake.size.value_or(lutlib::usual_cube_size);
        lut.cube = lutlib::sample_cube(placement.around(lutlib::Transform::of(recipe)), {}, size);
        lut.shaper.reset();
        lut.interpolation.reset();
    }
    lut.title = recipe.title;
    return lut;
}

/// How the file is read again.
struct ReadBack {
    lutlib::Transform look;
    lutlib::Breaks breaks;
};
ReadBack read_back(const io::Encoded& file, const lutlib::FileFormat& format) {
    const auto lut = std::make_shared<const lutlib::Lut>(file.lut);
    if (file.losses.empty() || !format.read) {
        return {lutlib::Transform::of(lut), lutlib::breaks_of(*lut)};
    }
    const io::Look look = io::Look::of_bytes(file.bytes, "the file." + format.extensions.first(),
                                             {.format = std::string(format.name)});
    return {look.exact(), look.breaks()};
}

} // namespace

PreparedExport prepare_lut(const State& state, const ExportChoice& choice,
                           const std::string& path) {
    const lutlib::Recipe& recipe = state.recipe;
    const lutlib::LookPlace place{encodings_of(recipe), choice.encodings.input,
                                  choice.encodings.output};
    const lutlib::Placement placement = place.applied();
    lutlib::Lut lut = table_of(recipe, choice, placement);
    lut.encodings = names_of(place.shown());
    const lutlib::FileFormat& format = io::format_for_writing(path, lut);
    io::Encoded file = io::encode_lut(lut, format);
    const lutlib::Viewing viewing = io::viewing_of(place);
    const ReadBack read = read_back(file, format);
    const lutlib::Domain domain = lut.domain();
    const lutlib::Difference error = measure(
        placement.around(lutlib::Transform::of(recipe)), read.look,
        error_samples(domain, united(io::placed(breaks_of(recipe), placement), read.breaks)),
        viewing);
    PreparedExport out{.path = path, .bytes = std::move(file.bytes)};
    out.loses = error.absolute.max > rounding ||
                std::any_of(file.losses.begin(), file.losses.end(), [](const lutlib::Loss& loss) {
                    return !lutlib::is_float_rounding(loss);
                });
    out.report = fmt::format("{} -> {}\n  {}: {}\n", source_name(state), path, format.label,
                             io::shape_of(file.lut));
    if (placement.converts()) {
        out.report += "  " + placement.text() + "\n";
    }
    for (const lutlib::Loss& loss : file.losses) {
        out.report += fmt::format("  lost: {}: {:.4g} {}\n", loss.what, loss.figure, loss.unit);
    }
    for (const std::string& reader : file.readers) {
        out.report += "  " + reader + "\n";
    }
    out.report += out.loses ? "  how far the file is from the look:\n" +
                                  io::figures_text(error, viewing, "    ")
                            : "  nothing is lost: the file is the look to six decimals\n";
    return out;
}

PreparedExport prepare_strip(const State& state, const lutlib::Engine& engine,
                             const ExportChoice& choice, const std::string& path) {
    const lutlib::LookPlace place =
        io::place_in(engine, encodings_of(state.recipe), state.picture.convert);
    const lutlib::Transform look = place.applied().around(lutlib::Transform::of(state.recipe));
    const lutlib::Bake baked =
        lutlib::bake(look, engine, choice.size > 0 ? choice.size : engine.default_size,
                     choice.bits > 0 ? choice.bits : engine.default_bits);
    const lutlib::Viewing viewing = io::viewing_of(place);
    const lutlib::Domain usual =
        state.recipe.base_lut ? state.recipe.base_lut->domain() : lutlib::Domain{};
    const lutlib::Difference error =
        lutlib::measure_lookup(baked.picture, engine, baked.size, look,
                               io::placed(breaks_of(state.recipe), place.applied()), viewing);
    PreparedExport out{.path = path,
                       .bytes = io::picture_bytes(baked, {.source = source_name(state),
                                                          .title = state.recipe.title,
                                                          .interpolation = "tetrahedral",
                                                          .encodings = names_of(place.shown()),
                                                          .look = names_of(place.look)})};
    out.loses = error.absolute.max > rounding;
    out.report = io::bake_report(source_name(state), path, baked,
                                 state.recipe.bake.domain.value_or(usual), place, error, viewing);
    return out;
}

void write(const PreparedExport& prepared) {
    io::write_file(prepared.path, prepared.bytes);
}

} // namespace preview::editor
