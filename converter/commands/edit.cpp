// lutconv edit: operators on top of a LUT or of nothing, baked to a LUT and kept as a recipe.
#include "converter/command.h"
#include "converter/look_files.h"
#include "converter/recipe_options.h"
#include "converter/report.h"
#include "converter/result.h"
#include "converter/usage.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/recipe_file.h"
#include "lutlib/recipe/bake_recipe.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <array>
#include <memory>

namespace converter {
namespace {

namespace io = lutlib::io;

struct Options {
    std::string input, output, recipe, save_recipe, title, input_encoding, output_encoding;
    SamplingOptions sampling;
    OperatorFlags operators;
    bool json = false;
};

// The recipe file, then LUT as its base, then the flags. `base`: where the base lies.
lutlib::Recipe assemble(const Options& o, std::string& base) {
    lutlib::Recipe recipe;
    if (!o.recipe.empty()) {
        const io::Look read = open_look(o.recipe);
        if (!read.recipe()) {
            throw lutlib::Error("--recipe takes a recipe, and this is a LUT",
                                {io::input_name(o.recipe), 0, {}});
        }
        recipe = *read.recipe();
        base = io::base_path(recipe, o.recipe);
    }
    if (!o.input.empty() && o.input != "identity") {
        const io::Look look = open_look(o.input);
        if (look.recipe() && !o.recipe.empty()) {
            throw lutlib::UsageError("there are two recipes, '" + o.input + "' and '" + o.recipe +
                                     "'; edit one");
        }
        lutlib::Recipe read = recipe_of(look);
        base = look.recipe() ? io::base_path(read, o.input) : o.input;
        if (look.recipe()) {
            recipe = std::move(read);
        } else {
            recipe.base_lut = read.base_lut;
        }
    }
    if (!o.save_recipe.empty() && base == io::standard_stream) {
        throw lutlib::UsageError("--save-recipe needs the LUT as a file, not standard input");
    }
    if (!o.input_encoding.empty()) {
        recipe.input = &encoding_of(o.input_encoding);
    }
    if (!o.output_encoding.empty()) {
        recipe.output = &encoding_of(o.output_encoding);
    }
    if (!o.title.empty()) {
        recipe.title = o.title;
    }
    for (lutlib::Operation& operation : o.operators.operations()) {
        recipe.operations.push_back(std::move(operation));
    }
    o.sampling.apply_to(recipe.bake);
    return recipe;
}

std::string made_of(const Options& o, const lutlib::Recipe& recipe) {
    const std::string base = o.input.empty() ? o.recipe : o.input;
    return fmt::format("{}, {} operator{}", input_text(base), recipe.operations.size(),
                       recipe.operations.size() == 1 ? "" : "s");
}

int run(const Options& o) {
    if (o.output.empty() && o.save_recipe.empty()) {
        throw lutlib::UsageError("nothing to write: give -o LUT, --save-recipe R.json or both");
    }
    if (o.input.empty() && o.recipe.empty()) {
        throw lutlib::UsageError("nothing to edit: give a LUT, the word identity, or --recipe");
    }
    require_one_standard_input(std::array{o.input, o.recipe});
    const std::string shown = standard_output_of(std::array{o.output, o.save_recipe});
    std::string base;
    const lutlib::Recipe recipe = assemble(o, base);
    if (!o.save_recipe.empty()) {
        io::save_recipe(recipe, o.save_recipe, base);
    }
    if (!o.output.empty()) {
        const lutlib::Lut lut = bake_recipe(recipe);
        write_and_report({lut,
                          o.output,
                          shown,
                          made_of(o, recipe),
                          lutlib::Transform::of(recipe),
                          recipe.output_encoding(),
                          {}},
                         o.json, {{"operators", recipe.operations.size()}});
    }
    return ok;
}

} // namespace

Run declare_edit(CLI::App& app) {
    const auto o = std::make_shared<Options>();
    app.add_option("LUT", o->input,
                   "a LUT or recipe file to edit, - for standard input, or the word identity");
    app.add_option("-o,--output", o->output, "the baked LUT, or - for standard output");
    app.add_option("--recipe", o->recipe, "operators to start from");
    app.add_option("--save-recipe", o->save_recipe, "write the operators and their base here");
    app.add_option("--title", o->title, "title of the result");
    app.add_option("--input-encoding", o->input_encoding,
                   "what the operators' code values are: " + encoding_names());
    app.add_option("--output-encoding", o->output_encoding,
                   "encoding of the result (default: as the input)");
    o->sampling.declare(app, true);
    app.add_flag("--json", o->json, "print the figures as JSON");
    o->operators.declare(app);
    app.footer("Operators apply in the order in which their flags are given, after the recipe's.");
    return [o] { return run(*o); };
}

} // namespace converter
