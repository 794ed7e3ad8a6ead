#include "preview/effects/effect.h"

#include "lutlib/error.h"
#include "lutlib/named.h"

#include <fmt/format.h>

#include <algorithm>

namespace preview {

namespace {

/// Of every effect that may stand there.
constexpr lutlib::Parameter before_look{.name = "before-look",
                                        .flag = "before-look",
                                        .label = "Before the looks",
                                        .kind = lutlib::ParameterKind::toggle};

/// Sets the parameter of one PARAMETER=VALUE.
void assign(EffectUse& use, const std::string& text) {
    const std::span<const lutlib::Parameter> parameters = use.effect->parameters;
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string name = text.substr(0, equals);
    const bool moves = name == before_look.name && can_stand_before_look(*use.effect);
    const lutlib::Parameter* const found =
        moves ? &before_look : lutlib::find_named(parameters, name);
    if (found == nullptr || equals == text.size()) {
        throw lutlib::UsageError(
            fmt::format("--effect {}: '{}' sets no parameter; write NAME=VALUE with one of: {}{}",
                        use.effect->name, text, lutlib::names_of(parameters),
                        can_stand_before_look(*use.effect) ? ", before-look" : ""));
    }
    const std::string flag = fmt::format("effect {}:{}", use.effect->name, name);
    lutlib::Parameter parameter = *found;
    parameter.flag = flag; // for what parse_value() complains of
    const lutlib::Value value = lutlib::parse_value(parameter, text.substr(equals + 1));
    if (moves) {
        use.before_look = std::get<double>(value) != 0;
    } else {
        use.values[static_cast<std::size_t>(found - parameters.data())] = value;
    }
}

} // namespace

EffectUse parse_use(const std::string& text) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    EffectUse use = usual_use(
        lutlib::require_named(post_effects(), "effect", std::string_view(text).substr(0, colon)));
    for (std::size_t at = colon; at < text.size();) {
        const std::size_t end = std::min(text.find(',', at + 1), text.size());
        assign(use, text.substr(at + 1, end - at - 1));
        at = end;
    }
    return use;
}

std::string use_text(const EffectUse& use) {
    std::string out(use.effect->name);
    for (std::size_t i = 0; i < use.values.size(); ++i) {
        out += fmt::format("{}{}={}", i == 0 ? ":" : ",", use.effect->parameters[i].name,
                           lutlib::value_text(use.values[i]));
    }
    return out + (use.before_look ? ",before-look=1" : "");
}

} // namespace preview
