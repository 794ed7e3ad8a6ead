// lutconv verify: proves a LUT picture right against OpenColorIO, or says what is wrong with it.
#include "lutlib/verify/verify.h"
#include "converter/command.h"
#include "converter/config_options.h"
#include "converter/look_files.h"
#include "converter/many_looks.h"
#include "converter/options.h"
#include "converter/placing.h"
#include "converter/report.h"
#include "converter/subject.h"
#include "converter/unused.h"
#include "converter/verify_result.h"
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

#include <memory>
#include <optional>

namespace converter {
namespace {

namespace io = lutlib::io;

constexpr int most_samples = 10'000'000;

struct Options {
    std::vector<std::string> pictures;
    std::string against;
    std::string picture; ///< of one verdict
    EngineOption engine;
    InterpolationOption interpolation;
    PlacingOptions placing;
    ConfigOptions config;
    int row = -1;
    int samples = static_cast<int>(lutlib::SampleLimits{}.even);
    double reference_white = lutlib::reference_white_nits;
    bool json = false;
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
    Verdict out;
    out.picture = o.picture;
    out.against = o.against;
    out.config = by_config ? o.config.text() : "";
    out.oracle = reference.name;
    out.refusal = reference.refusal;
    out.scale = reference.scale;
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
        out.passed = holds && s.contract.empty();
    }
    return out;
}

int verify_one(const Options& o, const Verb& verb) {
    const Subject s = open_subject(o.picture, o.engine.given() ? &o.engine.get() : nullptr,
                                   o.row < 0 ? std::nullopt : std::optional(o.row));
    const Verdict v = judge(o, s, verb);
    o.json ? print(to_json(s, v), "") : print(to_text(s, v), "");
    return v.passed ? ok : verification_failed;
}

int run(const Options& o, const Verb& verb) {
    if (o.samples < 1 || o.samples > most_samples) {
        throw lutlib::UsageError(fmt::format("--samples must be 1 to {}", most_samples));
    }
    o.config.check();
    o.config.require_alone(o.placing.given());
    const std::vector<LookRoute> routes = routes_of_looks(o.pictures, "");
    if (o.against == io::standard_stream &&
        (routes.size() > 1 || routes.front().route.from.path == io::standard_stream)) {
        throw lutlib::UsageError("the look can come from standard input for one picture alone, "
                                 "which then cannot come from there");
    }
    return run_over(routes, [&](const LookRoute& route) {
        Options one = o;
        one.picture = route.route.from.path;
        return verify_one(one, verb);
    });
}
} // namespace

Run declare_verify(Verb& verb) {
    const auto o = std::make_shared<Options>();
    verb.add_option("PICTURES", o->pictures,
                    "the LUT pictures, or - for standard input; folders of them")
        .required();
    verb.add_option("--against", o->against,
                    "the look or recipe that it should have been baked from")
        .required();
    o->engine.declare(verb, "");
    o->interpolation.declare(verb, "how the look was read between its nodes (default: as recorded "
                                   "in the picture)");
    o->placing.declare(verb);
    verb.add_option("--row", o->row,
                    "which of the lattices stacked in the picture, from the top and 0 (ReShade's "
                    "multi-LUT files)")
        .takes(Takes::count);
    verb.add_option("--samples", o->samples,
                    "colours spread evenly, for the mean and the percentiles of the lookup's error")
        .capture_default_str();
    declare_reference_white(verb, o->reference_white);
    verb.add_flag("--json", o->json, "print the results as JSON");
    o->config.declare(verb);
    return [o, &verb] { return run(*o, verb); };
}

} // namespace converter
