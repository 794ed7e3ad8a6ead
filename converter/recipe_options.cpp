#include "converter/recipe_options.h"

#include "converter/usage.h"
#include "lutlib/error.h"
#include "lutlib/io/correction_files.h"
#include "lutlib/limits.h"
#include "lutlib/named.h"
#include "lutlib/recipe/correction_file.h"
#include "lutlib/resample/combine.h"
#include "lutlib/resample/curves.h"

#include <fmt/core.h>

#include <algorithm>

namespace converter {
namespace {

using lutlib::Operation;
using lutlib::Parameter;
using lutlib::ParameterKind;

std::string shape(const Parameter& parameter) {
    switch (parameter.kind) {
    case ParameterKind::toggle:
        return "on or off";
    case ParameterKind::rgb:
        return "one number or \"r, g, b\"";
    case ParameterKind::curve:
        return fmt::format("knots \"{}:value, ...\"", parameter.axis.label);
    case ParameterKind::number:
        break;
    }
    return "a number";
}

// "Contrast: a number (slope), 0 to 4, default 1"
std::string help_of(const Parameter& parameter) {
    std::string out = fmt::format("{}: {}", parameter.label, shape(parameter));
    if (!parameter.unit.empty()) {
        out += fmt::format(" ({})", parameter.unit);
    }
    if (parameter.kind != ParameterKind::toggle) {
        out += fmt::format(", {:g} to {:g}", parameter.min, parameter.max);
    }
    if (parameter.kind != ParameterKind::curve) {
        out += fmt::format(", default {}", parameter.automatic
                                               ? std::string(parameter.automatic_words)
                                               : lutlib::value_text(default_value(parameter)));
    } else if (!parameter.axis.diagonal) {
        out += fmt::format(", neutral {:g}", parameter.fallback);
    }
    return out;
}

constexpr Parameter opacity_parameter{
    .name = "opacity", .flag = "opacity", .label = "Opacity", .fallback = 1};

// The correction of that id as an operator; without an id the first, and that is a loss.
Operation operation_of_file(const std::string& path, const std::string& id,
                            std::vector<lutlib::Loss>& losses) {
    const std::vector<lutlib::ColorCorrection> all = lutlib::io::read_corrections(path);
    const std::size_t at = lutlib::correction_named(all, id);
    if (id.empty() && all.size() > 1) {
        losses.push_back({"only the first colour correction is read (--cdl-id chooses), of",
                          static_cast<double>(all.size()), "corrections"});
    }
    return operation_of(all[at], losses);
}

std::vector<std::string_view> shapers(bool recipe) {
    return recipe ? lutlib::recipe_shaper_names() : lutlib::shaper_names();
}

} // namespace

void OperatorFlags::declare(Verb& verb) {
    verb_ = &verb;
    for (const lutlib::Op* op : lutlib::ops()) {
        for (std::size_t i = 0; i < op->parameters.size(); ++i) {
            const Parameter& parameter = op->parameters[i];
            verb.add_in_order("--" + std::string(parameter.flag), help_of(parameter),
                              fmt::format("{} (in {})", op->label, name_of(op->space)));
            flags_.push_back({.op = op, .parameter = i});
        }
    }
    constexpr const char* from_file = "ASC CDL of a file";
    verb.add_in_order("--cdl-file",
                      "an operator ASC CDL with the numbers of this .cc, .ccc or .cdl file, "
                      "unclamped as OpenColorIO has it (--cdl-clamp on: as the standard)",
                      from_file);
    flags_.push_back({Flag::Kind::file});
    verb.add_in_order("--cdl-id", "which correction of the file before it (default: the first)",
                      from_file);
    flags_.push_back({Flag::Kind::id});
    verb.add_in_order(
        "--opacity",
        "how much of the operator before it is taken, 0 to 1, default 1; mixed in the space that "
        "the operator works in",
        "Of the operator before it");
    flags_.push_back({Flag::Kind::opacity});
}

std::vector<Operation> OperatorFlags::operations(std::vector<lutlib::Loss>& losses) const {
    std::vector<Operation> out;
    std::vector<bool> set; // parameters of the last operation that have been given
    const auto given = verb_->in_order();
    for (std::size_t i = 0; i < given.size(); ++i) {
        const auto& [number, text] = given[i];
        const Flag& flag = flags_[number];
        if (flag.kind == Flag::Kind::file) {
            const bool has_id =
                i + 1 < given.size() && flags_[given[i + 1].first].kind == Flag::Kind::id;
            out.push_back(operation_of_file(text, has_id ? given[++i].second : "", losses));
            set.assign(out.back().op->parameters.size(), true);
            set.back() = false; // the clamp, which files do not say
            continue;
        }
        if (flag.kind == Flag::Kind::id) {
            throw lutlib::UsageError("--cdl-id belongs behind a --cdl-file: give that one first");
        }
        if (flag.kind == Flag::Kind::opacity) {
            if (out.empty()) {
                throw lutlib::UsageError("--opacity belongs to the operator before it: give that "
                                         "one first");
            }
            out.back().opacity = std::get<double>(parse_value(opacity_parameter, text));
            continue;
        }
        if (out.empty() || out.back().op != flag.op || set[flag.parameter]) {
            out.push_back(default_operation(*flag.op));
            set.assign(flag.op->parameters.size(), false);
        }
        out.back().values[flag.parameter] = parse_value(flag.op->parameters[flag.parameter], text);
        set[flag.parameter] = true;
    }
    return out;
}

void SamplingOptions::declare(Verb& verb, bool recipe) {
    recipe_ = recipe;
    verb.add_option("--size", size_,
                    recipe ? "nodes per axis of the result, which is then a cube"
                           : "nodes per axis of the result; of curves, which stay curves, entries")
        .takes(recipe ? Takes::cube_size : Takes::shaper_size);
    verb.add_option("--domain", domain_,
                    "input range of the result: minimum and maximum, each a number or \"r,g,b\"")
        .expected(2);
    verb.add_option("--shaper", shaper_,
                    "1D table before the cube, or the encoding whose curve it is: " +
                        lutlib::listed(shapers(recipe)));
    verb.add_option("--shaper-size", shaper_size_, "entries of the 1D table")
        .takes(Takes::shaper_size);
}

void SamplingOptions::apply_to(lutlib::BakeSettings& settings) const {
    if (size_) {
        settings.size = size_;
    }
    if (!domain_.empty()) {
        settings.domain = domain_of(domain_);
    }
    if (!shaper_.empty()) {
        const std::vector<std::string_view> names = shapers(recipe_);
        if (std::find(names.begin(), names.end(), shaper_) == names.end()) {
            lutlib::refuse_name("shaper", shaper_, names);
        }
        settings.shaper = shaper_;
    }
    if (shaper_size_) {
        if (settings.shaper.empty() || settings.shaper == "none" || settings.shaper == "base") {
            throw lutlib::UsageError(
                "--shaper-size needs a --shaper that makes a table; none and base make none");
        }
        settings.shaper_size = shaper_size_;
    }
}

lutlib::Sampling SamplingOptions::sampling() const {
    lutlib::BakeSettings settings;
    apply_to(settings);
    lutlib::Sampling out;
    out.size = settings.size;
    out.domain = settings.domain;
    out.shaper = settings.shaper;
    out.shaper_size = settings.shaper_size;
    // Codes of a look that lacks a recipe are taken for light where a curve is to shape them.
    out.input = lutlib::require_encoding("linear");
    return out;
}

lutlib::Sampling SamplingOptions::sampling_of(const std::vector<const lutlib::Lut*>& looks) const {
    lutlib::Sampling out = sampling();
    if (size_ > lutlib::limits::max_cube_size && !make_curve(looks, out)) {
        throw lutlib::UsageError(fmt::format("--size {} is for curves; this makes a cube, which "
                                             "takes {} to {} nodes per axis",
                                             size_, lutlib::limits::min_cube_size,
                                             lutlib::limits::max_cube_size));
    }
    return out;
}

std::string SamplingOptions::choice_text(const lutlib::Lut& made) const {
    if (size_ || made.cube || !made.shaper) {
        return {};
    }
    return fmt::format(
        "{} entries, as the error asks: the fewest within {:g} of the curve's range, "
        "or else those that more do not better; --size chooses another number",
        made.shaper->size(), lutlib::curve_tolerance);
}

void MethodOption::declare(Verb& verb) {
    std::string names;
    for (const lutlib::ResamplingMethod& row : lutlib::resampling_methods()) {
        names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", row.name, row.help);
    }
    verb.add_option("--interpolation", name_,
                    "how looks are read between their nodes: " + names +
                        " (default: as each asks for, else tetrahedral)");
}

const lutlib::ResamplingMethod& MethodOption::get() const {
    if (name_.empty()) {
        return lutlib::usual_resampling();
    }
    return lutlib::require_named(lutlib::resampling_methods(), "interpolation", name_);
}

void NewLutOptions::declare(Verb& verb) {
    verb.add_output("-o,--output", output, "the new LUT, or - for standard output").required();
    sampling.declare(verb, false);
    method.declare(verb);
    verb.add_option("--encoding", encoding,
                    encoding_help("encoding of the looks' outputs, for colour differences"))
        .capture_default_str();
    verb.add_flag("--json", json, "print the results as JSON");
}

lutlib::Encoding NewLutOptions::results() const {
    return encoding_of(encoding, "--encoding");
}

lutlib::Encoding encoding_of(const std::string& name, const std::string& flag) {
    try {
        return lutlib::require_encoding(name);
    } catch (const lutlib::Error& error) {
        throw lutlib::UsageError(flag + ": " + error.message());
    }
}

std::string encoding_help(const std::string& what) {
    return what +
           ": a curve or curve/gamut, such as slog3/sgamut3.cine ('lutconv encodings' lists them)";
}

} // namespace converter
