// Recipe: operators with values.
#include "lutlib/error.h"
#include "lutlib/io/recipe_file.h"
#include "lutlib/named.h"
#include "lutlib/number_text.h"
#include "python/parts.h"

#include <algorithm>
#include <filesystem>

namespace lutlib_python {
namespace {

using lutlib::Parameter;
using lutlib::ParameterKind;
using lutlib::Recipe;

// A parameter's name as a keyword.
std::string keyword_of(const Parameter& parameter) {
    std::string out(parameter.name);
    std::replace(out.begin(), out.end(), '-', '_');
    return out;
}

lutlib::Value value_of(const Parameter& parameter, const py::handle& value) {
    switch (parameter.kind) {
    case ParameterKind::toggle:
        return value.cast<bool>() ? 1.0 : 0.0;
    case ParameterKind::number:
        return value.cast<double>();
    case ParameterKind::rgb: {
        if (py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value)) {
            const auto x = value.cast<double>();
            return lutlib::RgbD{x, x, x};
        }
        const auto c = value.cast<std::array<double, 3>>();
        return lutlib::RgbD{c[0], c[1], c[2]};
    }
    case ParameterKind::curve: {
        lutlib::Knots knots;
        for (const auto& [x, y] : value.cast<std::vector<std::pair<double, double>>>()) {
            knots.push_back({x, y});
        }
        return knots;
    }
    }
    return {};
}

py::object as_python(const Parameter& parameter, const lutlib::Value& value) {
    struct {
        bool toggle;
        py::object operator()(double x) const {
            return toggle ? py::object(py::bool_(x != 0)) : py::float_(x);
        }
        py::object operator()(const lutlib::RgbD& c) const { return py::make_tuple(c.r, c.g, c.b); }
        py::object operator()(const lutlib::Knots& knots) const {
            py::list out;
            for (const lutlib::Knot& knot : knots) {
                out.append(py::make_tuple(knot.x, knot.y));
            }
            return out;
        }
        py::object operator()(const lutlib::Automatic&) const { return py::none(); }
    } convert{parameter.kind == ParameterKind::toggle};
    return std::visit(convert, value);
}

Recipe make(const std::string& title, const std::string& input,
            const std::optional<std::string>& output, const py::object& base, int size) {
    Recipe out;
    out.title = title;
    out.input = lutlib::require_encoding(input);
    out.states_input = true;
    if (output) {
        out.output = lutlib::require_encoding(*output);
    }
    if (size != 0) {
        lutlib::check_cube_size(size);
        out.bake.size = size;
    }
    if (!base.is_none()) {
        const auto look = base.cast<std::shared_ptr<PyLook>>();
        out.base = std::filesystem::absolute((*look)->path()).string();
        out.base_lut = look->table().lut;
    }
    return out;
}

Recipe& add(Recipe& recipe, const std::string& name, bool enabled, double opacity,
            const py::kwargs& values) {
    const lutlib::Op& op = lutlib::require_named(lutlib::ops(), "operator", name);
    lutlib::Operation operation = lutlib::default_operation(op);
    operation.enabled = enabled;
    if (!(opacity >= 0 && opacity <= 1)) {
        throw lutlib::Error(name + ": opacity is " + lutlib::shortest(opacity) +
                            "; the range is 0 to 1");
    }
    operation.opacity = opacity;
    for (const auto& [key, value] : values) {
        const auto word = key.cast<std::string>();
        std::size_t i = 0;
        while (i < op.parameters.size() && keyword_of(op.parameters[i]) != word) {
            ++i;
        }
        if (i == op.parameters.size()) {
            lutlib::refuse_name("parameter of " + name, word, lutlib::name_list(op.parameters));
        }
        try {
            operation.values[i] = value_of(op.parameters[i], value);
        } catch (const py::cast_error&) {
            throw py::type_error(name + ": " + word +
                                 " is a number, True or False, three numbers, or a list of (x, y), "
                                 "as operators() says");
        }
        const std::string problem = problem_with(op.parameters[i], operation.values[i]);
        if (!problem.empty()) {
            throw lutlib::Error(name + ": " + word + " " + problem);
        }
    }
    recipe.operations.push_back(operation);
    return recipe;
}

py::list operators_of(const Recipe& recipe) {
    py::list out;
    for (const lutlib::Operation& operation : recipe.operations) {
        py::dict row;
        row["op"] = operation.op->name;
        row["enabled"] = operation.enabled;
        row["opacity"] = operation.opacity;
        for (std::size_t i = 0; i < operation.values.size(); ++i) {
            const Parameter& parameter = operation.op->parameters[i];
            row[py::str(keyword_of(parameter))] = as_python(parameter, operation.values[i]);
        }
        out.append(row);
    }
    return out;
}

// As a look that was read from a file beside its base, which it may therefore name.
std::shared_ptr<PyLook> look_of(const Recipe& recipe) {
    const auto folder = std::filesystem::path(recipe.base).parent_path();
    return std::make_shared<PyLook>(
        lutlib::io::Look::of_bytes(to_json(recipe), (folder / "recipe.json").string()));
}

void save(const Recipe& recipe, const std::string& path) {
    lutlib::io::save_recipe(recipe, path, recipe.base);
}

} // namespace

void declare_recipe(py::module_& module) {
    py::class_<Recipe>(module, "Recipe", "A look as an ordered list of operators with values.")
        .def(py::init(&make), py::arg("title") = "", py::kw_only(), py::arg("input") = "srgb",
             py::arg("output") = py::none(), py::arg("base") = py::none(), py::arg("size") = 0,
             R"(An empty recipe.

input, output: the encodings of its code values; output None: as the input.
base: a Look that was read from a file, applied first.
size: nodes a side of the cube that it is baked to; 0: the base's, else 33.)")
        .def_static(
            "from_json",
            [](const std::string& text, const std::string& file) {
                return lutlib::parse_recipe(text, file);
            },
            py::arg("text"), py::arg("file") = "recipe",
            "Of the text of a recipe's file without a base; `file` names it in errors.")
        .def("add", &add, py::arg("op"), py::kw_only(), py::arg("enabled") = true,
             py::arg("opacity") = 1.0, py::return_value_policy::reference_internal,
             "Appends an operator of operators() with values by its parameters' names, '-' as '_': "
             "numbers in the parameter's unit, True or False, (r, g, b), or curves as lists of "
             "(x, y). Returns the recipe.")
        .def_property_readonly("operators", &operators_of,
                               "A dict for each: op, enabled, opacity and every value.")
        .def_readwrite("title", &Recipe::title)
        .def("to_json", [](const Recipe& r) { return to_json(r); })
        .def("save", &save, py::arg("path"), "Writes the file, whole or not at all.")
        .def("look", &look_of, "The look that it is now.");
    module.def(
        "recipe_of", [](const PyLook& look) { return look->as_recipe(); }, py::arg("look"),
        "The recipe that a look is, or an empty one on top of it.");
}

} // namespace lutlib_python
