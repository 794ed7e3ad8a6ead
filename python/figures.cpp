// Figures as Python has them, and names as lutlib has them.
#include "lutlib/engine/engine_names.h"
#include "lutlib/error.h"
#include "lutlib/named.h"
#include "python/parts.h"

#include <nlohmann/json.hpp>

namespace lutlib_python {

py::object as_python(const nlohmann::ordered_json& json) {
    using Json = nlohmann::ordered_json;
    switch (json.type()) {
    case Json::value_t::boolean:
        return py::bool_(json.get<bool>());
    case Json::value_t::number_integer:
        return py::int_(json.get<std::int64_t>());
    case Json::value_t::number_unsigned:
        return py::int_(json.get<std::uint64_t>());
    case Json::value_t::number_float:
        return py::float_(json.get<double>());
    case Json::value_t::string:
        return py::reinterpret_steal<py::object>(PyUnicode_DecodeUTF8(
            json.get_ref<const std::string&>().data(),
            static_cast<Py_ssize_t>(json.get_ref<const std::string&>().size()), "replace"));
    case Json::value_t::array: {
        py::list out;
        for (const Json& item : json) {
            out.append(as_python(item));
        }
        return out;
    }
    case Json::value_t::object: {
        py::dict out;
        for (const auto& [key, item] : json.items()) {
            out[py::str(key)] = as_python(item);
        }
        return out;
    }
    default:
        return py::none();
    }
}

py::list as_python(const std::vector<lutlib::Loss>& losses) {
    py::list out;
    for (const lutlib::Loss& loss : losses) {
        out.append(py::dict(py::arg("what") = loss.what, py::arg("figure") = loss.figure,
                            py::arg("unit") = loss.unit));
    }
    return out;
}

std::optional<lutlib::Interpolation> interpolation_of(const std::optional<std::string>& name) {
    if (!name) {
        return std::nullopt;
    }
    return lutlib::require_named(lutlib::interpolations(), "interpolation", *name,
                                 lutlib::Letters::any_case)
        .kind;
}

const lutlib::Engine& engine_of(const std::string& name) {
    return lutlib::require_engine(name);
}

lutlib::LookEncodings encodings_of(const std::optional<std::string>& input,
                                   const std::optional<std::string>& output) {
    lutlib::LookEncodings out;
    if (input) {
        out.input = lutlib::require_encoding(*input);
    }
    if (output) {
        out.output = lutlib::require_encoding(*output);
    }
    return out;
}

} // namespace lutlib_python
