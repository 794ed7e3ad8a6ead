#include "lutlib/recipe/color_correction.h"

#include "lutlib/number_text.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

// The operator's parameters, in its order.
enum Place : std::size_t { slope, offset, power, saturation, clamp };

const Op& cdl() {
    return *op_named("cdl");
}

// Brought into the parameter's range. What a channel is called is empty of a single number.
double held(const Parameter& parameter, double value, const char* channel,
            std::vector<Loss>& losses) {
    const double out = std::clamp(value, parameter.min, parameter.max);
    if (out != value) {
        losses.push_back({std::string(parameter.name) + channel + " is " + shortest(value) +
                              "; the operator takes " + shortest(parameter.min) + " to " +
                              shortest(parameter.max) + ", so it is " + shortest(out) + ", off by",
                          std::abs(out - value),
                          {}});
    }
    return out;
}

RgbD held(const Parameter& parameter, RgbD values, std::vector<Loss>& losses) {
    constexpr const char* channels[] = {" of red", " of green", " of blue"};
    for (std::size_t c = 0; c < 3; ++c) {
        values[c] = held(parameter, values[c], channels[c], losses);
    }
    return values;
}

Operation with_clamp(Operation operation, bool clamps) {
    operation.values[clamp] = clamps ? 1.0 : 0.0;
    return operation;
}

// What the look does beside that operator, which no such file holds.
void add_rest_of(const Recipe& recipe, std::size_t operation, std::vector<Loss>& losses) {
    const auto others = std::count_if(
        recipe.operations.begin(), recipe.operations.end(), [&](const Operation& other) {
            return &other != &recipe.operations[operation] && other.enabled && !is_identity(other);
        });
    if (others > 0) {
        losses.push_back(
            {"the look's other operators are left out", static_cast<double>(others), "operators"});
    }
    if (recipe.base_lut) {
        losses.push_back({"the LUT that the look begins with is left out", 1, "LUT"});
    }
    if (recipe.output_encoding() != recipe.input) {
        losses.push_back({"the conversion from " + recipe.input.name() + " to " +
                              recipe.output_encoding().name() + " is left out",
                          1, "conversion"});
    }
    if (recipe.opacity != 1) {
        losses.push_back({"the look's opacity is left out: all of it is in the file, not",
                          100 * recipe.opacity, "%"});
    }
}

} // namespace

Operation operation_of(const ColorCorrection& correction, std::vector<Loss>& losses) {
    const Op& op = cdl();
    Operation out = default_operation(op);
    out.values[slope] = held(op.parameters[slope], correction.slope, losses);
    out.values[offset] = held(op.parameters[offset], correction.offset, losses);
    out.values[power] = held(op.parameters[power], correction.power, losses);
    out.values[saturation] = held(op.parameters[saturation], correction.saturation, "", losses);
    return out;
}

ColorCorrection correction_of(const Recipe& recipe, std::size_t operation,
                              std::vector<Loss>& losses) {
    const Operation& from = recipe.operations.at(operation);
    ColorCorrection out;
    out.slope = std::get<RgbD>(from.values[slope]);
    out.offset = std::get<RgbD>(from.values[offset]);
    out.power = std::get<RgbD>(from.values[power]);
    out.saturation = std::get<double>(from.values[saturation]);
    if (!from.enabled) {
        losses.push_back(
            {"the operator, which the look leaves out, is in the file", 1, "operator"});
    }
    if (from.opacity != 1) {
        losses.push_back({"the operator's opacity is left out: all of it is in the file, not",
                          100 * from.opacity, "%"});
    }
    if (const double difference = clamping_of(out); difference > 0) {
        const bool clamps = std::get<double>(from.values[clamp]) != 0;
        losses.push_back(
            {clamps ? "results are clamped to 0..1 here; readers that do not (OpenColorIO, unless "
                      "it is told to) differ by at most"
                    : "results are not clamped to 0..1 here; readers that do, as the standard "
                      "says, differ by at most",
             difference,
             {}});
    }
    add_rest_of(recipe, operation, losses);
    return out;
}

double clamping_of(const ColorCorrection& correction) {
    constexpr int steps = 16;
    std::vector<Loss> ignored;
    const Operation operation = operation_of(correction, ignored);
    std::vector<RgbD> clamped, free;
    for (int i = 0; i < (steps + 1) * (steps + 1) * (steps + 1); ++i) {
        clamped.push_back({double(i % (steps + 1)) / steps,
                           double(i / (steps + 1) % (steps + 1)) / steps,
                           double(i / ((steps + 1) * (steps + 1))) / steps});
    }
    free = clamped;
    const OpContext context;
    const Op& op = cdl();
    op.compile(with_clamp(operation, true).values, context)(clamped);
    op.compile(with_clamp(operation, false).values, context)(free);
    double out = 0;
    for (std::size_t i = 0; i < free.size(); ++i) {
        out = std::max(out, largest_magnitude(free[i] - clamped[i]));
    }
    constexpr double rounding = 1e-12; // of powers and sums
    return out > rounding ? out : 0;
}

} // namespace lutlib
