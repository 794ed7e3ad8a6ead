// lutconv verify: proves a LUT picture right against OpenColorIO, or says what is wrong with it.
#include "lutlib/verify/verify.h"
#include "converter/command.h"
#include "converter/config_options.h"
#include "converter/look_files.h"
#include "converter/options.h"
#include "converter/placing.h"
#include "converter/report.h"
#include "converter/subject.h"
#include "converter/unused.h"
#include "lutlib/bake/fitted.h"
#include "lutlib/error.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/describe.h"
#include "lutlib/io/file.h"
#include "lutlib/io/look.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/recipe/bake_recipe.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

namespace converter {
namespace {

namespace io = lutlib::io;

constexpr int most_samples = 10'000'000;

struct Options {
    std::string picture, against;
    EngineOption engine;
    InterpolationOption interpolation;
    PlacingOptions placing;
    ConfigOptions config;
    int samples = static_cast<int>(lutlib::SampleLimits{}.even);
    double reference_white = lutlib::reference_white_nits;
    bool json = false;
};

struct Verdict {
    std::string oracle,
        refusal; ///< who said what is right; why it was not asked of the file itself
    lutlib::LookPlace place{};
    lutlib::Viewing viewing{};
    std::string claimed{}; ///< which of the look's encodings are the picture's word alone
    std::string scale;     ///< how its reading of the file differs by a factor, and why ours counts
    std::optional<lutlib::Verification> result{}; ///< unless the picture has no lattice
    std::optional<lutlib::FittedCheck> fitted{};
    bool passed = false;
};

lutlib::Interpolation baked_interpolation(const Options& o, const Subject& s,
                                          const io::Look& look) {
    const std::string name = io::text_entry(s.image, "Interpolation").value_or("");
    const auto recorded = lutlib::interpolation_named(name).value_or(look.interpolation());
    return o.interpolation.get().value_or(recorded);
}

// What the look and the options leave open is filled by what bake recorded in the picture, which is
// the picture's own claim.
struct Claim {
    lutlib::LookEncodings look;
    std::string filled; ///< what of them is the picture's word alone: "input logc3, output srgb"
};

Claim claim_of(const Subject& s, lutlib::LookEncodings known) {
    const lutlib::LookEncodings recorded = encodings_of(io::look_encodings_of(s.image));
    Claim out{known, {}};
    const auto fill = [&](std::optional<lutlib::Encoding>& encoding,
                          const std::optional<lutlib::Encoding>& claimed, const char* side) {
        if (!encoding && claimed) {
            encoding = claimed;
            out.filled +=
                (out.filled.empty() ? "" : ", ") + std::string(side) + " " + claimed->name();
        }
    };
    fill(out.look.input, recorded.input, "input");
    fill(out.look.output, recorded.output, "output");
    return out;
}

std::string ignored_text(const lutlib::LookPlace& place, const lutlib::Engine& engine) {
    lutlib::LookPlace left = place;
    left.convert = false;
    return sentence_of(left, engine.name) + ": bake it without --no-convert";
}

// The same look between other encodings: left alone, converted though --no-convert was given, or as
// the picture's text says that it was taken for.
std::vector<lutlib::Alternative> other_places(const Subject& s, const lutlib::Transform& unplaced,
                                              const lutlib::LookPlace& place) {
    std::vector<lutlib::Alternative> out;
    const lutlib::Placement needed = place.needed();
    if (needed.converts() && place.convert) {
        out.push_back({ignored_text(place, *s.engine), unplaced});
    } else if (needed.converts()) {
        out.push_back({"the picture holds the look with its conversions (" + needed.text() +
                           "), as it should: verify it without --no-convert",
                       needed.around(unplaced)});
    }
    lutlib::LookPlace recorded = place;
    recorded.look = encodings_of(io::look_encodings_of(s.image));
    recorded.convert = true;
    if (recorded.look != place.look && recorded.needed().converts()) {
        out.push_back({"it was baked as a look of other encodings (" + recorded.needed().text() +
                           "): if that is right, say so with --look-input and --look-output, else "
                           "bake it anew",
                       recorded.needed().around(unplaced)});
    }
    return out;
}

std::vector<lutlib::Alternative> other_bakes(const io::Look& look, lutlib::Interpolation used,
                                             const lutlib::Transform& unplaced,
                                             const lutlib::LookPlace& place, const Subject& s) {
    std::vector<lutlib::Alternative> out = other_places(s, unplaced, place);
    const lutlib::Placement placement = place.applied();
    if (look.recipe()) {
        const auto table = std::make_shared<const lutlib::Lut>(bake_recipe(*look.recipe()));
        out.push_back({fmt::format("the recipe was sampled onto {} before it was baked",
                                   io::shape_of(*table)),
                       placement.around(lutlib::Transform::of(table))});
    }
    for (const lutlib::InterpolationInfo& row : lutlib::interpolations()) {
        if (look.is_interpolated() && row.kind != used) {
            out.push_back({fmt::format("the look was read with {} interpolation", row.name),
                           placement.around(look.reference(row.kind).look)});
        }
    }
    return out;
}

Verdict judge(const Options& o, const Subject& s, const Verb& verb) {
    const bool by_config = o.config.given();
    const io::Look look = by_config && o.against == identity_word
                              ? identity_look()
                              : open_look(o.against, {.encodings = o.placing.look()});
    const lutlib::Interpolation how = baked_interpolation(o, s, look);
    const io::LookReference reference = look.reference(how);
    const Claim claim = by_config ? Claim{} : claim_of(s, look.encodings());
    Verdict out{.oracle = reference.name, .refusal = reference.refusal, .scale = reference.scale};
    // A config says what is converted, of spaces that have no encoding here.
    out.place =
        by_config ? lutlib::LookPlace{} : io::place_in(*s.engine, claim.look, o.placing.convert());
    out.place.adaptation = &o.placing.adaptation();
    out.claimed = claim.filled;
    tell_unused(verb,
                {interpolation_part(has_lattice(look)), adaptation_part(out.place.applied())});
    const lutlib::Transform right = o.config.before(out.place.applied().around(reference.look));
    const lutlib::Breaks breaks =
        by_config ? lutlib::no_breaks() : io::placed(look.breaks(), out.place.applied());
    if (s.size > 0) {
        out.viewing = io::viewing_of(out.place, o.reference_white);
        out.result = verify(s.codes, *s.engine, s.size, right, breaks, out.viewing,
                            {.even = static_cast<std::size_t>(o.samples)}, [&] {
                                return by_config
                                           ? std::vector<lutlib::Alternative>{}
                                           : other_bakes(look, how, reference.look, out.place, s);
                            });
        if (s.fitted()) {
            out.result->diagnosis.reset();
            out.fitted = check_fitted(s.codes, *s.engine, s.size, right, {breaks, out.viewing});
        }
        const bool holds = out.fitted ? out.fitted->right() : out.result->texels.wrong == 0;
        out.passed = holds && s.contract.empty() && !out.place.is_wrong();
    }
    return out;
}

struct NamedByWords {
    NamedBy by;
    std::string_view name; ///< in JSON
    std::string_view words;
};

const NamedByWords& words_of(NamedBy by) {
    static constexpr std::array<NamedByWords, 3> table{{
        {NamedBy::option, "option", ""},
        {NamedBy::picture, "picture", ", the engine that the picture names"},
        {NamedBy::content, "content",
         ", which is what the content looks like; for another engine name it with --engine"},
    }};
    return *std::find_if(table.begin(), table.end(),
                         [by](const NamedByWords& row) { return row.by == by; });
}

// Names the engine, for a picture that is right for one is wrong for most others; so it is with the
// encoding that the look is taken to be made for.
std::string verdict_text(const Subject& s, const Verdict& v) {
    const std::string taken = !v.claimed.empty()     ? v.claimed
                              : v.place.is_unknown() ? v.place.given->name()
                                                     : "";
    const std::string unless =
        v.passed && !taken.empty() ? "; right if the look is made for " + taken : "";
    return fmt::format("{} as {} ({}){}{}", v.passed ? "passed" : "FAILED", s.engine->label,
                       s.engine->name, words_of(s.named_by).words, unless);
}

std::string texels_text(const lutlib::TexelCheck& t) {
    std::string out = fmt::format("  texels: {} of {} right", t.texels - t.wrong, t.texels);
    return out + (t.wrong == 0
                      ? "\n"
                      : fmt::format("; off by {} codes at most (at {},{}), {:.3g} on average\n",
                                    t.max_difference, t.worst.x, t.worst.y, t.mean_difference));
}

std::string diagnosis_text(const lutlib::Verification& result) {
    if (!result.diagnosis) {
        return fmt::format("  why: no known mistake explains it; check that --against names the "
                           "look it was baked from "
                           "(nearest: {}, {:.1f} % of the texels)\n",
                           result.nearest.words, 100 * result.nearest.explained);
    }
    const double explained = result.diagnosis->explained;
    return fmt::format(
        "  why: {}{}\n", result.diagnosis->words,
        explained > 0 ? fmt::format(" (explains {:.1f} % of the texels)", 100 * explained) : "");
}

nlohmann::ordered_json diagnosis_json(const lutlib::Diagnosis& diagnosis) {
    nlohmann::ordered_json out{{"words", diagnosis.words}};
    if (diagnosis.explained > 0) {
        out["explained"] = diagnosis.explained;
    }
    return out;
}

std::string fitted_text(const lutlib::FittedCheck& check) {
    const auto figures = [](const lutlib::Difference& error) { return to_text(error.absolute); };
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

std::string lookup_text(const Subject& s, const lutlib::Difference& error,
                        const lutlib::Viewing& viewing) {
    return fmt::format("  {}'s lookup ({}) against the look; p99 and mean over {} colours spread "
                       "evenly:\n{}",
                       s.engine->name, s.engine->lookup_help, error.absolute.count,
                       io::figures_text(error, viewing, "    "));
}

// Everything but the file's chunks is as the engine wants it.
bool is_a_matter_of_tags(const Subject& s, const Verdict& v) {
    const bool right = v.result && (v.fitted ? v.fitted->right() : v.result->texels.wrong == 0);
    return right && s.contract.size() == 1 && s.contract.front() == s.tags;
}

std::string as_text(const Options& o, const Subject& s, const Verdict& v) {
    std::string out = fmt::format("{} against {}{} by {}\n", o.picture, o.against,
                                  o.config.given() ? " behind " + o.config.text() : "", v.oracle);
    out += fmt::format("  layout {}, {}x{}, {} nodes per axis, {} bits: {}\n", s.engine->layout,
                       s.codes.width, s.codes.height, s.size, s.codes.depth.bits, s.engine->label);
    if (!v.refusal.empty()) {
        out += "  OpenColorIO evaluates what lutlib read of the look: " + v.refusal + "\n";
    }
    if (is_a_matter_of_tags(s, v)) {
        out += "  why: the texels are right; " + s.tags + "\n";
    }
    if (!v.scale.empty()) {
        out +=
            fmt::format("  {}\n  so OpenColorIO evaluates what lutlib read of the look\n", v.scale);
    }
    for (const std::string& point : s.contract) {
        if (!is_a_matter_of_tags(s, v)) {
            out += "  contract: " + point + "\n";
        }
    }
    if (v.place.is_wrong()) {
        out += "  why: " + ignored_text(v.place, *s.engine) + "\n";
    } else if (const std::string said = sentence_of(v.place, s.engine->name); !said.empty()) {
        out += "  encodings: " + said + "\n";
    }
    if (!v.claimed.empty()) {
        out += "  the look does not say its encodings; " + v.claimed +
               " is what the picture's text says of it\n";
    }
    for (const std::string& note : s.notes) {
        out += "  note: " + note + "\n";
    }
    if (v.result) {
        out += texels_text(v.result->texels);
        if (v.fitted) {
            out += fitted_text(*v.fitted);
        } else if (v.result->texels.wrong > 0) {
            out += diagnosis_text(*v.result);
        }
        out += lookup_text(s, v.result->lookup, v.viewing);
    }
    return out + verdict_text(s, v) + "\n";
}

nlohmann::ordered_json fitted_json(const lutlib::FittedCheck& check) {
    return {{"result", to_json(check.result.absolute)},
            {"refit", to_json(check.refit.absolute)},
            {"point_sampled", to_json(check.point_sampled.absolute)},
            {"texels_moved", check.moved},
            {"faults", check.faults}};
}

nlohmann::ordered_json as_json(const Options& o, const Subject& s, const Verdict& v) {
    nlohmann::ordered_json out{{"picture", o.picture},
                               {"against", o.against},
                               {"oracle", v.oracle},
                               {"engine", s.engine->name},
                               {"engine_named_by", words_of(s.named_by).name},
                               {"layout", s.engine->layout},
                               {"size", s.size},
                               {"bits", s.codes.depth.bits},
                               {"contract_violations", s.contract},
                               {"notes", s.notes},
                               {"encodings", to_json(v.place)}};
    out["encodings"]["claimed_by_picture"] = v.claimed;
    if (v.place.is_wrong()) {
        out["contract_violations"].push_back(ignored_text(v.place, *s.engine));
    }
    if (is_a_matter_of_tags(s, v)) {
        out["tags_alone"] = s.tags;
    }
    if (!v.refusal.empty()) {
        out["oracle_refusal"] = v.refusal;
    }
    if (!v.scale.empty()) {
        out["oracle_scale"] = v.scale;
    }
    if (v.result) {
        const lutlib::TexelCheck& t = v.result->texels;
        const lutlib::Difference& lookup = v.result->lookup;
        out["texels"] = {{"count", t.texels},
                         {"wrong", t.wrong},
                         {"max_difference_codes", t.max_difference},
                         {"mean_difference_codes", t.mean_difference}};
        if (v.result->diagnosis) {
            out["diagnosis"] = diagnosis_json(*v.result->diagnosis);
        } else if (t.wrong > 0 && !v.fitted) {
            out["nearest"] = diagnosis_json(v.result->nearest);
        }
        out["lookup"] = {{"viewing", to_json(v.viewing)},
                         {"absolute_error", to_json(lookup.absolute)},
                         {"delta_e_2000", to_json(lookup.delta_e_2000)},
                         {"delta_e_itp", to_json(lookup.delta_e_itp)},
                         {"worst", {lookup.worst.in.r, lookup.worst.in.g, lookup.worst.in.b}}};
    }
    if (v.fitted) {
        out["fitted"] = fitted_json(*v.fitted);
    }
    out["passed"] = v.passed;
    out["verdict"] = verdict_text(s, v);
    return out;
}

int run(const Options& o, const Verb& verb) {
    if (o.samples < 1 || o.samples > most_samples) {
        throw lutlib::UsageError(fmt::format("--samples must be 1 to {}", most_samples));
    }
    o.config.check();
    o.config.require_alone(o.placing.given());
    if (o.picture == io::standard_stream && o.against == io::standard_stream) {
        throw lutlib::UsageError("the picture and the look cannot both come from standard input");
    }
    const Subject s = open_subject(o.picture, o.engine.given() ? &o.engine.get() : nullptr);
    const Verdict v = judge(o, s, verb);
    o.json ? print(as_json(o, s, v), "") : print(as_text(o, s, v), "");
    return v.passed ? ok : verification_failed;
}

} // namespace

Run declare_verify(Verb& verb) {
    const auto o = std::make_shared<Options>();
    verb.add_option("PICTURE", o->picture, "the LUT picture, or - for standard input").required();
    verb.add_option("--against", o->against,
                    "the look or recipe that it should have been baked from")
        .required();
    o->engine.declare(verb, "");
    o->interpolation.declare(verb, "how the look was read between its nodes (default: as recorded "
                                   "in the picture)");
    o->placing.declare(verb);
    verb.add_option("--samples", o->samples,
                    "colours spread evenly, for the mean and the percentiles of the lookup's error")
        .capture_default_str();
    declare_reference_white(verb, o->reference_white);
    verb.add_flag("--json", o->json, "print the results as JSON");
    o->config.declare(verb);
    return [o, &verb] { return run(*o, verb); };
}

} // namespace converter
