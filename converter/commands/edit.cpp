// lutconv edit: operators on top of a LUT or of nothing, baked to a LUT and kept as a recipe.
#include "converter/command.h"
#include "converter/config_options.h"
#include "converter/idle_operators.h"
#include "converter/look_files.h"
#include "converter/recipe_options.h"
#include "converter/report.h"
#include "converter/result.h"
#include "converter/unused.h"
#include "converter/usage.h"
#include "lutlib/error.h"
#include "lutlib/io/correction_files.h"
#include "lutlib/io/file.h"
#include "lutlib/io/recipe_file.h"
#include "lutlib/limits.h"
#include "lutlib/named.h"
#include "lutlib/recipe/bake_recipe.h"
#include "lutlib/recipe/gamut_share.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <memory>

namespace converter {
namespace {

namespace io = lutlib::io;

struct EditOptions {
    std::string input, output, recipe, save_recipe, save_cdl, save_cdl_id, title, input_encoding,
        output_encoding, adaptation;
    ConfigOptions config;
    SamplingOptions sampling;
    OperatorFlags operators;
    double look_opacity = -1; ///< below 0: nobody said
    bool json = false;
};

// Light has no end of its own where the identity is converted: the output's codes of 0..1 say how
// much of it matters, and their curve where nodes are needed.
void suit_light(lutlib::Recipe& recipe) {
    const lutlib::Encoding out = recipe.output_encoding();
    if (recipe.input.curve->name != "linear" || out.curve == recipe.input.curve ||
        recipe.base_lut || !recipe.operations.empty() || recipe.bake.domain ||
        !recipe.bake.shaper.empty()) {
        return;
    }
    const auto low = static_cast<float>(out.decode(0)), high = static_cast<float>(out.decode(1));
    recipe.bake.domain = {{low, low, low}, {high, high, high}};
    recipe.bake.shaper = out.curve->name;
    recipe.bake.shaper_size = lutlib::limits::max_shaper_size;
}

// The recipe file, then LUT as its base, then the flags. `base`: where the base lies; `losses`:
// what files of corrections hold and operators do not.
lutlib::Recipe assemble(const EditOptions& o, std::string& base,
                        std::vector<lutlib::Loss>& losses) {
    lutlib::Recipe recipe;
    if (!o.recipe.empty()) {
        const io::Look read = open_look(o.recipe);
        if (!read.recipe()) {
            throw lutlib::Error("--recipe takes a recipe; this file is a LUT",
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
            if (const auto given = look.encodings().output; given && o.recipe.empty()) {
                recipe.input = *given;
            }
        }
    }
    if (!o.save_recipe.empty() && base == io::standard_stream) {
        throw lutlib::UsageError("--save-recipe needs the LUT as a file, not standard input");
    }
    if (!o.input_encoding.empty()) {
        recipe.input = encoding_of(o.input_encoding, "--input-encoding");
    }
    const auto given = recipe.base_lut ? encodings_of(recipe.base_lut->encodings).output
                                       : std::optional<lutlib::Encoding>();
    if (given && *given != recipe.input && !o.input_encoding.empty()) {
        print(fmt::format("lutconv: {} gives {}; --input-encoding {} is used instead\n",
                          input_text(base), given->name(), recipe.input.name()),
              std::string(io::standard_stream));
    }
    if (!o.output_encoding.empty()) {
        recipe.output = encoding_of(o.output_encoding, "--output-encoding");
    }
    if (!o.adaptation.empty()) {
        recipe.adaptation =
            &lutlib::require_named(lutlib::adaptations(), "adaptation", o.adaptation);
    }
    if (!o.title.empty()) {
        recipe.title = o.title;
    }
    const std::size_t first = recipe.operations.size();
    for (lutlib::Operation& operation : o.operators.operations(losses)) {
        recipe.operations.push_back(std::move(operation));
    }
    if (o.look_opacity >= 0) {
        recipe.opacity = o.look_opacity;
    }
    o.sampling.apply_to(recipe.bake);
    suit_light(recipe);
    tell_idle_operators(recipe, first);
    return recipe;
}

std::string edit_source(const EditOptions& o, const lutlib::Recipe& recipe) {
    const std::string base = o.input.empty() ? o.recipe : o.input;
    return fmt::format("{}, {} operator{}", o.config.given() ? o.config.text() : input_text(base),
                       recipe.operations.size(), recipe.operations.size() == 1 ? "" : "s");
}

// The config's conversion first, then the recipe, which then has no base.
lutlib::Transform exact_of(const EditOptions& o, const lutlib::Recipe& recipe) {
    return o.config.before(lutlib::Transform::of(recipe));
}

lutlib::Lut baked(const EditOptions& o, const lutlib::Recipe& recipe,
                  const lutlib::Transform& exact) {
    if (!o.config.given()) {
        return bake_recipe(recipe);
    }
    const lutlib::BakeSettings& bake = recipe.bake;
    lutlib::Lut lut = sample_like(
        {}, {bake.size, bake.domain, bake.shaper, bake.shaper_size, recipe.input}, exact, exact);
    lut.title = recipe.title;
    return lut;
}

std::string gamut_text(const lutlib::GamutShare& share, const lutlib::Recipe& recipe) {
    const lutlib::Encoding out = recipe.output_encoding();
    return fmt::format(
        "of the input's colours {:.1f} % lie outside {}, {:.1f} % above code 1 of {}",
        100 * share.outside, out.gamut->name, 100 * share.above, out.curve->name);
}

void tell_of_base(const std::string& recipe, const std::string& base) {
    if (recipe != io::standard_stream && io::has_base_outside(recipe, base)) {
        print(fmt::format("lutconv: {}: its base lies outside its folder: who opens it must add "
                          "--allow-outside; save the recipe beside {} to avoid that\n",
                          one_line(recipe), one_line(base)),
              std::string(io::standard_stream));
    }
}

void tell_losses(const std::string& of, const std::vector<lutlib::Loss>& losses) {
    for (const lutlib::Loss& loss : losses) {
        print(fmt::format("lutconv: {}: lost: {}\n", of, loss_text(loss)),
              std::string(io::standard_stream));
    }
}

// The file of --save-cdl, with the recipe's first CDL.
std::string cdl_of(const EditOptions& o, const lutlib::Recipe& recipe,
                   std::vector<lutlib::Loss>& losses) {
    const auto& operations = recipe.operations;
    const auto found =
        std::find_if(operations.begin(), operations.end(), [](const lutlib::Operation& operation) {
            return operation.op->name == "cdl";
        });
    if (found == operations.end()) {
        throw lutlib::UsageError("--save-cdl has nothing to write: the look has no operator cdl; "
                                 "add one, as by --cdl-slope 1.1,1,0.9");
    }
    lutlib::ColorCorrection correction =
        correction_of(recipe, static_cast<std::size_t>(found - operations.begin()), losses);
    correction.id = o.save_cdl_id;
    correction.description = recipe.title;
    // What is there is ours, or --force was given.
    return io::correction_bytes(o.save_cdl, correction, io::Unreadable::is_replaced);
}

// A recipe keeps how it is baked; a CDL does not.
void tell_unused_without_lut(const EditOptions& o, const Verb& verb) {
    const bool is_kept = !o.save_recipe.empty();
    const std::string why_not = "neither a LUT nor a recipe is written";
    tell_unused(verb, {{"--json", false, "its figures are those of a LUT: name one with -o"},
                       {"--size", is_kept, why_not},
                       {"--domain", is_kept, why_not},
                       {"--shaper", is_kept, why_not},
                       {"--shaper-size", is_kept, why_not},
                       {"--adaptation", is_kept, why_not}});
}

int run_edit(const EditOptions& o, const Verb& verb) {
    o.config.check();
    if (o.output.empty() && o.save_recipe.empty() && o.save_cdl.empty()) {
        throw lutlib::UsageError(
            "nothing to write: give -o LUT, --save-recipe R.json, --save-cdl C.ccc or several");
    }
    if (o.save_cdl.empty() && !o.save_cdl_id.empty()) {
        throw lutlib::UsageError("--save-cdl-id needs a --save-cdl");
    }
    if (o.input.empty() && o.recipe.empty()) {
        throw lutlib::UsageError("nothing to edit: give a LUT, the word identity, or --recipe");
    }
    require_one_standard_input(std::array{o.input, o.recipe});
    if (o.config.given() &&
        (o.input != "identity" || !o.save_recipe.empty() || !o.save_cdl.empty())) {
        throw lutlib::UsageError(
            "a recipe cannot keep an OpenColorIO config: beside --ocio-config, edit the word "
            "identity and leave out --save-recipe and --save-cdl");
    }
    const std::string shown = standard_output_of(std::array{o.output, o.save_recipe});
    std::string base;
    std::vector<lutlib::Loss> read, saved;
    const lutlib::Recipe recipe = assemble(o, base, read);
    tell_losses("--cdl-file", read);
    std::string text, cdl;
    std::vector<io::FileToWrite> others;
    if (!o.save_recipe.empty()) {
        text = io::recipe_text(recipe, o.save_recipe, base);
        others.push_back({o.save_recipe, text});
        tell_of_base(o.save_recipe, base);
    }
    if (!o.save_cdl.empty()) {
        cdl = cdl_of(o, recipe, saved);
        others.push_back({o.save_cdl, cdl});
        tell_losses(output_text(o.save_cdl), saved);
    }
    if (o.output.empty()) {
        tell_unused_without_lut(o, verb);
        io::write_files(others);
    } else {
        const lutlib::Transform exact = exact_of(o, recipe);
        const lutlib::Lut lut = baked(o, recipe, exact);
        tell_unused(verb,
                    {adaptation_part(recipe.input, recipe.output_encoding()), shaper_part(lut)});
        nlohmann::ordered_json extra{{"operators", recipe.operations.size()}};
        if (!read.empty() || !saved.empty()) {
            extra["cdl"] = {{"read", to_json(read)}, {"saved", to_json(saved)}};
        }
        std::vector<std::string> notes = notes_of(recipe);
        if (!o.config.given() && recipe.output_encoding().gamut != recipe.input.gamut) {
            const lutlib::GamutShare share = gamut_share(recipe, lut.domain());
            notes.push_back(gamut_text(share, recipe));
            extra["gamut"] = {{"outside", share.outside}, {"above", share.above}};
        }
        write_and_report({.lut = lut,
                          .output = o.output,
                          .shown = shown,
                          .made_of = edit_source(o, recipe),
                          .exact = exact,
                          .encoding = recipe.output_encoding(),
                          .notes = notes,
                          .others = others},
                         o.json, extra);
    }
    return ok;
}

} // namespace

Run declare_edit(Verb& verb) {
    const auto o = std::make_shared<EditOptions>();
    verb.add_option("LUT", o->input,
                    "a LUT or recipe file to edit, - for standard input, or the word identity");
    verb.add_output("-o,--output", o->output, "the baked LUT, or - for standard output");
    verb.add_option("--recipe", o->recipe, "operators to start from");
    verb.add_output("--save-recipe", o->save_recipe, "write the operators and their base here");
    verb.add_output("--save-cdl", o->save_cdl,
                    "write the look's first ASC CDL here: a .cc, or into the .ccc or .cdl that is "
                    "there; what it does not hold is said");
    verb.add_option("--save-cdl-id", o->save_cdl_id,
                    "id of what --save-cdl writes: the correction of that id is replaced");
    verb.add_option("--title", o->title, "title of the result");
    verb.add_option("--input-encoding", o->input_encoding,
                    encoding_help("what the operators' code values are (default: what the LUT says "
                                  "that it gives, else srgb)"));
    verb.add_option("--output-encoding", o->output_encoding,
                    "encoding of the result (default: as the input)");
    verb.add_option("--adaptation", o->adaptation,
                    "between the whites of different gamuts: " +
                        lutlib::names_of(lutlib::adaptations()) + " (default: the first)");
    verb.add_option("--look-opacity", o->look_opacity,
                    "how much of the whole look is taken, 0 to 1 (default: the recipe's, else 1)")
        .takes(Takes::share);
    o->config.declare(verb);
    o->sampling.declare(verb, true);
    verb.add_flag("--json", o->json, "print the results as JSON");
    o->operators.declare(verb);
    verb.footer("Operators apply in the order in which their flags are given, after the recipe's.");
    return [o, &verb] { return run_edit(*o, verb); };
}

} // namespace converter
