#include "lutlib/recipe/edit.h"

#include "lutlib/color/oklab.h"
#include "lutlib/color/powers.h"
#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"

#include <algorithm>
#include <limits>

namespace lutlib {
namespace {

// NaN fails the first comparison and becomes 0.
double held(double x) {
    constexpr double limit = std::numeric_limits<float>::max();
    return x >= -limit ? std::min(x, limit) : x < 0 ? -limit : 0;
}

void hold(std::span<RgbD> colours) {
    for (RgbD& c : colours) {
        c = {held(c.r), held(c.g), held(c.b)};
    }
}

Transform through(const Matrix3& m) {
    return each_colour([m](RgbD c) { return m * c; });
}

} // namespace

Edit::Edit(const Recipe& recipe) : base_(recipe.base_lut) {
    if (!recipe.base.empty() && !base_) {
        throw Error("the recipe's base '" + recipe.base + "' has not been read");
    }
    const OpContext context{recipe.input->primaries};
    Space now = Space::codes;
    for (const Operation& operation : recipe.operations) {
        if (operation.enabled && !is_identity(operation)) {
            convert(recipe, now, operation.op->space);
            now = operation.op->space;
            stages_.push_back(operation.op->compile(operation.values, context));
        }
    }
    const Encoding& output = recipe.output_encoding();
    if (&output == recipe.input) {
        convert(recipe, now, Space::codes);
        return;
    }
    convert(recipe, now, Space::linear);
    stages_.push_back(through(rgb_to_rgb(recipe.input->primaries, output.primaries)));
    stages_.emplace_back(output.encode_all);
}

void Edit::convert(const Recipe& recipe, Space from, Space to) {
    if (from == to) {
        return;
    }
    const Matrix3 cones = oklab_cones(recipe.input->primaries);
    if (from == Space::codes) {
        stages_.emplace_back(recipe.input->decode_all);
    } else if (from == Space::oklab) {
        stages_.push_back(
            each_colour([m = inverse(cones)](RgbD c) { return m * lms_from_oklab(c); }));
    }
    if (to == Space::oklab) {
        stages_.emplace_back([cones](std::span<RgbD> colours) {
            for (RgbD& c : colours) {
                c = cones * c;
            }
            cube_root_all({&colours.front().r, 3 * colours.size()});
            for (RgbD& c : colours) {
                c = oklab_lms_to_lab * c;
            }
        });
    } else if (to == Space::codes) {
        stages_.emplace_back(recipe.input->encode_all);
    }
}

void Edit::operator()(std::span<RgbD> colours) const {
    if (base_) {
        for (RgbD& c : colours) {
            c = evaluate_exact(*base_, c);
        }
    }
    after_base(colours);
}

RgbD Edit::operator()(RgbD colour) const {
    (*this)(std::span(&colour, 1));
    return colour;
}

void Edit::after_base(std::span<RgbD> colours) const {
    if (colours.empty()) {
        return;
    }
    hold(colours);
    for (const Transform& stage : stages_) {
        stage(colours);
        hold(colours);
    }
}

} // namespace lutlib
