// A recipe: a look as an ordered list of operators with values, on top of an optional base LUT.
//
// In JSON, every key but the first and "operators" optional:
//
//   {
//     "schema_version": 1,
//     "title": "Warm teal",
//     "input": "srgb",             what the operators' code values are: a curve or curve/gamut,
//                                  see encoding_named()
//     "output": "srgb",            what the result is encoded in; default: as the input
//     "adaptation": "bradford",    between the whites of different gamuts; or cat02
//     "base": "look.cube",         applied first; "input" is then the encoding of its output
//     "opacity": 0.8,              of the whole look: 0 only converts the encodings
//     "bake": {
//       "size": 33,                nodes per axis; default: the base's, else 33
//       "domain": [0, 1],          numbers, or [r, g, b] each; default: the base's, else 0..1
//       "shaper": "none",          none, base, tone, or an encoding; see bake_recipe.h
//       "shaper_size": 4096
//     },
//     "operators": [
//       {"op": "exposure", "stops": 0.5, "opacity": 0.7},
//       {"op": "hue-vs-sat", "enabled": false, "curve": [[0, 1], [120, 1.4]]}
//     ]
//   }
//
// A parameter that is left out has its default. An rgb parameter is [r, g, b] or one number for all
// three, a toggle true or false, a curve a list of [x, y].
#pragma once

#include "lutlib/color/encoding.h"
#include "lutlib/lut.h"
#include "lutlib/ops/op.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib {

/// What BakeSettings::shaper may be: tone, and shaper_names().
std::vector<std::string_view> recipe_shaper_names();

/// How a recipe becomes a LUT. Unset members are taken from the base, else from the defaults above.
struct BakeSettings {
    std::optional<int> size;
    std::optional<Domain> domain;
    std::string shaper; ///< empty: base where the base has one, else none
    int shaper_size = 4096;
    friend bool operator==(const BakeSettings&, const BakeSettings&) = default;
};

struct Recipe {
    std::string title;
    Encoding input = srgb();
    bool states_input = false;      ///< the file does; else a base that says what it gives decides
    std::optional<Encoding> output; ///< none: as the input
    const Adaptation* adaptation = &bradford;
    std::string base; ///< the base's file, as written in the recipe
    std::shared_ptr<const Lut> base_lut;
    BakeSettings bake;
    std::vector<Operation> operations;
    /// How much of the look is taken, 0..1. The rest is what it is without base and operators:
    /// what it takes, converted to what it gives. They are mixed as codes of the result.
    double opacity = 1;

    Encoding output_encoding() const { return output.value_or(input); }
};

/// What the whole look takes and gives: a base's encodings are what its file says, and a result
/// that keeps the encoding of an unknown base is unknown.
LookEncodings encodings_of(const Recipe& recipe);

/// What remains of a recipe at opacity 0: the conversion of what the look takes to what it gives.
Recipe without_look(const Recipe& recipe);

/// What the recipe's operators are compiled for.
OpContext context_of(const Recipe& recipe);

/// The operator that ends the recipe with its matte, or null.
const Op* matte_of(const Recipe& recipe);

/// What whoever uses the recipe should know of its operators' values, a sentence each without its
/// full stop.
std::vector<std::string> notes_of(const Recipe& recipe);

/// Throws Error with the file, the line for broken JSON, else the JSON path, for anything unknown,
/// of a wrong kind or out of range. `base` is only named: the caller reads it into base_lut.
Recipe parse_recipe(std::string_view json, const std::string& file);

/// Readable and diffable: one operator or one parameter a line, defaults left out, numbers in the
/// shortest form that reads back the same.
std::string to_json(const Recipe& recipe);

} // namespace lutlib
