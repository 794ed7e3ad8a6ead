#include "lutlib/recipe/recipe.h"

#include "lutlib/number_text.h"

#include <nlohmann/json.hpp>

namespace lutlib {
namespace {

// "[a, b]"
std::string bracketed(const std::vector<std::string>& items) {
    std::string out(1, '[');
    for (const std::string& item : items) {
        out.append(out.size() > 1 ? ", " : "").append(item);
    }
    out += ']';
    return out;
}

template <class T>
std::string triple(const BasicRgb<T>& c) {
    return bracketed({shortest(c.r), shortest(c.g), shortest(c.b)});
}

std::string json_text(std::string_view text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string corner(const Rgb& c) {
    return c.r == c.g && c.g == c.b ? shortest(c.r) : triple(c);
}

std::string value_json(const Parameter& parameter, const Value& value) {
    if (const double* x = std::get_if<double>(&value)) {
        return parameter.kind == ParameterKind::toggle ? (*x != 0 ? "true" : "false")
                                                       : shortest(*x);
    }
    if (const RgbD* c = std::get_if<RgbD>(&value)) {
        return triple(*c);
    }
    std::vector<std::string> knots;
    for (const Knot& k : std::get<Knots>(value)) {
        knots.push_back(bracketed({shortest(k.x), shortest(k.y)}));
    }
    return bracketed(knots);
}

// "key": value pairs, in one line when there is but one besides the first.
using Fields = std::vector<std::pair<std::string_view, std::string>>;

std::string object(const Fields& fields, const std::string& indent) {
    const bool one_line = fields.size() <= 2;
    std::string out = "{";
    for (std::size_t i = 0; i < fields.size(); ++i) {
        out += i == 0 ? "" : one_line ? ", " : ",";
        if (!one_line) {
            out.append("\n").append(indent).append("  ");
        }
        out.append(json_text(fields[i].first)).append(": ").append(fields[i].second);
    }
    if (!one_line) {
        out.append("\n").append(indent);
    }
    out += '}';
    return out;
}

std::string operation_json(const Operation& operation) {
    Fields fields{{"op", json_text(operation.op->name)}};
    if (!operation.enabled) {
        fields.emplace_back("enabled", "false");
    }
    if (operation.opacity != Operation{}.opacity) {
        fields.emplace_back("opacity", shortest(operation.opacity));
    }
    for (std::size_t i = 0; i < operation.values.size(); ++i) {
        const Parameter& parameter = operation.op->parameters[i];
        if (operation.values[i] != default_value(parameter)) {
            fields.emplace_back(parameter.name, value_json(parameter, operation.values[i]));
        }
    }
    return object(fields, "    ");
}

std::string bake_json(const BakeSettings& bake) {
    Fields fields;
    if (bake.size) {
        fields.emplace_back("size", std::to_string(*bake.size));
    }
    if (bake.domain) {
        fields.emplace_back("domain",
                            bracketed({corner(bake.domain->min), corner(bake.domain->max)}));
    }
    if (!bake.shaper.empty()) {
        fields.emplace_back("shaper", json_text(bake.shaper));
    }
    if (bake.shaper_size != BakeSettings{}.shaper_size) {
        fields.emplace_back("shaper_size", std::to_string(bake.shaper_size));
    }
    return object(fields, "  ");
}

} // namespace

std::string to_json(const Recipe& recipe) {
    Fields fields{{"schema_version", "1"}};
    if (!recipe.title.empty()) {
        fields.emplace_back("title", json_text(recipe.title));
    }
    fields.emplace_back("input", json_text(recipe.input.name()));
    if (recipe.output_encoding() != recipe.input) {
        fields.emplace_back("output", json_text(recipe.output->name()));
    }
    if (recipe.adaptation != Recipe{}.adaptation) {
        fields.emplace_back("adaptation", json_text(recipe.adaptation->name));
    }
    if (!recipe.base.empty()) {
        fields.emplace_back("base", json_text(recipe.base));
    }
    if (recipe.opacity != Recipe{}.opacity) {
        fields.emplace_back("opacity", shortest(recipe.opacity));
    }
    if (recipe.bake != BakeSettings{}) {
        fields.emplace_back("bake", bake_json(recipe.bake));
    }
    std::string list = "[";
    for (const Operation& operation : recipe.operations) {
        list.append(list.size() > 1 ? ",\n    " : "\n    ").append(operation_json(operation));
    }
    list += recipe.operations.empty() ? "]" : "\n  ]";
    fields.emplace_back("operators", list);
    std::string out = object(fields, "");
    out += '\n';
    return out;
}

} // namespace lutlib
