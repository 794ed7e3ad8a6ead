#include "converter/placing.h"

#include "converter/recipe_options.h"
#include "lutlib/named.h"

#include <nlohmann/json.hpp>

namespace converter {
namespace {

nlohmann::ordered_json name_json(const std::optional<lutlib::Encoding>& encoding) {
    return encoding ? nlohmann::ordered_json(encoding->name()) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json conversion_json(const std::optional<lutlib::Conversion>& conversion) {
    return conversion ? nlohmann::ordered_json{{"from", conversion->from.name()},
                                               {"to", conversion->to.name()}}
                      : nlohmann::ordered_json(nullptr);
}

std::optional<lutlib::Encoding> named(const std::string& name, const std::string& flag) {
    return name.empty() ? std::nullopt : std::optional(encoding_of(name, flag));
}

} // namespace

void LookEncodingOptions::declare(Verb& verb) {
    verb.add_option("--look-input", input_,
                    encoding_help("what the look's inputs are, in place of what the recipe or the "
                                  "file says"));
    verb.add_option("--look-output", output_, "what its results are, in the same way");
}

lutlib::LookEncodings LookEncodingOptions::look() const {
    return {named(input_, "--look-input"), named(output_, "--look-output")};
}

void PlacingOptions::declare(Verb& verb) {
    look_.declare(verb);
    verb.add_option("--adaptation", adaptation_,
                    "between the whites of different gamuts: " +
                        lutlib::names_of(lutlib::adaptations()) + " (default: the first)");
    verb.add_flag("--no-convert", no_convert_,
                  "never convert, even where the look is made for other encodings");
}

bool PlacingOptions::given() const {
    return no_convert_ || look_.given() || !adaptation_.empty();
}

const lutlib::Adaptation& PlacingOptions::adaptation() const {
    return adaptation_.empty()
               ? lutlib::bradford
               : lutlib::require_named(lutlib::adaptations(), "adaptation", adaptation_);
}

nlohmann::ordered_json to_json(const lutlib::LookPlace& place) {
    const lutlib::Placement applied = place.applied();
    return {{"look",
             {{"input", name_json(place.look.input)}, {"output", name_json(place.look.output)}}},
            {"given", name_json(place.given)},
            {"wanted", name_json(place.wanted)},
            {"before", conversion_json(applied.before)},
            {"after", conversion_json(applied.after)},
            {"mismatched", place.is_wrong()}};
}

} // namespace converter
