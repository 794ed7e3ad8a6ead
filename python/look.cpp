// Look: a LUT, a LUT picture or a recipe, read from a file or made of arrays.
#include "lutlib/error.h"
#include "lutlib/io/formats.h"
#include "lutlib/named.h"
#include "python/parts.h"

#include <algorithm>
#include <cstring>

namespace lutlib_python {
namespace {

using FloatArray = py::array_t<float, py::array::c_style | py::array::forcecast>;
using DoubleArray = py::array_t<double, py::array::c_style | py::array::forcecast>;

// ---- reading and making

std::shared_ptr<PyLook> read(const std::string& path, const std::string& format,
                             const std::optional<std::string>& layout,
                             const std::optional<std::string>& engine, int row,
                             const std::optional<std::string>& interpolation,
                             const std::optional<std::string>& input,
                             const std::optional<std::string>& output) {
    lutlib::io::LookOptions options{.format = format,
                                    .row = row,
                                    .interpolation = interpolation_of(interpolation),
                                    .encodings = encodings_of(input, output)};
    if (layout) {
        options.layout = &lutlib::require_named(lutlib::layouts(), "layout", *layout);
    }
    if (engine) {
        options.engine = &engine_of(*engine);
    }
    const py::gil_scoped_release others_may_run;
    return std::make_shared<PyLook>(lutlib::io::Look::open(path, options));
}

lutlib::Rgb rgb_of(const py::object& value) {
    if (py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value)) {
        const auto x = value.cast<float>();
        return {x, x, x};
    }
    const auto channels = value.cast<std::array<float, 3>>();
    return {channels[0], channels[1], channels[2]};
}

lutlib::Domain domain_of(const py::object& ends) {
    const py::sequence pair = ends;
    if (pair.size() != 2) {
        throw py::value_error("domain is (minimum, maximum), each a number or three");
    }
    return {rgb_of(pair[0]), rgb_of(pair[1])};
}

std::vector<lutlib::Rgb> colors_of(const FloatArray& array) {
    std::vector<lutlib::Rgb> out(static_cast<std::size_t>(array.size()) / 3);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const float* const at = array.data() + 3 * i;
        out[i] = {at[0], at[1], at[2]};
    }
    return out;
}

// As a look is read, from the bytes of a file that keeps every bit.
std::shared_ptr<PyLook> look_of(const lutlib::Lut& lut) {
    validate(lut);
    const char* const format = lut.shaper && lut.cube ? "cube-resolve" : "cube";
    lutlib::io::Encoded file = lutlib::io::encode_lut(lut, lutlib::io::require_file_format(format));
    if (!file.losses.empty()) {
        throw lutlib::Error("no file holds such a look: " + file.losses.front().what);
    }
    lutlib::io::LookOptions options{.format = format, .encodings = encodings_of(lut.encodings)};
    return std::make_shared<PyLook>(
        lutlib::io::Look::of_bytes(std::move(file.bytes), "array.cube", options));
}

std::shared_ptr<PyLook> from_arrays(const std::optional<FloatArray>& cube,
                                    const std::optional<FloatArray>& shaper,
                                    const py::object& domain, const std::string& title,
                                    const std::optional<std::string>& input,
                                    const std::optional<std::string>& output) {
    lutlib::Lut lut;
    lut.title = title;
    lut.encodings = names_of(encodings_of(input, output));
    const lutlib::Domain ends = domain_of(domain);
    if (!cube && !shaper) {
        throw py::value_error("give a cube, a shaper or both");
    }
    if (shaper) {
        if (shaper->ndim() != 2 || shaper->shape(1) != 3) {
            throw py::value_error("shaper has the shape (entries, 3)");
        }
        lut.shaper = lutlib::Lut1D{ends, colors_of(*shaper)};
    }
    if (cube) {
        const py::ssize_t n = cube->ndim() == 4 ? cube->shape(0) : 0;
        if (n == 0 || cube->shape(1) != n || cube->shape(2) != n || cube->shape(3) != 3) {
            throw py::value_error("cube has the shape (n, n, n, 3), its first axis blue, its third "
                                  "red");
        }
        lut.cube =
            lutlib::Lut3D{shaper ? lutlib::Domain{} : ends, static_cast<int>(n), colors_of(*cube)};
    }
    return look_of(lut);
}

// ---- what a look holds

py::object table_array(const std::shared_ptr<const lutlib::Lut>& lut,
                       const std::vector<lutlib::Rgb>& colors,
                       const std::vector<py::ssize_t>& shape) {
    // Kept alive by the array that shows it.
    auto* const holder = new std::shared_ptr<const lutlib::Lut>(lut);
    const py::capsule owner(
        holder, [](void* kept) { delete static_cast<std::shared_ptr<const lutlib::Lut>*>(kept); });
    static_assert(sizeof(lutlib::Rgb) == 3 * sizeof(float));
    py::array_t<float> out(shape, &colors.front().r, owner);
    out.attr("flags").attr("writeable") = false;
    return out;
}

py::object cube_of(const PyLook& look) {
    const auto lut = look.table().lut;
    if (!lut->cube) {
        return py::none();
    }
    const py::ssize_t n = lut->cube->size;
    return table_array(lut, lut->cube->nodes, {n, n, n, 3});
}

py::object shaper_of(const PyLook& look) {
    const auto lut = look.table().lut;
    return lut->shaper ? table_array(lut, lut->shaper->entries, {lut->shaper->size(), 3})
                       : py::object(py::none());
}

py::tuple domain_tuple(const PyLook& look) {
    const lutlib::Domain d = look->domain();
    return py::make_tuple(py::make_tuple(d.min.r, d.min.g, d.min.b),
                          py::make_tuple(d.max.r, d.max.g, d.max.b));
}

std::optional<std::string> name_of_encoding(const std::optional<lutlib::Encoding>& encoding) {
    return encoding ? std::optional(encoding->name()) : std::nullopt;
}

std::vector<std::string> remarks_of(const PyLook& look) {
    std::vector<std::string> out;
    for (const lutlib::io::LookFile& file : look->files()) {
        out.insert(out.end(), file.remarks.begin(), file.remarks.end());
    }
    return out;
}

std::vector<lutlib::Loss> losses_of(const PyLook& look) {
    std::vector<lutlib::Loss> out;
    for (const lutlib::io::LookFile& file : look->files()) {
        out.insert(out.end(), file.losses.begin(), file.losses.end());
    }
    return out;
}

py::array evaluate(const PyLook& look, const DoubleArray& colors) {
    if (colors.ndim() < 1 || colors.shape(colors.ndim() - 1) != 3) {
        throw py::value_error("colours have the shape (..., 3)");
    }
    const std::vector<py::ssize_t> shape(colors.shape(), colors.shape() + colors.ndim());
    py::array_t<double> out(shape);
    static_assert(sizeof(lutlib::RgbD) == 3 * sizeof(double));
    if (colors.size() == 0) {
        return out;
    }
    std::memcpy(out.mutable_data(), colors.data(), static_cast<std::size_t>(colors.nbytes()));
    auto* const first = reinterpret_cast<lutlib::RgbD*>(out.mutable_data());
    const auto count = static_cast<std::size_t>(out.size()) / 3;
    const py::gil_scoped_release others_may_run;
    apply_in_parallel(look->exact(), std::span(first, count));
    return out;
}

py::list write(const PyLook& look, const std::string& path, const std::string& format,
               const std::string& title, int size, int bits) {
    std::vector<lutlib::Loss> losses;
    {
        const py::gil_scoped_release others_may_run;
        const lutlib::io::LookTable table = size == 0 ? look.table() : look->table(size);
        const lutlib::io::Encoded written = lutlib::io::write_lut(
            path, *table.lut, {.title = title, .size = size, .bits = bits}, format);
        losses = table.losses;
        losses.insert(losses.end(), written.losses.begin(), written.losses.end());
    }
    return as_python(losses);
}

} // namespace

void declare_look(py::module_& module) {
    py::class_<PyLook, std::shared_ptr<PyLook>>(
        module, "Look", "A LUT, a LUT picture or a recipe, read once. It never changes.")
        .def_static("from_arrays", &from_arrays, py::kw_only(), py::arg("cube") = py::none(),
                    py::arg("shaper") = py::none(), py::arg("domain") = py::make_tuple(0.0, 1.0),
                    py::arg("title") = "", py::arg("input") = py::none(),
                    py::arg("output") = py::none(),
                    R"(A look of numbers, which are copied as float32.

cube: shape (n, n, n, 3), cube[b, g, r] the colour of node (r, g, b).
shaper: shape (entries, 3), a curve for each channel, read before the cube, whose domain is then 0..1.
domain: the inputs, in code values, that the table spans: (minimum, maximum), each a number or three.
input, output: what the code values are, such as "slog3/sgamut3.cine"; None: not known.)")
        .def("__call__", &evaluate, py::arg("colours"),
             "The exact images of colours, shape (..., 3) of code values, as float64: a recipe by "
             "its formulas, a table in double. Every core works; other Python threads run "
             "meanwhile.")
        .def_property_readonly("path", [](const PyLook& l) { return l->path(); })
        .def_property_readonly("title", [](const PyLook& l) { return l->title(); })
        .def_property_readonly(
            "format", [](const PyLook& l) { return l->kind().format; },
            "The file format that was recognised, or \"recipe\".")
        .def_property_readonly("domain", &domain_tuple,
                               "The inputs that it is meant for, in code values: ((r, g, b) "
                               "minimum, (r, g, b) maximum).")
        .def_property_readonly(
            "input", [](const PyLook& l) { return name_of_encoding(l->encodings().input); },
            "What its input codes are, such as \"srgb\"; None: not known.")
        .def_property_readonly(
            "output", [](const PyLook& l) { return name_of_encoding(l->encodings().output); })
        .def_property_readonly(
            "interpolation",
            [](const PyLook& l) { return std::string(name_of(l->interpolation())); })
        .def_property_readonly("cube", &cube_of,
                               "The table's nodes, shape (n, n, n, 3), float32, read-only, not "
                               "copied: cube[b, g, r]. A recipe's is baked. None: a 1D table.")
        .def_property_readonly("shaper", &shaper_of,
                               "The 1D table, shape (entries, 3), float32, read-only, not copied; "
                               "None: there is none.")
        .def_property_readonly(
            "losses", [](const PyLook& l) { return as_python(losses_of(l)); },
            "What of the file was not read: dicts of what, figure, unit.")
        .def_property_readonly("remarks", &remarks_of, "Guesses and contradictions, sentences.")
        .def("__repr__", [](const PyLook& l) {
            return "<lutlib.Look " + l->path() + ", " + l->kind().format + ">";
        });
    module.def("read", &read, py::arg("path"), py::kw_only(), py::arg("format") = "",
               py::arg("layout") = py::none(), py::arg("engine") = py::none(), py::arg("row") = 0,
               py::arg("interpolation") = py::none(), py::arg("input") = py::none(),
               py::arg("output") = py::none(),
               R"(A LUT file, LUT picture or recipe of any kind. Throws Error.

format: a name of formats(); left out, it is recognised.
layout, engine, row: of a picture whose content does not tell; row 0 is the topmost of stacked ones.
interpolation, input, output: in place of what the look says.)");
    module.def("write", &write, py::arg("look"), py::arg("path"), py::kw_only(),
               py::arg("format") = "", py::arg("title") = "", py::arg("size") = 0,
               py::arg("bits") = 16,
               "Writes a look's table in the format of the path's extension, or `format`, whole or "
               "not at all. `size`: nodes a side of a cube that is sampled anew; `bits`: 8 or 16, "
               "of pictures. What the file cannot hold is returned: dicts of what, figure, unit.");
}

} // namespace lutlib_python
