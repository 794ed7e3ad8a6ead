#include "lutlib/ops/op.h"

#include "lutlib/error.h"
#include "lutlib/named.h"
#include "lutlib/number_text.h"
#include "lutlib/ops/all.h"
#include "lutlib/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>

namespace lutlib {
namespace {

constexpr auto all_ops = std::to_array<const Op*>({
    &op::exposure,
    &op::white_balance,
    &op::channel_mixer,
    &op::highlights,
    &op::lift_gamma_gain,
    &op::offset,
    &op::cdl,
    &op::contrast,
    &op::curves,
    &op::saturation,
    &op::saturation_perceptual,
    &op::vibrance,
    &op::split_toning,
    &op::hue_vs_hue,
    &op::hue_vs_sat,
    &op::hue_vs_lum,
    &op::lum_vs_sat,
    &op::sat_vs_sat,
    &op::sat_vs_lum,
    &op::lum_vs_lum,
    &op::hue_range,
    &op::gamut_compression,
});

std::string problem_with_number(double x, double min, double max) {
    if (x >= min && x <= max) {
        return {};
    }
    return "is " + shortest(x) + "; the range is " + shortest(min) + " to " + shortest(max);
}

// Two knots at one place, of which a periodic axis has one at both its ends.
std::string problem_with_places(const CurveAxis& axis, const Knots& knots) {
    const auto place = [&axis](double x) { return axis.periodic && x == axis.max ? axis.min : x; };
    for (std::size_t i = 0; i < knots.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const Knot &a = knots[k], &b = knots[i];
            if (place(a.x) == place(b.x) && a.y != b.y) {
                return "has two values at one " + std::string(axis.label) + ": " + shortest(a.y) +
                       " at " + shortest(a.x) + " and " + shortest(b.y) + " at " + shortest(b.x) +
                       "; keep one of them";
            }
        }
    }
    return {};
}

bool is_neutral(const Parameter& parameter, const Value& value) {
    if (value == default_value(parameter)) {
        return true;
    }
    if (parameter.kind != ParameterKind::curve) {
        return false;
    }
    const Knots& knots = std::get<Knots>(value);
    return std::all_of(knots.begin(), knots.end(), [&](const Knot& k) {
        return k.y == (parameter.axis.diagonal ? k.x : parameter.fallback);
    });
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const auto end = text.find(separator);
        parts.push_back(trimmed(text.substr(0, end)));
        if (end == text.npos) {
            return parts;
        }
        text.remove_prefix(end + 1);
    }
}

// Reads the numbers of one flag; every complaint names the flag and shows what it accepts.
struct FlagReader {
    const Parameter& parameter;
    const std::string& text;

    [[noreturn]] void refuse(const std::string& why) const {
        throw UsageError("--" + std::string(parameter.flag) + " " + why, {"", 0, text});
    }

    double number(std::string_view part) const {
        double x = 0;
        const std::string_view digits = part.starts_with('+') ? part.substr(1) : part;
        const auto [end, problem] =
            std::from_chars(digits.data(), digits.data() + digits.size(), x);
        if (problem != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(x)) {
            refuse(parameter.kind == ParameterKind::curve
                       ? "takes knots, as in \"0:1, 120:1.4, 240:0.8\""
                   : parameter.kind == ParameterKind::rgb
                       ? "takes one number or three, as in \"1, 0.9, 0.8\""
                       : "takes a number");
        }
        return x;
    }

    Value rgb() const {
        const auto parts = split(text, ',');
        if (parts.size() == 1) {
            const double x = number(parts[0]);
            return RgbD{x, x, x};
        }
        if (parts.size() != 3) {
            refuse("takes one number or three, as in \"1, 0.9, 0.8\"");
        }
        return RgbD{number(parts[0]), number(parts[1]), number(parts[2])};
    }

    Value knots() const {
        Knots out;
        for (const std::string_view part : split(text, ',')) {
            const auto pair = split(part, ':');
            if (pair.size() != 2) {
                refuse("takes knots, as in \"0:1, 120:1.4, 240:0.8\"");
            }
            out.push_back({number(pair[0]), number(pair[1])});
        }
        return out;
    }

    double toggle() const {
        const bool on = text == "on" || text == "1", off = text == "off" || text == "0";
        if (!on && !off) {
            refuse("takes on or off");
        }
        return on ? 1 : 0;
    }
};

} // namespace

bool always(const Values& /*values*/) {
    return true;
}

std::string_view name_of(Space space) {
    return space == Space::codes    ? "code values"
           : space == Space::linear ? "linear light"
                                    : "Oklab";
}

Value default_value(const Parameter& parameter) {
    if (parameter.automatic) {
        return Automatic{};
    }
    switch (parameter.kind) {
    case ParameterKind::rgb:
        return parameter.fallback_rgb;
    case ParameterKind::curve:
        return Knots{};
    case ParameterKind::number:
    case ParameterKind::toggle:
        break;
    }
    return parameter.fallback;
}

std::span<const Op* const> ops() {
    return all_ops;
}

const Op* op_named(std::string_view name) {
    return find_named(all_ops, name);
}

Operation default_operation(const Op& op) {
    Operation out{.op = &op, .values = {}};
    for (const Parameter& parameter : op.parameters) {
        out.values.push_back(default_value(parameter));
    }
    return out;
}

bool is_identity(const Operation& operation) {
    if (operation.opacity == 0) {
        return true;
    }
    for (std::size_t i = 0; i < operation.values.size(); ++i) {
        if (!is_neutral(operation.op->parameters[i], operation.values[i])) {
            return false;
        }
    }
    return true;
}

double number_of(const Parameter& parameter, const Value& value, const OpContext& context) {
    return std::holds_alternative<Automatic>(value) ? context.*parameter.automatic
                                                    : std::get<double>(value);
}

std::string problem_with(const Parameter& parameter, const Value& value) {
    if (parameter.automatic && std::holds_alternative<Automatic>(value)) {
        return {};
    }
    const bool fits = parameter.automatic ? std::holds_alternative<double>(value)
                                          : value.index() == default_value(parameter).index();
    if (!fits) {
        return "is of the wrong kind";
    }
    if (const double* x = std::get_if<double>(&value)) {
        if (parameter.kind == ParameterKind::toggle) {
            return *x == 0 || *x == 1 ? "" : "is " + shortest(*x) + "; it must be 0 or 1";
        }
        return problem_with_number(*x, parameter.min, parameter.max);
    }
    if (const RgbD* c = std::get_if<RgbD>(&value)) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (const auto why = problem_with_number((*c)[i], parameter.min, parameter.max);
                !why.empty()) {
                return why;
            }
        }
        return {};
    }
    for (const Knot& k : std::get<Knots>(value)) {
        if (const auto why = problem_with_number(k.x, parameter.axis.min, parameter.axis.max);
            !why.empty()) {
            return "has a knot whose " + std::string(parameter.axis.label) + " " + why;
        }
        if (const auto why = problem_with_number(k.y, parameter.min, parameter.max); !why.empty()) {
            return "has a knot whose value " + why;
        }
    }
    return problem_with_places(parameter.axis, std::get<Knots>(value));
}

Curve curve_of(const Parameter& parameter, const Value& value) {
    const Knots& knots = std::get<Knots>(value);
    return parameter.axis.periodic
               ? Curve::periodic(knots, parameter.axis.max - parameter.axis.min, parameter.fallback)
               : Curve::open(knots, parameter.fallback);
}

Value parse_value(const Parameter& parameter, const std::string& text) {
    const FlagReader reader{parameter, text};
    Value value;
    switch (parameter.kind) {
    case ParameterKind::number:
        value = reader.number(trimmed(text));
        break;
    case ParameterKind::toggle:
        value = reader.toggle();
        break;
    case ParameterKind::rgb:
        value = reader.rgb();
        break;
    case ParameterKind::curve:
        value = reader.knots();
        break;
    }
    if (const std::string why = problem_with(parameter, value); !why.empty()) {
        throw UsageError("--" + std::string(parameter.flag) + " " + why);
    }
    return value;
}

std::string value_text(const Value& value) {
    if (const double* x = std::get_if<double>(&value)) {
        return shortest(*x);
    }
    if (const RgbD* c = std::get_if<RgbD>(&value)) {
        return shortest(c->r) + ", " + shortest(c->g) + ", " + shortest(c->b);
    }
    if (std::holds_alternative<Automatic>(value)) {
        return "automatic";
    }
    std::string out;
    for (const Knot& k : std::get<Knots>(value)) {
        out += (out.empty() ? "" : ", ") + shortest(k.x) + ":" + shortest(k.y);
    }
    return out;
}

} // namespace lutlib
