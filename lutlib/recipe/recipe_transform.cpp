
#include "lutlib/color/oklab.h"
#include "lutlib/color/powers.h"
#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/recipe/recipe.h"
#include "lutlib/transform.h"

#include <algorithm>
#include <array>

namespace lutlib {
namespace {

void hold(std::span<RgbD> colors) {
    for (RgbD& c : colors) {
        c = {held(c.r), held(c.g), held(c.b)};
    }
}

Transform through(const Matrix3& m) {
    return Transform::each([m](RgbD c) { return m * c; });
}

Transform oklab_from_linear(const Matrix3& cones) {
    return Transform::batch([cones](std::span<RgbD> colors) {
        for (RgbD& c : colors) {
            c = cones * c;
        }
        cube_root_all({&colors.front().r, 3 * colors.size()});
        for (RgbD& c : colors) {
            c = oklab_lms_to_lab * c;
        }
    });
}

Transform linear_from_oklab(const Matrix3& cones) {
    return Transform::each([m = inverse(cones)](RgbD c) { return m * lms_from_oklab(c); });
}

void append_conversion(std::vector<Transform>& stages, const Encoding& input, Space from,
                       Space to) {
    if (from == to) {
        return;
    }
    const Matrix3 cones = oklab_cones(input.primaries());
    if (from == Space::codes) {
        stages.push_back(Transform::batch(input.curve->decode_all));
    } else if (from == Space::oklab) {
        stages.push_back(linear_from_oklab(cones));
    }
    if (to == Space::oklab) {
        stages.push_back(oklab_from_linear(cones));
    } else if (to == Space::codes) {
        stages.push_back(Transform::batch(input.curve->encode_all));
    }
}

void mix(std::span<RgbD> results, std::span<const RgbD> others, double opacity) {
    for (std::size_t i = 0; i < results.size(); ++i) {
        results[i] = others[i] * (1 - opacity) + results[i] * opacity;
    }
}

// As much of the change as `opacity` says, beside what `rest` makes of the same colours.
Transform faded(const Transform& change, double opacity, const Transform& rest = {}) {
    if (opacity == 1) {
        return change;
    }
    return Transform::batch([=](std::span<RgbD> colors) {
        constexpr std::size_t at_once = 256; // on the stack
        std::array<RgbD, at_once> others;
        while (!colors.empty()) {
            const auto now = colors.first(std::min(at_once, colors.size()));
            const auto kept = std::span(others).first(now.size());
            std::copy(now.begin(), now.end(), kept.begin());
            rest(kept);
            change(now);
            mix(now, kept, opacity);
            colors = colors.subspan(now.size());
        }
    });
}

bool is_matte(const Operation& operation) {
    return operation.op->is_matte && operation.op->is_matte(operation.values);
}

// The operators and the output's encoding.
std::vector<Transform> stages_of(const Recipe& recipe) {
    const OpContext context = context_of(recipe);
    std::vector<Transform> stages;
    Space now = Space::codes;
    for (const Operation& operation : recipe.operations) {
        if (operation.enabled && !is_identity(operation)) {
            append_conversion(stages, recipe.input, now, operation.op->space);
            now = operation.op->space;
            stages.push_back(
                faded(operation.op->compile(operation.values, context), operation.opacity));
            if (is_matte(operation)) {
                break;
            }
        }
    }
    const Encoding output = recipe.output_encoding();
    if (output == recipe.input) {
        append_conversion(stages, recipe.input, now, Space::codes);
    } else {
        append_conversion(stages, recipe.input, now, Space::linear);
        if (output.gamut != recipe.input.gamut) {
            stages.push_back(through(light_to_light(recipe.input, output, *recipe.adaptation)));
        }
        stages.push_back(Transform::batch(output.curve->encode_all));
    }
    return stages;
}

} // namespace

LookEncodings encodings_of(const Recipe& recipe) {
    if (!recipe.base_lut) {
        return {recipe.input, recipe.output_encoding()};
    }
    LookEncodings out;
    out.input = encoding_named(recipe.base_lut->encodings.input);
    // sRGB is the default, and says nothing of what the base gives.
    const bool stated = recipe.output || recipe.input != srgb() ||
                        encoding_named(recipe.base_lut->encodings.output) == recipe.input;
    if (stated) {
        out.output = recipe.output_encoding();
    }
    return out;
}

Recipe without_look(const Recipe& recipe) {
    Recipe out;
    out.input = encodings_of(recipe).input.value_or(recipe.input);
    out.output = recipe.output_encoding();
    out.adaptation = recipe.adaptation;
    return out;
}

OpContext context_of(const Recipe& recipe) {
    return {.primaries = recipe.input.primaries(),
            .output = recipe.output_encoding().primaries(),
            .adaptation = recipe.adaptation,
            .middle_grey = recipe.input.encode(0.18)};
}

const Op* matte_of(const Recipe& recipe) {
    for (const Operation& operation : recipe.operations) {
        if (operation.enabled && !is_identity(operation) && is_matte(operation)) {
            return operation.op;
        }
    }
    return nullptr;
}

std::vector<std::string> notes_of(const Recipe& recipe) {
    const OpContext context = context_of(recipe);
    std::vector<std::string> out;
    for (const Operation& operation : recipe.operations) {
        if (operation.enabled && operation.op->note) {
            if (std::string note = operation.op->note(operation.values, context); !note.empty()) {
                out.push_back(std::move(note));
            }
        }
    }
    return out;
}

Transform Transform::of(const Recipe& recipe) {
    if (!recipe.base.empty() && !recipe.base_lut) {
        throw Error("the recipe's base '" + recipe.base + "' has not been read");
    }
    const Transform whole =
        batch([base = recipe.base_lut, stages = stages_of(recipe)](std::span<RgbD> colors) {
            if (base) {
                for (RgbD& c : colors) {
                    c = evaluate_exact(*base, c);
                }
            }
            hold(colors);
            for (const Transform& stage : stages) {
                stage(colors);
                hold(colors);
            }
        });
    return recipe.opacity == 1 ? whole : faded(whole, recipe.opacity, of(without_look(recipe)));
}

} // namespace lutlib
