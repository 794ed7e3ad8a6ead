// Baking, verifying, comparing, checking and reporting, with figures as dicts of lutconv's own
// keys.
#include "converter/judge.h"
#include "converter/report.h"
#include "converter/result.h"
#include "converter/survey_page.h"
#include "lutlib/bake/budget.h"
#include "lutlib/error.h"
#include "lutlib/health/health.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/file.h"
#include "lutlib/io/lut_picture.h"
#include "python/parts.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace lutlib_python {
namespace {

using lutlib::io::place_in;

py::array picture_array(const lutlib::CodeImage& codes) {
    const std::vector<py::ssize_t> shape{codes.height, codes.width, codes.channels};
    if (codes.depth.bits > 8) {
        return py::array_t<std::uint16_t>(shape, codes.samples.data());
    }
    py::array_t<std::uint8_t> out(shape);
    std::transform(codes.samples.begin(), codes.samples.end(), out.mutable_data(),
                   [](std::uint16_t code) { return static_cast<std::uint8_t>(code); });
    return out;
}

py::dict bake(const PyLook& look, const std::string& engine_name,
              const std::optional<std::string>& path, int size, int bits, bool convert, bool fit,
              bool measure) {
    const lutlib::Engine& engine = engine_of(engine_name);
    lutlib::FilledBake filled;
    nlohmann::ordered_json figures;
    {
        const py::gil_scoped_release others_may_run;
        const lutlib::LookPlace place = place_in(engine, look->encodings(), convert);
        const lutlib::Placement placement = place.applied();
        const lutlib::Transform exact = placement.around(look->exact());
        const lutlib::Breaks breaks = lutlib::io::placed(look->breaks(), placement);
        const lutlib::Viewing viewing = lutlib::io::viewing_of(place);
        const int nodes = size != 0 ? size : engine.default_size;
        const int depth = bits != 0 ? bits : engine.default_bits;
        check_contract(engine, nodes, depth);
        filled = fit ? bake_fitted(exact, engine, nodes, depth, {breaks, viewing})
                     : lutlib::FilledBake{.bake = lutlib::bake(exact, engine, nodes, depth)};
        const lutlib::BakeLoss& loss = filled.bake.loss;
        figures = {{"engine", engine.name},
                   {"layout", engine.layout},
                   {"size", filled.bake.size},
                   {"bits", depth},
                   {"converted", placement.text()},
                   {"fitted", filled.fitted},
                   {"loss",
                    {{"clamped_values", loss.clamped_values},
                     {"most_clamped", loss.most_clamped},
                     {"max_rounding", loss.max_rounding},
                     {"mean_rounding", loss.mean_rounding}}}};
        if (measure) {
            figures["error"] = converter::to_json(measure_lookup(
                filled.bake.picture, engine, filled.bake.size, exact, breaks, viewing));
        }
        if (path) {
            const lutlib::io::BakeOrigin origin{.source = look->path(),
                                                .title = look->title(),
                                                .interpolation = name_of(look->interpolation()),
                                                .fitted = filled.fitted,
                                                .encodings = names_of(place.shown()),
                                                .look = names_of(place.look)};
            lutlib::io::write_file(*path, picture_bytes(filled.bake, origin));
        }
    }
    py::dict out = as_python(figures);
    out["picture"] = picture_array(filled.bake.picture);
    return out;
}

py::object verify(const std::string& picture, const std::string& against,
                  const std::optional<std::string>& engine, std::optional<int> row,
                  const std::optional<std::string>& interpolation,
                  const std::optional<std::string>& input, const std::optional<std::string>& output,
                  bool convert) {
    const lutlib::Engine* const named = engine ? &engine_of(*engine) : nullptr;
    converter::Question question{.picture = picture,
                                 .against = against,
                                 .interpolation = interpolation_of(interpolation),
                                 .look = encodings_of(input, output),
                                 .convert = convert,
                                 .quiet = true};
    nlohmann::ordered_json figures;
    {
        const py::gil_scoped_release others_may_run;
        const converter::Subject subject = converter::open_subject(picture, named, row);
        figures = to_json(subject, judge(subject, question));
    }
    return as_python(figures);
}

py::object compare(const PyLook& a, const PyLook& b, const std::optional<std::string>& encoding,
                   double reference_white, std::size_t samples) {
    nlohmann::ordered_json figures;
    {
        const py::gil_scoped_release others_may_run;
        lutlib::Domain domain = a->domain();
        const lutlib::Domain other = b->domain();
        for (std::size_t c = 0; c < 3; ++c) {
            domain.min[c] = std::min(domain.min[c], other.min[c]);
            domain.max[c] = std::max(domain.max[c], other.max[c]);
        }
        const lutlib::Viewing viewing{
            encoding
                ? lutlib::require_encoding(*encoding)
                : a->encodings().output.value_or(b->encodings().output.value_or(lutlib::srgb())),
            reference_white};
        figures = converter::to_json(measure(
            a->exact(), b->exact(),
            error_samples(domain, united(a->breaks(), b->breaks()), {.even = samples}), viewing));
    }
    return as_python(figures);
}

py::list check(const PyLook& look) {
    lutlib::Health health;
    {
        const py::gil_scoped_release others_may_run;
        lutlib::ExamineOptions options{.encodings = look->encodings()};
        if (look->recipe()) {
            options.exact = look->exact();
        }
        health = examine(*look.table().lut, options);
    }
    py::list out;
    for (const lutlib::HealthCheck& row : lutlib::health_checks()) {
        const lutlib::Finding found = row.judge(health);
        py::dict point;
        point["check"] = row.name;
        point["severity"] = name_of(found.severity);
        point["figure"] = found.figure;
        point["unit"] = row.unit;
        point["words"] = found.words;
        point["where"] =
            found.where ? py::object(py::make_tuple(found.where->r, found.where->g, found.where->b))
                        : py::none();
        out.append(point);
    }
    return out;
}

py::object report(const PyLook& look, const std::optional<std::vector<int>>& sizes,
                  double promise) {
    lutlib::SurveySettings settings;
    settings.promise = promise;
    if (sizes) {
        settings.sizes = *sizes;
    }
    nlohmann::ordered_json figures;
    {
        const py::gil_scoped_release others_may_run;
        const auto survey =
            lutlib::survey(look->as_recipe(), settings, [](double, const std::string&) {});
        figures = converter::survey_json(survey, look->path(), {});
    }
    return as_python(figures);
}

} // namespace

void declare_work(py::module_& module) {
    module.def(
        "bake", &bake, py::arg("look"), py::arg("engine"), py::arg("path") = py::none(),
        py::kw_only(), py::arg("size") = 0, py::arg("bits") = 0, py::arg("convert") = true,
        py::arg("fit") = false, py::arg("measure") = false,
        R"(A look as an engine's LUT picture. Throws UsageError for what the engine does not take.

path: the PNG to write, whole or not at all; None: none.
size, bits: nodes a side, bits a sample; 0: the engine's.
convert: whether a look for other codes than the engine feeds is converted, exactly.
fit: nodes so that the engine's lookup comes nearest to the look between them.
measure: also "error", of the engine's lookup against the look, in code values and dE2000.

Returns a dict with "picture", shape (height, width, 3), uint8 or uint16 codes, and figures; "loss"
is in code values of 0..1.)");
    module.def(
        "verify", &verify, py::arg("picture"), py::arg("against"), py::arg("engine") = py::none(),
        py::kw_only(), py::arg("row") = py::none(), py::arg("interpolation") = py::none(),
        py::arg("input") = py::none(), py::arg("output") = py::none(), py::arg("convert") = true,
        "Whether the picture at a path is the bake of the look at another, which OpenColorIO "
        "evaluates. Returns what lutconv verify --json prints: \"passed\", \"verdict\", "
        "\"texels\", \"lookup\", \"diagnosis\".");
    module.def(
        "compare", &compare, py::arg("a"), py::arg("b"), py::kw_only(),
        py::arg("encoding") = py::none(), py::arg("reference_white") = lutlib::reference_white_nits,
        py::arg("samples") = std::size_t{100000},
        "How far apart two looks are over both their domains: \"absolute\" in code values, "
        "\"delta_e_2000\", \"delta_e_itp\", each with mean, p95, p99 and max, and \"psnr\" in "
        "dB. `encoding` is of their outputs; `reference_white` in cd/m2.");
    module.def("check", &check, py::arg("look"),
               "The health of a look: a dict for each check, with severity good, note, warning or "
               "fault, figure, words and where, an input.");
    module.def("report", &report, py::arg("look"), py::kw_only(), py::arg("sizes") = py::none(),
               py::arg("promise") = 1.0,
               "Every way to store a look with its error, bytes and time, as lutconv report --json "
               "writes it, and which is the smallest within `promise`, a dE2000. Takes seconds to "
               "minutes; `sizes` are the nodes a side that are tried.");
}

} // namespace lutlib_python
