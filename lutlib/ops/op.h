// Edit operators: what a look is made of. An operator is a descriptor (name, parameters, the space
// it works in) and a function that turns values into a transform.
//
// Every operator is defined for every finite colour, continuous in the colour, and at its defaults
// the identity, exactly. Help, flags, sliders, recipes and tests are made from the table.
#pragma once

#include "lutlib/color/primaries.h"
#include "lutlib/curve.h"
#include "lutlib/rgb.h"
#include "lutlib/transform.h"

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace lutlib {

/// What the colours of an operator's transform are.
enum class Space {
    codes,  ///< the recipe's own code values, as its input encoding has them
    linear, ///< linear light on the primaries of the recipe's input encoding
    oklab,  ///< Oklab's L, a, b in r, g, b
};
std::string_view name_of(Space space);

/// What a parameter holds. A toggle is a number that is 0 or 1.
enum class ParameterKind { number, toggle, rgb, curve };

/// A number that nobody has chosen: it follows the recipe's encoding, see Parameter::automatic.
struct Automatic {
    friend bool operator==(const Automatic&, const Automatic&) = default;
};

/// One for each kind: number and toggle, rgb, curve; and a number's Automatic. A curve without
/// knots is neutral.
using Value = std::variant<double, RgbD, Knots, Automatic>;

/// What a transform may have to know of the recipe around it.
struct OpContext {
    Primaries primaries = rec709;             ///< of Space::linear
    Primaries output = rec709;                ///< of the recipe's result
    const Adaptation* adaptation = &bradford; ///< between the two whites
    double middle_grey = 0.46135612950044164; ///< code of 18 % light; here sRGB's
};

/// The x axis of a curve parameter.
struct CurveAxis {
    std::string_view label{};
    std::string_view unit{};
    double min = 0, max = 1;
    bool periodic = false;
    /// The neutral curve is y = x; otherwise it is the constant Parameter::fallback.
    bool diagonal = false;
};

/// A colour wheel on which an rgb parameter is edited; see preview/editor/wheel.h.
struct Wheel {
    double balance = 0;       ///< BT.709's Cb and Cr at the rim; 0: the parameter has no wheel
    double brightness = 0;    ///< luma from the default, at the ends of the ring about the wheel
    bool is_inverted = false; ///< more of a channel makes it darker
};

struct Parameter {
    std::string_view name; ///< key in a recipe
    std::string_view flag; ///< on the command line, without dashes
    std::string_view label;
    std::string_view unit{};
    ParameterKind kind = ParameterKind::number;
    double min = 0, max = 1; ///< of the number, of each channel, of a curve's y
    double fallback = 0;     ///< default of a number, of every channel; neutral y of a curve
    RgbD fallback_rgb{};     ///< default of an rgb parameter
    CurveAxis axis{};        ///< of a curve
    Wheel wheel{};           ///< of an rgb parameter
    /// Of a number whose default is the recipe's, such as the code of 18 % light: where it is
    /// found, and that in words. Its default_value() is Automatic.
    double OpContext::*automatic = nullptr;
    std::string_view automatic_words{};
};

Value default_value(const Parameter& parameter);

/// Values in the order of the operator's parameters, each of the parameter's kind.
using Values = std::vector<Value>;

/// A number parameter's number, an Automatic one as the context has it.
double number_of(const Parameter& parameter, const Value& value, const OpContext& context);

struct Op {
    std::string_view name;
    std::string_view label;
    std::string_view help;
    std::string_view reference; ///< where the formula is published, or the formula
    Space space = Space::codes;
    std::span<const Parameter> parameters;
    /// Neutral colours that rise stay neutral colours that do not fall, whatever the values.
    bool monotone_on_neutrals = false;
    /// Whether every channel of the result depends on that channel alone, with these values; null:
    /// with none. Of operators on Oklab it never does.
    bool (*per_channel)(const Values& values) = nullptr;
    /// Values have been checked. May throw Error for a combination that cannot be.
    Transform (*compile)(const Values& values, const OpContext& context) = nullptr;
    /// What whoever uses these values should know, a sentence without its full stop; empty:
    /// nothing. Null: never anything.
    std::string (*note)(const Values& values, const OpContext& context) = nullptr;
    /// Whether the result is no colour but which colours these values choose: a recipe ends there,
    /// for operators behind would change it. Null: never.
    bool (*is_matte)(const Values& values) = nullptr;
};

/// For Op::per_channel: with any values.
bool always(const Values& values);

/// Every operator, in the order in which a panel shows them.
std::span<const Op* const> ops();
const Op* op_named(std::string_view name);

/// An operator with its values; what a recipe lists.
struct Operation {
    const Op* op = nullptr;
    Values values;
    bool enabled = true;
    /// How much of the operator's result is taken, 0..1; the rest is what went in. They are mixed
    /// in the space that the operator works in.
    double opacity = 1;
    friend bool operator==(const Operation&, const Operation&) = default;
};

/// With every value at its default.
Operation default_operation(const Op& op);

/// Every value is its default (a neutral curve counts) or nothing of the result is taken, so the
/// operation does nothing.
bool is_identity(const Operation& operation);

/// Empty when `value` is of the parameter's kind, finite and within its range; otherwise what is
/// wrong, as in "is 7; the range is 0 to 4".
std::string problem_with(const Parameter& parameter, const Value& value);

/// A curve parameter's curve.
Curve curve_of(const Parameter& parameter, const Value& value);

/// Text as on the command line: "1.3", "1, 0.9, 0.8" (one number stands for three equal ones), and
/// "0:1, 120:1.4" for curves. Throws UsageError with the flag and the text.
Value parse_value(const Parameter& parameter, const std::string& text);
std::string value_text(const Value& value);

} // namespace lutlib
