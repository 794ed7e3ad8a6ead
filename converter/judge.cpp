#include "converter/judge.h"

#include "converter/config_options.h"
#include "converter/look_files.h"
#include "converter/unused.h"
#include "lutlib/bake/fitted.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/describe.h"
#include "lutlib/io/look.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/recipe/bake_recipe.h"

#include <fmt/core.h>

#include <memory>

namespace converter {
namespace {

namespace io = lutlib::io;

lutlib::Interpolation baked_interpolation(const Question& q, const Subject& s,
                                          const io::Look& look) {
    const std::string name = io::text_entry(s.image, "Interpolation").value_or("");
    const auto recorded = lutlib::interpolation_named(name).value_or(look.interpolation());
    return q.interpolation.value_or(recorded);
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

} // namespace

Verdict judge(const Subject& s, const Question& q) {
    const bool by_config = q.config && q.config->given();
    const io::LookOptions options{.encodings = q.look};
    const io::Look look = by_config && q.against == identity_word ? identity_look()
                          : q.quiet                               ? open_quietly(q.against, options)
                                                                  : open_look(q.against, options);
    const lutlib::Interpolation how = baked_interpolation(q, s, look);
    const io::LookReference reference = look.reference(how);
    const Claim claim = by_config ? Claim{} : claim_of(s, look.encodings());
    Verdict out;
    out.picture = q.picture;
    out.against = q.against;
    out.config = by_config ? q.config->text() : "";
    out.oracle = reference.name;
    out.refusal = reference.refusal;
    out.scale = reference.scale;
    out.lattice = has_lattice(look);
    // A config says what is converted, of spaces that have no encoding here.
    out.place = by_config ? lutlib::LookPlace{} : io::place_in(*s.engine, claim.look, q.convert);
    out.place.adaptation = q.adaptation;
    out.claimed = claim.filled;
    const lutlib::Transform placed = out.place.applied().around(reference.look);
    const lutlib::Transform right = by_config ? q.config->before(placed) : placed;
    const lutlib::Breaks breaks =
        by_config ? lutlib::no_breaks() : io::placed(look.breaks(), out.place.applied());
    if (s.size > 0) {
        out.viewing = io::viewing_of(out.place, q.reference_white);
        out.result = verify(
            s.codes, *s.engine, s.size, right, breaks, out.viewing, {.even = q.samples}, [&] {
                return by_config ? std::vector<lutlib::Alternative>{}
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

} // namespace converter
