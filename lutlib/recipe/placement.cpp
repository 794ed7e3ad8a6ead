#include "lutlib/recipe/placement.h"

#include "lutlib/recipe/recipe.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace lutlib {
namespace {

std::optional<Conversion> between(const std::optional<Encoding>& from,
                                  const std::optional<Encoding>& to) {
    return from && to && *from != *to ? std::optional(Conversion{*from, *to}) : std::nullopt;
}

} // namespace

Transform conversion(const Conversion& conversion, const Adaptation& adaptation) {
    Recipe recipe;
    recipe.input = conversion.from;
    recipe.output = conversion.to;
    recipe.adaptation = &adaptation;
    return Transform::of(recipe);
}

Transform Placement::around(const Transform& look) const {
    std::vector<Transform> steps;
    if (before) {
        steps.push_back(conversion(*before, *adaptation));
    }
    steps.push_back(look);
    if (after) {
        steps.push_back(conversion(*after, *adaptation));
    }
    return steps.size() == 1 ? look : in_sequence(std::move(steps));
}

Domain Placement::fed() const {
    if (!before) {
        return {};
    }
    // Curves rise and the mixing in light is linear, so a corner is the extreme of each channel.
    const Transform convert = conversion(*before, *adaptation);
    constexpr float most = std::numeric_limits<float>::max();
    Domain out{{most, most, most}, {-most, -most, -most}};
    for (int corner = 0; corner < 8; ++corner) {
        const RgbD in{static_cast<double>(corner & 1), static_cast<double>(corner >> 1 & 1),
                      static_cast<double>(corner >> 2)};
        const Rgb codes = to_float(convert(in));
        for (std::size_t c = 0; c < 3; ++c) {
            out.min[c] = std::min(out.min[c], codes[c]);
            out.max[c] = std::max(out.max[c], codes[c]);
        }
    }
    return out;
}

std::string Placement::text() const {
    std::string out;
    if (before) {
        out = before->from.name() + " is converted to " + before->to.name() + " before the look";
    }
    if (after) {
        out += (out.empty() ? "" : ", and ") + after->from.name() +
               (before ? " to " : " is converted to ") + after->to.name() + " after it";
    }
    return out;
}

Placement LookPlace::needed() const {
    return {between(given, look.input), between(look.output, wanted)};
}

Placement LookPlace::applied() const {
    return convert ? needed() : Placement{};
}

LookEncodings LookPlace::shown() const {
    const Placement placement = applied();
    return {placement.before ? placement.before->from : look.input,
            placement.after ? placement.after->to : look.output};
}

bool LookPlace::is_wrong() const {
    return !convert && needed().converts();
}

bool LookPlace::is_unknown() const {
    return (given && !look.input) || (wanted && !look.output);
}

std::string sentence_of(const LookPlace& place, std::string_view where) {
    if (!place.given && !place.wanted) {
        return {};
    }
    const std::string at = std::string(where);
    const std::string meant = place.given ? place.given->name() : place.wanted->name();
    if (place.is_wrong()) {
        const Placement needed = place.needed();
        std::string out = "the look is left as it is, though ";
        if (needed.before) {
            out += "it takes " + needed.before->to.name() + " and " + at + " feeds " +
                   needed.before->from.name();
        }
        if (needed.after) {
            out += (needed.before ? ", and " : "") + std::string("it gives ") +
                   needed.after->from.name() + " where " + at + " shows " + needed.after->to.name();
        }
        return out;
    }
    std::string out = place.applied().text();
    if (place.is_unknown()) {
        const bool input = place.given && !place.look.input;
        const bool output = place.wanted && !place.look.output;
        out += (out.empty() ? "" : "; ") + std::string("the look's ") +
               (input && output ? "encodings are"
                : input         ? "input encoding is"
                                : "output encoding is") +
               " not known and taken for " + meant + ", as of " + at + ": if not, name " +
               (input && output ? "them with --look-input and --look-output"
                : input         ? "it with --look-input"
                                : "it with --look-output");
    }
    return out.empty() ? "the look takes and gives " + meant + ", as " + at + " does" : out;
}

} // namespace lutlib
