// Post effects: what may be laid over a frame beside what every frame has, as a table of rows. A
// row is a file preview/effects/NAME.cpp with a shader shaders/NAME.comp and a line in effects.cpp;
// the command line, the panel, undo, --explain, --list, the debug views and the timings follow it.
//
// An effect is opted into. Its first parameter is its strength, from 0: at 0 it is left out and
// costs nothing.
#pragma once

#include "lutlib/ops/op.h"
#include "preview/finish/effect_use.h"
#include "preview/graph/graph.h"

#include <span>
#include <string>
#include <string_view>

namespace preview {

/// Where in the frame an effect stands, and so what its picture holds.
enum class Stage : std::uint8_t {
    hdr,            ///< exposed light, 0..65504, before bloom
    before_tonemap, ///< the same with its bloom
    before_look,    ///< display-encoded colours, 0..1, that the looks then take
    after_look,     ///< the same with the looks
    last,           ///< the same with every other effect, before the split line
};
/// Whether its picture holds display-encoded colours.
constexpr bool is_on_codes(Stage stage) {
    return stage >= Stage::before_look;
}

struct StageInfo {
    Stage stage;
    std::string_view name;
    std::string_view help;
};

/// In the order of the enumeration, which is that of the frame.
std::span<const StageInfo> stages();

/// What the camera of a scene has seen, for effects whose row asks for it.
struct EffectDepth {
    ImageHandle image;    ///< 1 - near_plane / z, 1 where there is nothing; as wide as one side
    float near_plane = 0; ///< metres
    float nearest = 0;    ///< metres; no surface in the picture is nearer
    /// Of the projection: what lies at z metres and z / focal metres above the axis is at the upper
    /// border.
    float focal = 1;

    explicit operator bool() const { return near_plane > 0; }
};

/// What an effect is laid over. Lengths in pictures are shares of their height, so that two
/// resolutions look alike.
struct EffectInput {
    ImageHandle picture;
    /// Columns of one side's picture: side by side, B starts this far to the right.
    std::uint32_t width = 0;
    double seconds = 0;  ///< the moment that is shown; the same moment gives the same picture
    EffectDepth depth{}; ///< of rows that need it; of a scene
};

struct PostEffect {
    std::string_view name; ///< also of its pass, or the beginning of its passes' names
    std::string_view label;
    std::string_view help;
    std::string_view reference; ///< where the formula is published, or the formula
    Stage stage = Stage::after_look;
    /// Numbers and toggles; the first is `strength`, whose fallback is that of an effect in use.
    std::span<const lutlib::Parameter> parameters;
    bool usual_for_scenes = false; ///< in use for scenes, unless it is taken out
    /// Needs what the camera of a scene has seen; of pictures it is left out.
    bool needs_depth = false;
    /// Why it would change nothing in a picture of so many rows; empty: it does. Null: never.
    std::string_view (*idle_because)(const lutlib::Values& values, const EffectDepth& depth,
                                     std::uint32_t rows) = nullptr;
    /// Why a parameter changes nothing at this moment beside the other values; empty: it does.
    /// Null: each always does.
    std::string_view (*idle_parameter)(const lutlib::Values& values, std::size_t parameter,
                                       double seconds) = nullptr;
    /// Declares its passes. Returns a picture of the same size and format; values are in range.
    ImageHandle (*add)(Graph& graph, const EffectInput& in, const lutlib::Values& values) = nullptr;
};

/// Of a parameter that says how fast something changes.
inline std::string_view idle_rate(double seconds) {
    return seconds == 0 ? "at --time 0 nothing has moved yet" : "";
}

/// For the functions of a row.
inline float number_at(const lutlib::Values& values, std::size_t parameter) {
    return static_cast<float>(std::get<double>(values[parameter]));
}
/// The number of the step of time in which a moment lies, with so many steps a second.
std::uint32_t step_at(double seconds, double rate);

/// Every effect; of one stage they are laid over in the order in which they are used.
std::span<const PostEffect* const> post_effects();
const PostEffect* post_effect_named(std::string_view name);

/// With every parameter at its fallback.
EffectUse usual_use(const PostEffect& effect);
double strength_of(const EffectUse& use);
/// Where it stands: the effect's stage, or before the looks by choice.
Stage stage_of(const EffectUse& use);
/// Whether that choice is there: of effects after the looks.
bool can_stand_before_look(const PostEffect& effect);

/// Sets a parameter, which must be there.
void set_number(EffectUse& use, std::string_view parameter, double value);

/// The use of an effect; null when there is none.
const EffectUse* use_of(const EffectUses& uses, const PostEffect& effect);
/// Replaces the use of that effect, or adds one behind the others.
void put_use(EffectUses& uses, EffectUse use);
void take_out(EffectUses& uses, const PostEffect& effect);
/// Puts in the effects that are usual for scenes, in front of the others, or takes them out.
void set_usual(EffectUses& uses, bool is_scene);

/// NAME or NAME:PARAMETER=VALUE,... as on the command line; what is not named is at its fallback.
/// `before-look=1` puts an effect that stands after the looks before them. Throws
/// lutlib::UsageError.
EffectUse parse_use(const std::string& text);
/// The same the other way round, with every parameter.
std::string use_text(const EffectUse& use);

} // namespace preview
