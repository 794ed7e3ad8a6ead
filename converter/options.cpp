#include "converter/options.h"

#include "converter/reference.h"
#include "converter/report.h"
#include "lutlib/error.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/describe.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/recipe_file.h"
#include "lutlib/metrics/compare.h"
#include "lutlib/metrics/samples.h"
#include "lutlib/recipe/bake_recipe.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

namespace converter {
namespace {

template <class Rows>
std::string listed(const Rows& rows) {
    std::string out;
    for (const auto& row : rows) {
        out += (out.empty() ? "" : ", ") + std::string(row.name);
    }
    return out;
}

void complain_of(const std::vector<lutlib::Loss>& losses, const std::string& name) {
    for (const lutlib::Loss& loss : losses) {
        print("lutconv: " + one_line(name) + ": lost: " + loss_text(loss) + '\n',
              std::string(lutlib::io::standard_stream));
    }
}

// Vendors' keywords may change what a table means.
void complain_of_keywords(const lutlib::Lut& lut, const std::string& name) {
    for (const std::string& line : lut.keywords) {
        print("lutconv: " + one_line(name) + ": kept but not acted on: " + one_line(line) + '\n',
              std::string(lutlib::io::standard_stream));
    }
}

lutlib::Lut lut_from(const std::string& bytes, const std::string& path) {
    lutlib::Reading reading = lutlib::io::decode_lut(bytes, lutlib::io::input_name(path));
    complain_of(reading.losses, reading.lut.provenance);
    complain_of_keywords(reading.lut, reading.lut.provenance);
    return std::move(reading.lut);
}

// A recipe as a table, with what lies between the table's nodes measured.
lutlib::Reading baked(const lutlib::Recipe& recipe) {
    // Tables hold floats.
    constexpr double float_rounding = 2e-6;
    constexpr int finest_lattice = 33, spread_colours = 20000;
    lutlib::Reading out{bake_recipe(recipe), {}};
    const int lattice =
        out.lut.cube ? std::min(out.lut.cube->size, finest_lattice) : finest_lattice;
    const lutlib::Difference d =
        compare(lutlib::Transform::of(recipe),
                lutlib::Transform::of(out.lut, lutlib::Interpolation::tetrahedral),
                samples_over(out.lut.domain(), lattice, spread_colours), lutlib::srgb());
    if (d.absolute.max > float_rounding * std::max(1.0, largest_magnitude(d.worst.a))) {
        out.losses.push_back({"recipe sampled onto " + lutlib::io::shape_of(out.lut) +
                                  " over the input " + lutlib::io::domain_text(out.lut.domain()) +
                                  ", largest error",
                              d.absolute.max, ""});
    }
    return out;
}

// A file that OpenColorIO reads, from its own evaluation where a table of ours says less: operators
// and curves behind a cube, which a table only samples, and cubes that name their interpolation.
// Nothing where our reading says the same.
std::optional<lutlib::Transform> evaluation(const std::string& bytes, const std::string& path,
                                            const lutlib::Reading& reading,
                                            lutlib::Interpolation how) {
    if (!is_opencolorios(bytes, path) ||
        (how == lutlib::Interpolation::nearest && reading.losses.empty())) {
        return std::nullopt;
    }
    const lutlib::Transform transform = in_opencolorio(bytes, path, how);
    constexpr double float_rounding = 1e-6;
    const std::vector<lutlib::Rgb> inputs = lutlib::sample_colors(9, {.random = 2000});
    const std::vector<lutlib::RgbD> colors = images_of(transform, inputs);
    bool same = reading.losses.empty();
    for (std::size_t i = 0; same && i < inputs.size(); ++i) {
        const lutlib::RgbD ours = evaluate_exact(reading.lut, to_double(inputs[i]), how);
        same = largest_magnitude(ours - colors[i]) <=
               float_rounding * std::max(1.0, largest_magnitude(ours));
    }
    return same ? std::nullopt : std::optional(transform);
}

// Of the losses of a reading those that OpenColorIO's own evaluation has as well.
std::vector<lutlib::Loss> beyond_sampling(std::vector<lutlib::Loss> losses) {
    std::erase_if(losses, [](const lutlib::Loss& loss) { return loss.unit != "corrections"; });
    return losses;
}

} // namespace

void EngineOption::declare(CLI::App& app, const std::string& default_name) {
    name_ = default_name;
    app.add_option("--engine", name_, "one of: " + listed(lutlib::engines()))
        ->capture_default_str();
}

const lutlib::Engine& EngineOption::get() const {
    const lutlib::Engine* const engine = lutlib::engine_named(name_);
    if (!engine) {
        throw lutlib::UsageError("there is no engine '" + name_ + "'; there are " +
                                 listed(lutlib::engines()));
    }
    return *engine;
}

void InterpolationOption::declare(CLI::App& app, const std::string& help) {
    app.add_option_function<std::string>(
           "--interpolation",
           [this](const std::string& name) {
               name_ = name;
               given_ = true;
           },
           help + ": " + listed(lutlib::interpolations()))
        ->default_str(name_);
}

lutlib::Interpolation InterpolationOption::get() const {
    const auto how = lutlib::interpolation_named(name_);
    if (!how) {
        throw lutlib::UsageError("there is no interpolation '" + name_ + "'; there are " +
                                 listed(lutlib::interpolations()));
    }
    return *how;
}

lutlib::Lut read_lut(const std::string& path) {
    return lut_from(lutlib::io::read_file(path), path);
}

lutlib::Lut read_look(const std::string& path) {
    lutlib::Reading reading = read_look(path, {}, {});
    complain_of(reading.losses, lutlib::io::input_name(path));
    complain_of_keywords(reading.lut, lutlib::io::input_name(path));
    return std::move(reading.lut);
}

lutlib::Reading read_look(const std::string& path, const lutlib::ReadOptions& options,
                          const std::string& format) {
    const std::string bytes = lutlib::io::read_file(path);
    if (format.empty() && lutlib::io::is_recipe(bytes)) {
        return baked(lutlib::io::recipe_from(bytes, path, read_lut));
    }
    return lutlib::io::decode_lut(bytes, lutlib::io::input_name(path), options, format);
}

lutlib::Lut look_from(const std::string& bytes, const std::string& path) {
    return lutlib::io::is_recipe(bytes)
               ? bake_recipe(lutlib::io::recipe_from(bytes, path, read_lut))
               : lut_from(bytes, path);
}

Look open_look(const std::string& path, lutlib::Interpolation how) {
    const std::string bytes = lutlib::io::read_file(path);
    if (lutlib::io::is_recipe(bytes)) {
        const lutlib::Recipe recipe = lutlib::io::recipe_from(bytes, path, read_lut);
        const lutlib::Domain usual = recipe.base_lut ? recipe.base_lut->domain() : lutlib::Domain{};
        return {lutlib::Transform::of(recipe), recipe.bake.domain.value_or(usual), recipe.title};
    }
    const std::string name = lutlib::io::input_name(path);
    lutlib::Reading reading = lutlib::io::decode_lut(bytes, name);
    const lutlib::Domain domain = reading.lut.domain();
    const std::string title = reading.lut.title;
    if (const auto transform = evaluation(bytes, path, reading, how)) {
        complain_of(beyond_sampling(std::move(reading.losses)), name);
        return {*transform, domain, title};
    }
    complain_of(reading.losses, name);
    complain_of_keywords(reading.lut, name);
    const auto lut = std::make_shared<const lutlib::Lut>(std::move(reading.lut));
    return {lutlib::Transform::of(lut, how), domain, title};
}

void write_look(const lutlib::Lut& lut, const std::string& path) {
    complain_of(lutlib::io::write_lut(path, lut).losses, lutlib::io::output_name(path));
}

} // namespace converter
