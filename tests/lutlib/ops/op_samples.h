// Values and colours on which every operator is tried.
#pragma once

#include "lutlib/ops/op.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace lutlib::test {

/// A valid value of a parameter at random, never its default.
inline Value some_value(const Parameter& parameter, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    const auto draw = [&] { return std::lerp(parameter.min, parameter.max, unit(random)); };
    switch (parameter.kind) {
    case ParameterKind::toggle:
        return 1 - parameter.fallback;
    case ParameterKind::rgb:
        return RgbD{draw(), draw(), draw()};
    case ParameterKind::curve: {
        Knots knots;
        for (int i = 0; i < 5; ++i) {
            knots.push_back(
                {std::lerp(parameter.axis.min, parameter.axis.max, unit(random)), draw()});
        }
        return knots;
    }
    case ParameterKind::number:
        break;
    }
    return draw();
}

inline Operation some_operation(const Op& op, std::mt19937& random) {
    Operation operation = default_operation(op);
    for (std::size_t i = 0; i < op.parameters.size(); ++i) {
        operation.values[i] = some_value(op.parameters[i], random);
    }
    return operation;
}

/// Both ends of every parameter's range, curves spiked between them.
inline Operation extreme_operation(const Op& op, bool high) {
    Operation operation = default_operation(op);
    for (std::size_t i = 0; i < op.parameters.size(); ++i) {
        const Parameter& p = op.parameters[i];
        const double v = high ? p.max : p.min, w = high ? p.min : p.max;
        switch (p.kind) {
        case ParameterKind::toggle:
            operation.values[i] = high ? 1.0 : 0.0;
            break;
        case ParameterKind::rgb:
            operation.values[i] = RgbD{v, v, v};
            break;
        case ParameterKind::curve: {
            const double middle = (p.axis.min + p.axis.max) / 2;
            operation.values[i] = Knots{{p.axis.min, v}, {middle, w}, {middle + 1e-6, v}};
            break;
        }
        case ParameterKind::number:
            operation.values[i] = v;
            break;
        }
    }
    return operation;
}

/// Colours within and around 0..1, neutrals, zeros of both signs, denormals and the largest floats.
inline std::vector<RgbD> many_colors(std::size_t count) {
    constexpr double huge = std::numeric_limits<float>::max();
    constexpr double tiny = std::numeric_limits<float>::denorm_min();
    constexpr double values[] = {0, -0.0, 1, -1, tiny, -tiny, 1e-6, 4, -4, 65504, huge, -huge};
    std::vector<RgbD> out;
    for (const double r : values) {
        for (const double g : values) {
            for (const double b : values) {
                out.push_back({r, g, b});
            }
        }
    }
    std::mt19937 random(7);
    std::uniform_real_distribution<double> near(-0.5, 2), exponent(-40, 38), unit(0, 1);
    while (out.size() < count) {
        const double v = unit(random);
        out.push_back({v, v, v});
        out.push_back({near(random), near(random), near(random)});
        out.push_back({unit(random), unit(random), unit(random)});
        out.push_back({std::pow(10, exponent(random)), -std::pow(10, exponent(random)),
                       std::pow(10, exponent(random))});
    }
    return out;
}

} // namespace lutlib::test
