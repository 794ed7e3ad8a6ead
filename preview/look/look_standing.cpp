#include "preview/look/look_standing.h"

#include "lutlib/color/display_curve.h"
#include "lutlib/error.h"

namespace preview {

namespace {

using lutlib::Encoding;

bool is_scene(const std::optional<Encoding>& encoding) {
    return encoding && !lutlib::is_display_curve(*encoding->curve);
}

/// The engine's own encoding; none where it hands on what the look is made for.
std::optional<Encoding> engine_encoding(const GpuLookup* lookup) {
    return lookup != nullptr && lookup->engine != nullptr && !lookup->engine->encoding.empty()
               ? lutlib::encoding_named(lookup->engine->encoding)
               : std::nullopt;
}

/// Whether the look stands before the tone map. Throws for an engine that reads elsewhere.
bool stands_before(const lutlib::LookEncodings& look, const GpuLookup* lookup,
                   const PictureCodes& picture) {
    const std::optional<Encoding> engine = engine_encoding(lookup);
    if (!engine) {
        const bool is_meant = is_scene(look.input) && picture.convert;
        return picture.has_light &&
               (picture.at == &look_at_before || (picture.at == &look_at_auto && is_meant));
    }
    const std::string name(lookup->engine->label);
    if (is_scene(engine) && !picture.has_light) {
        throw lutlib::UsageError(name + " grades scene light before the tone map, and this picture "
                                        "holds a display's codes: show a scene or an EXR picture, "
                                        "or preview the look itself (without --engine)");
    }
    if (is_scene(engine) && picture.at == &look_at_after) {
        throw lutlib::UsageError(name + " grades scene light before the tone map: leave out "
                                        "--look-at after");
    }
    if (!is_scene(engine) && picture.at == &look_at_before) {
        throw lutlib::UsageError(name + " reads a display's codes behind the tone map: leave out "
                                        "--look-at before or --engine");
    }
    return is_scene(engine);
}

LookConversion before_tonemap(const lutlib::LookEncodings& look, const GpuLookup* lookup,
                              const PictureCodes& picture) {
    const Encoding light = *lutlib::encoding_named("linear");
    if (const std::optional<Encoding> engine = engine_encoding(lookup)) {
        return {{}, *engine, *engine};
    }
    if (!picture.convert) {
        return {{}, light, light};
    }
    LookConversion out{{}, look.input.value_or(light), look.output.value_or(light)};
    if (look.input && !look.output) {
        out.gives = is_scene(look.input) ? lutlib::srgb() : *look.input;
    }
    out.is_picture = is_scene(out.fed) && !is_scene(out.gives);
    return out;
}

std::string sentence_of(const LookConversion& scene) {
    const std::string fed = scene.fed.name(), gives = scene.gives.name();
    const std::string out = "it stands before the tone map and gets scene light as " + fed;
    if (scene.is_picture) {
        return out + "; what it gives is the picture in " + gives + ", which no tone map follows";
    }
    return out + "; what it gives is light in " + gives + ", which the tone map follows";
}

/// What a look of that place cannot get there; empty where it gets what it is made for.
std::string mismatch_of(const lutlib::LookEncodings& look, bool is_before,
                        const PictureCodes& picture) {
    if (!look.input) {
        return "";
    }
    if (is_before && !is_scene(look.input)) {
        return "the look is made for a display's codes: light above white is beyond its table";
    }
    if (!is_before && is_scene(look.input) && !is_scene(picture.encoding)) {
        return "the look is made for scene light, and " +
               std::string(picture.has_light ? "what the tone map makes of it ends at white"
                                             : "this picture's codes end at white: if they are "
                                               "not a display's, name --picture-encoding");
    }
    return "";
}

/// Behind a tone map, and of a look whose results nobody knows: the picture's own.
Encoding shown_encoding(const LookStanding& standing, const PictureCodes& picture) {
    if (standing.conversion) {
        return standing.conversion->is_picture ? lutlib::srgb() : picture.encoding;
    }
    return standing.place.applied().converts()
               ? lutlib::srgb()
               : standing.place.look.output.value_or(picture.encoding);
}

void add(std::string& text, const std::string& more) {
    text += text.empty() || more.empty() ? more : "; " + more;
}

} // namespace

LookStanding standing_of(const lutlib::LookEncodings& look, const GpuLookup* lookup,
                         const PictureCodes& picture) {
    LookStanding out;
    if (stands_before(look, lookup, picture)) {
        out.conversion = before_tonemap(look, lookup, picture);
        out.place = {look, out.conversion->fed, out.conversion->gives, picture.convert};
        out.sentence = sentence_of(*out.conversion);
        if (out.place.needed().converts() || out.place.is_unknown()) {
            add(out.sentence,
                lutlib::sentence_of(out.place, lookup != nullptr && lookup->engine != nullptr
                                                   ? lookup->engine->name
                                                   : "the place before the tone map"));
        }
        out.is_told = true;
    } else {
        out.place = {look, picture.encoding, lutlib::srgb(), picture.convert};
        out.sentence = lutlib::sentence_of(out.place, "the picture");
        out.is_told =
            out.place.applied().converts() || out.place.is_wrong() || out.place.is_unknown();
        if (out.place.applied().converts() && (lookup == nullptr || lookup->engine == nullptr)) {
            out.conversion = LookConversion{picture.encoding, look.input.value_or(picture.encoding),
                                            look.output.value_or(lutlib::srgb()), true};
            out.place = {look, out.conversion->fed, out.conversion->gives, true};
        }
    }
    out.shown = shown_encoding(out, picture);
    const std::string mismatch = mismatch_of(look, out.is_before(), picture);
    add(out.sentence, mismatch);
    out.is_told = out.is_told || !mismatch.empty();
    return out;
}

} // namespace preview
