#include "preview/cli/light_edit.h"

#include "lutlib/error.h"
#include "lutlib/named.h"

#include <fmt/format.h>

#include <charconv>

namespace preview {

namespace {

[[noreturn]] void reject(const std::string& text, const std::string& why) {
    throw lutlib::UsageError(fmt::format(
        "--light {}: {}; write NAME.CONTROL=VALUE, such as sun.intensity=2", text, why));
}

PointLight& light_named(std::vector<PointLight>& lights, const std::string& name,
                        const std::string& text) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (lights[i].name == name || std::to_string(i) == name) {
            return lights[i];
        }
        names.push_back(light_name(lights[i], i));
    }
    reject(text, lutlib::no_such_name("light", name,
                                      std::vector<std::string_view>(names.begin(), names.end())));
}

const LightControl& control_named(const std::string& name, const std::string& text) {
    const LightControl* const row = lutlib::find_named(light_controls(), name);
    if (row == nullptr) {
        reject(text, lutlib::no_such_name("control of a light", name,
                                          lutlib::name_list(light_controls())));
    }
    return *row;
}

glm::vec3 values_of(const LightControl& control, const std::string& values,
                    const std::string& text) {
    glm::vec3 out(0);
    const int count = components(control.kind);
    const char* at = values.data();
    const char* const end = at + values.size();
    for (int i = 0; i < count; ++i) {
        const auto [rest, failed] = std::from_chars(at, end, out[i]);
        const bool separated = i + 1 < count ? rest != end && *rest == ',' : rest == end;
        if (failed != std::errc{} || !separated) {
            reject(text,
                   count == 1 ? "the value is not a number" : "the value is not three numbers");
        }
        if (!(out[i] >= control.min && out[i] <= control.max)) {
            reject(text,
                   fmt::format("{} goes from {} to {}", control.name, control.min, control.max));
        }
        at = rest + 1;
    }
    return out;
}

} // namespace

LightEdit edit_light(std::vector<PointLight>& lights, const std::string& text) {
    const std::size_t equals = text.find('=');
    // A light's name may hold dots, a control's does not.
    const std::size_t dot = equals == std::string::npos ? equals : text.rfind('.', equals);
    if (dot == std::string::npos) {
        reject(text, "it has no '.' before a '='");
    }
    PointLight& light = light_named(lights, text.substr(0, dot), text);
    const LightControl& control = control_named(text.substr(dot + 1, equals - dot - 1), text);
    const glm::vec3 values = values_of(control, text.substr(equals + 1), text);
    if (control.kind == LightControl::Kind::color && values == glm::vec3(0)) {
        reject(text, fmt::format("black is no colour of a light; to switch it off give {}.on=0",
                                 text.substr(0, dot)));
    }
    control.set(light, values);
    return {static_cast<std::size_t>(&light - lights.data()), &control};
}

} // namespace preview
