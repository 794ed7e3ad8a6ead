// lutconv verify: proves a LUT picture right against OpenColorIO, or says what is wrong with it.
#include "lutlib/engine/verify.h"
#include "converter/command.h"
#include "converter/options.h"
#include "converter/report.h"
#include "lutlib/engine/fitted.h"
#include "lutlib/engine/recognise.h"
#include "lutlib/error.h"
#include "lutlib/formats/cube.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/io/ocio.h"
#include "lutlib/io/recipe_file.h"
#include "lutlib/limits.h"
#include "lutlib/metrics/samples.h"
#include "lutlib/recipe/edit.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <memory>

namespace converter {
namespace {

namespace io = lutlib::io;
using lutlib::Engine;
using lutlib::Oracle;

struct Options {
    std::string picture, against;
    EngineOption engine;
    InterpolationOption interpolation;
    int samples = lutlib::SampleCounts{}.random;
    bool json = false;
};

// What the picture is, and each point in which it is not what the engine wants.
struct Subject {
    io::CodeImage image;
    lutlib::CodePicture codes;
    const Engine* engine = nullptr;
    int size = 0; ///< 0 when the engine's layout has no such picture
    std::vector<std::string> contract;
};

bool is_fitted(const Subject& s) {
    return io::text_entry(s.image, "Lattice") == "fitted";
}

const Engine* engine_with_layout(std::string_view layout) {
    const auto all = lutlib::engines();
    const auto row =
        std::find_if(all.begin(), all.end(), [&](const Engine& e) { return e.layout == layout; });
    return row == all.end() ? nullptr : &*row;
}

// The engine that was asked for, else the one the bake recorded, else one with the layout that the
// content shows.
const Engine& choose_engine(const Options& o, const Subject& subject) {
    if (o.engine.given()) {
        return o.engine.get();
    }
    if (const auto name = io::text_entry(subject.image, "Engine")) {
        if (const Engine* const engine = lutlib::engine_named(*name)) {
            return *engine;
        }
    }
    const lutlib::Recognition found =
        recognise_one(decoded(subject.codes), io::input_name(o.picture));
    return *engine_with_layout(found.layout->name);
}

int size_in_layout(const Engine& engine, const lutlib::CodePicture& codes) {
    const lutlib::Layout& layout = *lutlib::layout_named(engine.layout);
    const lutlib::PictureSize wanted{codes.width, codes.height};
    for (int n = lutlib::limits::min_cube_size; n <= lutlib::limits::max_cube_size; ++n) {
        if (layout.picture(n) == wanted) {
            return n;
        }
    }
    return 0;
}

void check_contract_of(Subject& s) {
    const Engine& engine = *s.engine;
    if (s.size == 0) {
        std::string words = fmt::format("wrong size: {}x{} pixels are no {} picture", s.codes.width,
                                        s.codes.height, engine.layout);
        for (const lutlib::Recognition& reading : recognise(decoded(s.codes))) {
            words +=
                fmt::format("; they could be {} of size {}", reading.layout->name, reading.size);
        }
        s.contract.push_back(words);
    } else {
        try {
            check_contract(engine, s.size, s.codes.bits);
        } catch (const lutlib::UsageError& error) {
            s.contract.push_back(error.message());
        }
    }
    const bool wants_tag = engine.srgb_tag == lutlib::SrgbTag::present;
    if (wants_tag != s.image.srgb_tag) {
        s.contract.push_back(wants_tag ? "the sRGB tag is missing; the engine needs it"
                                       : "it is tagged sRGB; the engine would decode the codes");
    }
    if (s.image.profile_tag || s.image.gamma_tag) {
        s.contract.push_back(
            "it carries a colour profile or gamma; a loader may convert the codes");
    }
}

Subject open_subject(const Options& o) {
    Subject s;
    const std::string name = io::input_name(o.picture);
    s.image = io::read_png(io::read_file(o.picture), name);
    s.codes = io::code_picture(s.image);
    s.engine = &choose_engine(o, s);
    s.size = size_in_layout(*s.engine, s.codes);
    check_contract_of(s);
    return s;
}

lutlib::Interpolation baked_interpolation(const Options& o, const Subject& s) {
    const std::string name = io::text_entry(s.image, "Interpolation").value_or("");
    return o.interpolation.given()
               ? o.interpolation.get()
               : lutlib::interpolation_named(name).value_or(lutlib::Interpolation::tetrahedral);
}

// The look as OpenColorIO evaluates it: by its own parser wherever it can read the file, else from
// our reading of it, with the reason. OpenColorIO knows no recipes; those are evaluated exactly, in
// double, by lutlib.
class Reference {
  public:
    explicit Reference(const std::string& path)
        : name_(io::input_name(path)), bytes_(io::read_file(path)),
          extension_(path == io::standard_stream ? "cube" : io::extension_of(path)) {
        if (io::is_recipe(bytes_)) {
            recipe_.emplace(io::recipe_from(bytes_, path, read_lut));
        } else if (io::is_png(bytes_)) {
            ours_ = io::decode_lut(bytes_, name_).lut;
        }
    }

    Oracle oracle(lutlib::Interpolation how) {
        if (recipe_) {
            return [edit = *recipe_](std::vector<lutlib::Rgb>& colors) {
                for (lutlib::Rgb& color : colors) {
                    color = to_float(edit(to_double(color)));
                }
            };
        }
        std::shared_ptr<io::OcioTransform>& transform = transforms_[how];
        if (!transform) {
            transform = evaluator(how);
        }
        return [transform](std::vector<lutlib::Rgb>& colors) { transform->apply(colors); };
    }

    std::string name() const {
        return recipe_ ? "the recipe, evaluated exactly" : "OpenColorIO " + io::ocio().version();
    }

    /// Whether an interpolation has a part in it.
    bool is_table() const { return !recipe_; }

    /// Why OpenColorIO could not read the file itself; empty when it could.
    const std::string& refusal() const { return refusal_; }

  private:
    std::shared_ptr<io::OcioTransform> evaluator(lutlib::Interpolation how) {
        const io::EvaluationOptions options{.interpolation = how};
        if (!ours_) {
            try {
                return io::ocio().parse(bytes_, extension_, name_, options);
            } catch (const lutlib::Error& error) {
                ours_ = lutlib::read_cube(bytes_, name_);
                refusal_ = error.message();
            }
        }
        return io::ocio().from_lut(*ours_, options);
    }

    std::string name_, bytes_, extension_, refusal_;
    std::optional<lutlib::Lut> ours_;
    std::optional<lutlib::Edit> recipe_; ///< evaluated instead
    std::map<lutlib::Interpolation, std::shared_ptr<io::OcioTransform>> transforms_;
};

std::vector<lutlib::Alternative> other_interpolations(Reference& reference,
                                                      lutlib::Interpolation used) {
    std::vector<lutlib::Alternative> out;
    for (const lutlib::InterpolationInfo& row : lutlib::interpolations()) {
        if (reference.is_table() && row.kind != used &&
            row.kind != lutlib::Interpolation::nearest) {
            out.push_back({fmt::format("the look was read with {} interpolation", row.name),
                           reference.oracle(row.kind)});
        }
    }
    return out;
}

std::string as_text(const Options& o, const Subject& s, const Reference& reference,
                    const lutlib::Verification* result) {
    std::string out = fmt::format("{} against {} by {}\n", o.picture, o.against, reference.name());
    out += fmt::format("  layout {}, {}x{}, {} nodes a side, {} bits: {}\n", s.engine->layout,
                       s.codes.width, s.codes.height, s.size, s.codes.bits, s.engine->label);
    if (!reference.refusal().empty()) {
        out += "  OpenColorIO evaluates our reading of the look; its own reader refuses the file\n";
    }
    for (const std::string& point : s.contract) {
        out += "  contract: " + point + "\n";
    }
    if (result) {
        const lutlib::TexelCheck& t = result->texels;
        out += fmt::format("  texels: {} of {} right", t.texels - t.wrong, t.texels);
        out += t.wrong == 0
                   ? "\n"
                   : fmt::format("; off by {} codes at most (at {},{}), {:.3g} on average\n",
                                 t.max_difference, t.worst.x, t.worst.y, t.mean_difference);
        if (t.wrong > 0 && !is_fitted(s)) {
            out += result->diagnosis
                       ? fmt::format("  why: {} (explains {:.1f} % of the texels)\n",
                                     result->diagnosis->words, 100 * result->diagnosis->explained)
                       : "  why: no known mistake explains it; is it a bake of another look?\n";
        }
        out += fmt::format("  {}'s lookup ({}) over {} colours: {}\n", s.engine->name,
                           s.engine->lookup_help, result->lookup.absolute.count,
                           to_text(result->lookup.absolute));
        out += fmt::format("    worst at {:.4g} {:.4g} {:.4g}\n", result->lookup.worst.r,
                           result->lookup.worst.g, result->lookup.worst.b);
        out += fmt::format("    as dE2000: {}\n", to_text(result->lookup.delta_e));
    }
    return out;
}

nlohmann::ordered_json as_json(const Options& o, const Subject& s, const Reference& reference,
                               const lutlib::Verification* result) {
    nlohmann::ordered_json out{{"picture", o.picture},       {"against", o.against},
                               {"oracle", reference.name()}, {"engine", s.engine->name},
                               {"layout", s.engine->layout}, {"size", s.size},
                               {"bits", s.codes.bits},       {"contract_violations", s.contract}};
    if (!reference.refusal().empty()) {
        out["oracle_refusal"] = reference.refusal();
    }
    if (result) {
        const lutlib::TexelCheck& t = result->texels;
        out["texels"] = {{"count", t.texels},
                         {"wrong", t.wrong},
                         {"max_difference_codes", t.max_difference},
                         {"mean_difference_codes", t.mean_difference}};
        if (result->diagnosis) {
            out["diagnosis"] = {{"words", result->diagnosis->words},
                                {"explained", result->diagnosis->explained}};
        }
        out["lookup"] = {
            {"absolute_error", to_json(result->lookup.absolute)},
            {"delta_e_2000", to_json(result->lookup.delta_e)},
            {"worst", {result->lookup.worst.r, result->lookup.worst.g, result->lookup.worst.b}}};
    }
    return out;
}

std::string fitted_text(const lutlib::FittedCheck& check) {
    const auto figures = [](const lutlib::LookupError& error) { return to_text(error.absolute); };
    std::string out =
        fmt::format("  the lattice is fitted, so its texels are not the look's values: {} of {} "
                    "are where a fit "
                    "made anew puts them\n"
                    "    over {} colours {}; the new fit {}; point samples {}\n",
                    check.texels - check.moved, check.texels, check.result.absolute.count,
                    figures(check.result), figures(check.refit), figures(check.point_sampled));
    for (const std::string& fault : check.faults) {
        out += "  why: " + fault + "\n";
    }
    return out;
}

nlohmann::ordered_json fitted_json(const lutlib::FittedCheck& check) {
    return {{"result", to_json(check.result.absolute)},
            {"refit", to_json(check.refit.absolute)},
            {"point_sampled", to_json(check.point_sampled.absolute)},
            {"texels_moved", check.moved},
            {"faults", check.faults}};
}

int run(const Options& o) {
    if (o.samples < 1) {
        throw lutlib::UsageError("--samples must be at least 1");
    }
    if (o.picture == io::standard_stream && o.against == io::standard_stream) {
        throw lutlib::UsageError("the picture and the look cannot both come from standard input");
    }
    const Subject s = open_subject(o);
    Reference reference(o.against);
    const lutlib::Interpolation how = baked_interpolation(o, s);
    std::optional<lutlib::Verification> result;
    std::optional<lutlib::FittedCheck> fitted;
    if (s.size > 0) {
        lutlib::SampleCounts counts;
        counts.random = o.samples;
        result = verify(s.codes, *s.engine, s.size, reference.oracle(how),
                        lutlib::sample_colors(s.size, counts),
                        [&] { return other_interpolations(reference, how); });
        if (is_fitted(s)) {
            fitted =
                check_fitted(s.codes, *s.engine, s.size, reference.oracle(how),
                             lutlib::sample_colors(std::min(s.size, 33), {.random = o.samples}));
        }
    }
    const bool right = result && (fitted ? fitted->right() : result->texels.wrong == 0);
    const bool passed = right && s.contract.empty();
    const lutlib::Verification* const shown = result ? &*result : nullptr;
    if (o.json) {
        nlohmann::ordered_json json = as_json(o, s, reference, shown);
        if (fitted) {
            json["fitted"] = fitted_json(*fitted);
        }
        json["passed"] = passed;
        print(json, "");
    } else {
        std::string text = as_text(o, s, reference, shown);
        if (fitted) {
            text += fitted_text(*fitted);
        }
        print(text + (passed ? "passed\n" : "FAILED\n"), "");
    }
    return passed ? ok : verification_failed;
}

} // namespace

Run declare_verify(CLI::App& app) {
    const auto o = std::make_shared<Options>();
    app.add_option("PICTURE", o->picture, "the LUT picture (PNG), or - for standard input")
        ->required();
    app.add_option("--against", o->against, "the look or recipe it should be a bake of")
        ->required();
    o->engine.declare(app, "");
    o->interpolation.declare(app, "how the look was read between its nodes (default: as recorded "
                                  "in the picture)");
    app.add_option("--samples", o->samples, "random colours for the lookup's error")
        ->capture_default_str();
    app.add_flag("--json", o->json, "print the figures as JSON");
    return [o] { return run(*o); };
}

} // namespace converter
