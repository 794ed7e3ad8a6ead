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
        out += before ? ", and " + after->from.name() + " to " + after->to.name() + " after it"
                      : after->from.name() + " is converted to " + after->to.name() +
                            " after the look";
    }
    return out;
}

Placement LookPlace::needed() const {
    return {between(given, look.input), between(look.output, wanted), adaptation};
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

namespace {

std::string joined(const std::string& a, const char* between, const std::string& b) {
    return a.empty() || b.empty() ? a + b : a + between + b;
}

std::string left_text(const Placement& needed, const std::string& where) {
    const std::string before = needed.before ? "it takes " + needed.before->to.name() + " and " +
                                                   where + " feeds it " + needed.before->from.name()
                                             : "";
    const std::string after = needed.after
                                  ? "it gives " + needed.after->from.name() + " and " + where +
                                        " takes that for " + needed.after->to.name()
                                  : "";
    return "the look is left as it is, though " + joined(before, ", and ", after);
}

std::string unknown_text(const LookPlace& place, const std::string& where) {
    const bool input = place.given && !place.look.input;
    const bool output = place.wanted && !place.look.output;
    if (input && output && *place.given == *place.wanted) {
        return "the look's encodings are not known and taken for " + place.given->name() +
               ", which " + where +
               " feeds: if they are others, name them with --look-input and "
               "--look-output";
    }
    const auto side = [](bool unknown, const char* name, const std::optional<Encoding>& taken) {
        return unknown
                   ? "the look's " + std::string(name) + " encoding is not known and taken for " +
                         taken->name() + ": if it is another, name it with --look-" + name
                   : std::string();
    };
    return joined(side(input, "input", place.given), "; ", side(output, "output", place.wanted));
}

std::string agreement_text(const LookPlace& place) {
    const std::string takes = place.look.input ? "takes " + place.look.input->name() : "";
    const std::string gives = place.look.output ? "gives " + place.look.output->name() : "";
    if (place.look.input && place.look.input == place.look.output) {
        return "the look takes and gives " + place.look.input->name();
    }
    return takes.empty() && gives.empty() ? "" : "the look " + joined(takes, " and ", gives);
}

} // namespace

std::string sentence_of(const LookPlace& place, std::string_view where) {
    const std::string at(where);
    if (place.is_wrong()) {
        return left_text(place.needed(), at);
    }
    const std::string unknown = place.is_unknown() ? unknown_text(place, at) : "";
    const std::string known = place.applied().text();
    if (!known.empty() || !unknown.empty()) {
        return joined(known, "; ", unknown);
    }
    const std::string agreement = agreement_text(place);
    if (!place.given && !place.wanted) {
        return agreement.empty() ? "" : agreement + ": give it that in " + at;
    }
    return agreement + ", as " + at + " does";
}

} // namespace lutlib
