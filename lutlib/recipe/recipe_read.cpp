#include "lutlib/error.h"
#include "lutlib/json_text.h"
#include "lutlib/limits.h"
#include "lutlib/named.h"
#include "lutlib/number_text.h"
#include "lutlib/recipe/recipe.h"
#include "lutlib/resample/resample.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

using nlohmann::json;

constexpr int schema_version = 1;

// A value and where it stands, so that every complaint names its path.
struct Node {
    const json& value;
    std::string path;
    const std::string& file;

    [[noreturn]] void refuse(const std::string& why) const {
        throw Error((path.empty() ? std::string("the recipe") : path) + " " + why, {file, 0, ""});
    }
    Node member(const std::string& key) const {
        return {value.at(key), path.empty() ? key : path + "." + key, file};
    }
    Node item(std::size_t index) const {
        return {value.at(index), path + "[" + std::to_string(index) + "]", file};
    }
    bool has(const std::string& key) const { return value.contains(key); }

    const Node& object() const {
        if (!value.is_object()) {
            refuse("must be an object");
        }
        return *this;
    }
    const Node& array(std::size_t length = 0) const {
        if (!value.is_array() || (length && value.size() != length)) {
            refuse(length ? "must be a list of " + std::to_string(length) : "must be a list");
        }
        return *this;
    }
    double number() const {
        if (!value.is_number()) {
            refuse("must be a number");
        }
        const double x = value.get<double>();
        if (!std::isfinite(x)) {
            refuse("must be finite");
        }
        return x;
    }
    int integer(int min, int max) const {
        const double x = number();
        if (x != std::floor(x) || x < min || x > max) {
            refuse("must be a whole number from " + std::to_string(min) + " to " +
                   std::to_string(max));
        }
        return static_cast<int>(x);
    }
    bool boolean() const {
        if (!value.is_boolean()) {
            refuse("must be true or false");
        }
        return value.get<bool>();
    }
    double toggle() const {
        if (value == true || value == 1 || value == "on") {
            return 1;
        }
        if (value == false || value == 0 || value == "off") {
            return 0;
        }
        refuse("must be true or false, 1 or 0, \"on\" or \"off\"");
    }
    std::string text() const {
        if (!value.is_string()) {
            refuse("must be a text");
        }
        return value.get<std::string>();
    }
    RgbD rgb() const {
        if (value.is_number()) {
            const double x = number();
            return {x, x, x};
        }
        if (!value.is_array() || value.size() != 3) {
            refuse("must be a number or a list of 3");
        }
        return {item(0).number(), item(1).number(), item(2).number()};
    }
    [[noreturn]] void refuse_name(std::string_view name,
                                  std::span<const std::string_view> names) const {
        refuse("is '" + std::string(name) + "'; " + what_there_is(name, names));
    }
    void only(std::span<const std::string_view> known) const {
        for (const auto& [key, unused] : object().value.items()) {
            if (std::find(known.begin(), known.end(), key) == known.end()) {
                refuse("has an unknown key '" + key + "'; " + what_there_is(key, known));
            }
        }
    }
};

Encoding read_encoding(const Node& node) {
    try {
        return require_encoding(node.text());
    } catch (const Error& error) {
        node.refuse("is wrong: " + error.message());
    }
}

const Adaptation* read_adaptation(const Node& node) {
    const std::string name = node.text();
    const Adaptation* const found = adaptation_named(name);
    if (!found) {
        node.refuse_name(name, name_list(adaptations()));
    }
    return found;
}

Value read_value(const Node& node, ParameterKind kind) {
    switch (kind) {
    case ParameterKind::toggle:
        return node.toggle();
    case ParameterKind::rgb:
        return node.rgb();
    case ParameterKind::curve: {
        Knots knots;
        for (std::size_t i = 0; i < node.array().value.size(); ++i) {
            const Node knot = node.item(i).array(2);
            knots.push_back({knot.item(0).number(), knot.item(1).number()});
        }
        return knots;
    }
    case ParameterKind::number:
        break;
    }
    return node.number();
}

double read_opacity(const Node& node) {
    if (!node.has("opacity")) {
        return 1;
    }
    const Node value = node.member("opacity");
    const double opacity = value.number();
    if (!(opacity >= 0 && opacity <= 1)) {
        value.refuse("is " + shortest(opacity) + "; the range is 0 to 1");
    }
    return opacity;
}

Operation read_operation(const Node& node) {
    if (!node.object().has("op")) {
        node.refuse("lacks its \"op\"");
    }
    const std::string name = node.member("op").text();
    const Op* const op = op_named(name);
    if (!op) {
        node.member("op").refuse_name(name, name_list(ops()));
    }
    std::vector<std::string_view> keys{"op", "enabled", "opacity"};
    for (const Parameter& parameter : op->parameters) {
        keys.emplace_back(parameter.name);
    }
    node.only(keys);
    Operation out = default_operation(*op);
    out.enabled = !node.has("enabled") || node.member("enabled").boolean();
    out.opacity = read_opacity(node);
    for (std::size_t i = 0; i < op->parameters.size(); ++i) {
        const Parameter& parameter = op->parameters[i];
        const std::string key(parameter.name);
        if (!node.has(key)) {
            continue;
        }
        const Node value = node.member(key);
        out.values[i] = read_value(value, parameter.kind);
        if (const std::string why = problem_with(parameter, out.values[i]); !why.empty()) {
            value.refuse(why);
        }
    }
    return out;
}

Rgb read_corner(const Node& node) {
    return to_float(node.rgb());
}

BakeSettings read_bake(const Node& node) {
    constexpr std::array<std::string_view, 4> keys{"size", "domain", "shaper", "shaper_size"};
    node.only(keys);
    BakeSettings out;
    if (node.has("size")) {
        out.size = node.member("size").integer(limits::min_cube_size, limits::max_cube_size);
    }
    if (node.has("domain")) {
        const Node domain = node.member("domain").array(2);
        out.domain = Domain{read_corner(domain.item(0)), read_corner(domain.item(1))};
        try {
            check_domain(*out.domain);
        } catch (const Error& error) {
            domain.refuse("cannot be: " + error.message());
        }
    }
    if (node.has("shaper")) {
        out.shaper = node.member("shaper").text();
        const std::vector<std::string_view> names = recipe_shaper_names();
        if (std::find(names.begin(), names.end(), out.shaper) == names.end()) {
            node.member("shaper").refuse_name(out.shaper, names);
        }
    }
    if (node.has("shaper_size")) {
        out.shaper_size =
            node.member("shaper_size").integer(limits::min_shaper_size, limits::max_shaper_size);
    }
    return out;
}

} // namespace

std::vector<std::string_view> recipe_shaper_names() {
    std::vector<std::string_view> names = shaper_names();
    names.insert(names.begin(), "tone");
    return names;
}

Recipe parse_recipe(std::string_view text, const std::string& file) {
    // Of the shortest values it makes some 200 MB.
    constexpr std::size_t largest = std::size_t{8} << 20;
    if (text.size() > largest) {
        throw Error("a recipe has at most 8 MB; this is none", {file, 0, {}});
    }
    const json document = parse_json(text, file);
    const Node root{document, "", file};
    if (!root.object().has("schema_version")) {
        root.refuse("lacks \"schema_version\": " + std::to_string(schema_version));
    }
    if (const Node version = root.member("schema_version");
        version.integer(0, 1 << 20) != schema_version) {
        version.refuse("is " + version.value.dump() + "; this program reads version " +
                       std::to_string(schema_version));
    }
    constexpr std::array<std::string_view, 9> keys{"schema_version", "title",      "input",
                                                   "output",         "adaptation", "base",
                                                   "opacity",        "bake",       "operators"};
    root.only(keys);
    Recipe out;
    if (root.has("title")) {
        out.title = root.member("title").text();
    }
    if (root.has("input")) {
        out.input = read_encoding(root.member("input"));
        out.states_input = true;
    }
    if (root.has("output")) {
        out.output = read_encoding(root.member("output"));
    }
    if (root.has("adaptation")) {
        out.adaptation = read_adaptation(root.member("adaptation"));
    }
    if (root.has("base")) {
        out.base = root.member("base").text();
    }
    out.opacity = read_opacity(root);
    if (root.has("bake")) {
        out.bake = read_bake(root.member("bake"));
    }
    if (root.has("operators")) {
        const Node list = root.member("operators").array();
        for (std::size_t i = 0; i < list.value.size(); ++i) {
            out.operations.push_back(read_operation(list.item(i)));
        }
    }
    return out;
}

} // namespace lutlib
