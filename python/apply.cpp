// apply(): a look over numpy arrays where they lie.
#include "python/parts.h"

#include <algorithm>
#include <stdexcept>

namespace lutlib_python {
namespace {

using lutlib::Element;

Element element_of(const py::array& array, int bits) {
    const py::dtype type = array.dtype();
    const char kind = type.kind();
    const auto size = type.itemsize();
    const bool is_native = type.attr("isnative").cast<bool>();
    const bool is_10_bits = bits == 10 && kind == 'u' && size == 2;
    if (bits != 0 && !is_10_bits) {
        throw py::type_error("bits is 10, of uint16 codes of 10 bits, or left out");
    }
    if (is_native && kind == 'f' && (size == 4 || size == 2)) {
        return size == 4 ? Element::float32 : Element::half;
    }
    if (is_native && kind == 'u' && (size == 1 || size == 2)) {
        return is_10_bits ? Element::uint10 : size == 2 ? Element::uint16 : Element::uint8;
    }
    throw py::type_error(
        "apply takes arrays of float32, float16, uint16 or uint8 in this machine's "
        "byte order, not " +
        py::str(py::object(type)).cast<std::string>());
}

std::string shape_text(const py::array& array) {
    return py::str(array.attr("shape")).cast<std::string>();
}

// The picture of (height, width, channels) that begins at `first`.
template <class Byte>
lutlib::BasicPictureView<Byte> view_of(const py::array& array, Byte* first, Element element) {
    const py::ssize_t axes = array.ndim();
    const auto size_along = [&](py::ssize_t back) {
        return axes < back ? 1 : array.shape(axes - back);
    };
    const auto step_along = [&](py::ssize_t back) {
        return axes < back ? 0 : array.strides(axes - back);
    };
    lutlib::BasicPictureView<Byte> out;
    for (py::ssize_t c = 0; c < size_along(1); ++c) {
        out.channel[static_cast<std::size_t>(c)] = first + c * step_along(1);
    }
    out.element = element;
    out.width = static_cast<std::size_t>(size_along(2));
    out.height = static_cast<std::size_t>(size_along(3));
    out.pixel_stride = step_along(2);
    out.row_stride = step_along(3);
    return out;
}

void check(const py::array& array) {
    const py::ssize_t axes = array.ndim();
    if (axes < 1 || (array.shape(axes - 1) != 3 && array.shape(axes - 1) != 4)) {
        throw py::value_error(
            "apply takes arrays whose last axis is 3 or 4 channels, not of shape " +
            shape_text(array) + "; of planes, give numpy.moveaxis(planes, 0, -1)");
    }
    if (!array.attr("flags").attr("aligned").cast<bool>()) {
        throw py::value_error("apply takes arrays of aligned samples; give a copy");
    }
}

// Of the axes before rows, all combinations of their indices, as offsets in bytes.
std::vector<std::pair<py::ssize_t, py::ssize_t>> pictures_in(const py::array& in,
                                                             const py::array& out) {
    std::vector<std::pair<py::ssize_t, py::ssize_t>> all{{0, 0}};
    for (py::ssize_t axis = 0; axis + 3 < in.ndim(); ++axis) {
        std::vector<std::pair<py::ssize_t, py::ssize_t>> next;
        for (const auto& [a, b] : all) {
            for (py::ssize_t i = 0; i < in.shape(axis); ++i) {
                next.emplace_back(a + i * in.strides(axis), b + i * out.strides(axis));
            }
        }
        all = std::move(next);
    }
    return all;
}

bool is_same_place(const py::array& a, const py::array& b) {
    return a.data() == b.data() &&
           std::equal(a.strides(), a.strides() + a.ndim(), b.strides(), b.strides() + b.ndim());
}

void check_out(const py::array& in, const py::array& out) {
    check(out);
    if (!out.writeable()) {
        throw py::value_error("out cannot be written to");
    }
    if (out.ndim() != in.ndim() ||
        !std::equal(in.shape(), in.shape() + in.ndim() - 1, out.shape())) {
        throw py::value_error("out has the shape " + shape_text(out) + ", the array " +
                              shape_text(in));
    }
    if (!is_same_place(in, out) &&
        py::module_::import("numpy").attr("shares_memory")(in, out).cast<bool>()) {
        throw py::value_error("out overlaps the array; give the array itself, or memory apart");
    }
}

py::array apply(const PyLook& look, const py::array& in, const std::optional<py::array>& wanted,
                const std::optional<std::string>& interpolation, int threads, int bits) {
    check(in);
    const Element element = element_of(in, bits);
    py::array out =
        wanted ? *wanted : py::module_::import("numpy").attr("empty_like")(in).cast<py::array>();
    check_out(in, out);
    const Element element_out = element_of(out, out.dtype().itemsize() == 2 ? bits : 0);
    if (threads < 0) {
        throw py::value_error("threads is 0, for every core, or a number of them");
    }
    const lutlib::Interpolation how =
        interpolation_of(interpolation).value_or(look->interpolation());
    if (in.size() == 0) {
        return out;
    }
    const auto pictures = pictures_in(in, out);
    const auto* const from = static_cast<const std::byte*>(in.data());
    auto* const to = static_cast<std::byte*>(out.mutable_data());
    const auto in_view = view_of(in, from, element);
    const auto out_view = view_of(out, to, element_out);
    const py::gil_scoped_release others_may_run;
    const lutlib::Grading grading = look.grading(how);
    for (const auto& [a, b] : pictures) {
        lutlib::ConstPictureView source = in_view;
        lutlib::PictureView target = out_view;
        for (std::size_t c = 0; c < 4; ++c) {
            source.channel[c] = source.channel[c] ? source.channel[c] + a : nullptr;
            target.channel[c] = target.channel[c] ? target.channel[c] + b : nullptr;
        }
        grade(grading, source, target, threads);
    }
    return out;
}

} // namespace

const lutlib::io::LookTable& PyLook::table_unlocked() const {
    if (!table_) {
        table_ = look_.table();
    }
    return *table_;
}

const lutlib::io::LookTable& PyLook::table() const {
    const std::lock_guard lock(mutex_);
    return table_unlocked();
}

lutlib::Grading PyLook::grading(lutlib::Interpolation how) const {
    const std::lock_guard lock(mutex_);
    if (!grading_ || grading_->first != how) {
        grading_.emplace(how, lutlib::Grading(*table_unlocked().lut, how));
    }
    return grading_->second;
}

void declare_apply(py::module_& module) {
    module.def("apply", &apply, py::arg("look"), py::arg("array").noconvert(), py::kw_only(),
               py::arg("out").noconvert() = py::none(), py::arg("interpolation") = py::none(),
               py::arg("threads") = 0, py::arg("bits") = 0,
               R"(The look over an array of code values, where it lies.

array: shape (..., 3) or (..., 4), the last two axes before the channels being rows and pixels; any
    strides, also negative ones. float32 and float16 hold 1.0 for the largest code, uint16 and uint8
    the codes themselves; with bits=10, uint16 holds codes of 0..1023. A fourth channel, alpha, is
    handed on unchanged.
out: the array itself, or another of the same shape that does not overlap it, of any of these types;
    None makes a new one. It is what is returned.
interpolation: nearest, trilinear or tetrahedral, in place of what the look asks for.
threads: 1 is the calling thread alone, 0 every core. Other Python threads run meanwhile.

The look's own table is read, a recipe's after baking it as its settings say. Outside of the table's
domain, channels are clamped to it, NaN to its minimum; codes are rounded to nearest.)");
}

} // namespace lutlib_python
