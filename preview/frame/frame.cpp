#include "preview/frame/frame.h"

#include "lutlib/error.h"
#include "preview/effects/fusion.h"
#include "preview/frame/frame_effects.h"
#include "preview/frame/frame_scene.h"
#include "preview/frame/frame_stills.h"
#include "preview/frame/frame_zoom.h"
#include "preview/frame/instruments.h"
#include "preview/look/gpu_look.h"
#include "preview/passes/bloom_composite.h"
#include "preview/passes/copy.h"
#include "preview/passes/dither.h"
#include "preview/passes/finish.h"
#include "preview/passes/names.h"
#include "preview/passes/picture_view.h"
#include "preview/passes/resolve.h"
#include "preview/passes/split_line.h"
#include "preview/scene/gpu_scene.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace preview {

namespace {

/// Exposes and measures handles.lit into handles.hdr. The codes of a picture that needs neither
/// reach the looks as they are.
void resolve(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings, Size size,
             FrameHandles& handles) {
    const float stops = settings.exposure + (inputs.scene != nullptr ? inputs.scene->exposure : 0);
    const bool has_codes = is_display_encoded(inputs);
    if (has_codes && stops == 0 && size_of(graph, handles.lit) == size) {
        graph.withhold("hdr resolve", "the picture's codes reach the looks as they are");
        handles.hdr = handles.lit;
        return;
    }
    const bool measures = !has_codes || settings.force_all;
    if (!measures) {
        graph.withhold("hdr maximum",
                       "nothing blooms of a picture that is display-encoded already");
    }
    const Resolved resolved = add_resolve(graph, handles.lit, size, std::exp2(stops),
                                          {.format = has_codes ? Format::rgba32f : Format::rgba16f,
                                           .is_kept = settings.reuses_light(),
                                           .measures = measures});
    handles.hdr = resolved.hdr;
    handles.hdr_maximum = resolved.maximum;
}

/// Why there is no bloom; empty when there is.
std::string_view no_bloom_because(const FrameInputs& inputs, const FrameSettings& settings,
                                  const EffectUses& drawn, const BloomPlan& plan) {
    if (is_display_encoded(inputs)) {
        return "the picture is display-encoded already";
    }
    if (settings.bloom == nullptr || plan.empty()) {
        return "it is off, or its strength is 0";
    }
    // What was measured is the light before effects, which may have brightened it.
    const bool is_measured = inputs.hdr_maximum && !has_stage(drawn, Stage::hdr);
    if (!settings.force_all && is_measured &&
        static_cast<double>(*inputs.hdr_maximum) <= bloom_onset(settings.bloom_settings)) {
        return "no light is bright enough to bloom";
    }
    return {};
}

Bloomed bloom_of(Graph& graph, ImageHandle hdr, const FrameInputs& inputs,
                 const FrameSettings& settings, const EffectUses& drawn) {
    if (settings.without.has(Effect::bloom)) {
        return {};
    }
    const Size size = size_of(graph, hdr);
    BloomPlan plan;
    if (settings.bloom != nullptr) {
        plan = bloom_plan(*settings.bloom,
                          {static_cast<int>(size.width), static_cast<int>(size.height)},
                          settings.bloom_settings);
    }
    const std::string_view reason = no_bloom_because(inputs, settings, drawn, plan);
    if (!reason.empty()) {
        graph.withhold("bloom", reason);
        return {};
    }
    return add_bloom(graph, hdr, plan,
                     {.format = settings.bloom_format, .is_kept = settings.reuses_light()});
}

/// What the finishing pass is asked for; says which looks there are not.
Finishing finishing_of(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings) {
    Finishing out;
    if (!is_display_encoded(inputs)) {
        out.settings.tonemap =
            settings.without.has(Effect::tonemap) ? tonemap_named("none") : settings.tonemap;
    }
    out.settings.format = settings.format;
    out.settings.compare = settings.compare;
    static_cast<Wipe&>(out.settings) = settings;
    out.settings.heat_scale = settings.heat_scale < 0 ? usual_heat_scale : settings.heat_scale;
    if (settings.without.has(Effect::looks)) {
        return out;
    }
    if (settings.compare->shows_a && inputs.look_a == nullptr) {
        graph.withhold("look A", inputs.no_look[0]);
    }
    if (settings.compare->shows_b && inputs.look_b == nullptr) {
        graph.withhold("look B", inputs.no_look[1]);
    }
    const auto tell_curves = [&](bool is_shown, const GpuLook* look, std::string_view name) {
        if (is_shown && look != nullptr && look->is_curves()) {
            graph.withhold(name, "its channels do not mix: a lookup in its curves does");
        }
    };
    tell_curves(settings.compare->shows_a, inputs.look_a, "lattice of look A");
    tell_curves(settings.compare->shows_b, inputs.look_b, "lattice of look B");
    out.look_a = inputs.look_a;
    out.look_b = inputs.look_b;
    const auto is_tone_mapped = [](bool is_shown, const GpuLook* look) {
        constexpr std::uint32_t untouched = PlaceBits::before | PlaceBits::is_picture;
        return is_shown && (look == nullptr || (look->place & untouched) != untouched);
    };
    if (!is_display_encoded(inputs) && !is_tone_mapped(settings.compare->shows_a, inputs.look_a) &&
        !is_tone_mapped(settings.compare->shows_b, inputs.look_b)) {
        graph.withhold("tone map", "the look gives the picture itself");
    }
    return out;
}

/// Turns the light of `finishing` into codes, for effects that change them before the looks.
void tone_map(Graph& graph, Finishing& finishing) {
    Finishing codes = finishing;
    codes.look_a = codes.look_b = nullptr;
    codes.settings.compare = &compare_a;
    if (codes.settings.format != Format::rgba32f) {
        codes.settings.format = Format::rgba16f;
    }
    codes.settings.name = "tone map";
    finishing.picture = add_finish(graph, codes).picture;
    finishing.bloom = {};
    finishing.settings.tonemap = nullptr;
}

/// Why the picture is shown as it is; empty where a view of it is shown.
std::string_view no_view_because(const FrameSettings& settings) {
    return settings.picture_view->is_picture()       ? "the picture itself is shown"
           : settings.compare == &compare_difference ? "a heat map is no picture to look at"
           : settings.scope != nullptr               ? "a scope is shown"
           : settings.shows_intermediate()           ? "an intermediate is shown"
                                                     : "";
}

/// Finishes handles.hdr into handles.graded, and lays over it what stands after the look.
void finish(Graph& graph, const FrameSettings& settings, const DrawnEffects& drawn,
            Finishing& finishing, FrameHandles& handles) {
    const Fusion fusion = fusion_of(drawn.uses, *settings.compare);
    if (fusion.is_bloom_apart) {
        finishing.picture = with_effects(graph, Stage::before_tonemap, drawn,
                                         add_bloom_composite(graph, finishing), handles);
        finishing.bloom = {};
    } else {
        graph.withhold("bloom composite", "the finishing pass does it: no effect reads its result");
    }
    if (has_stage(drawn.uses, Stage::before_look)) {
        if (finishing.settings.tonemap != nullptr) {
            tone_map(graph, finishing);
        }
        finishing.picture =
            with_effects(graph, Stage::before_look, drawn, finishing.picture, handles);
    }
    const bool is_viewed = no_view_because(settings).empty();
    const bool is_zoomed = zooms(settings);
    const bool is_line_apart = fusion.is_line_apart || (is_viewed && settings.compare->shows_one);
    finishing.settings.has_marks = !is_line_apart && !is_zoomed;
    const bool rounds = settings.format == Format::rgba8 && settings.compare != &compare_difference;
    const bool dithers = settings.dithers && rounds;
    // Effects take what is not yet rounded; antialiasing alone is not worth a pass for it.
    const bool rounds_apart =
        rounds && !dithers && (is_viewed || has_stage(drawn.uses, Stage::after_look));
    if (dithers) {
        finishing.settings.format = Format::rgba32f;
    } else {
        if (rounds_apart) {
            finishing.settings.format = is_viewed ? Format::rgba32f : Format::rgba16f;
        }
        graph.withhold("dither", settings.dithers ? "there are no 8 bits of colour to round to"
                                                  : "it is off");
    }
    if (is_viewed && settings.picture_view->reads_before) {
        Finishing before = finishing;
        before.look_a = before.look_b = nullptr;
        before.settings.name = "before the looks";
        handles.before_looks = add_finish(graph, before).picture;
    }
    const Finished finished = add_finish(graph, finishing);
    handles.graded = finished.picture;
    handles.figures = finished.figures;
    handles.output = with_effects(graph, Stage::after_look, drawn, handles.graded, handles);
    handles.output = with_effects(graph, Stage::last, drawn, handles.output, handles);
    handles.unrounded = handles.output;
    if (dithers) {
        handles.output = add_dither(graph, handles.output);
    } else if (rounds_apart) {
        handles.output = add_copy(graph, handles.output, Format::rgba8);
    }
    if (is_zoomed) {
        return; // the line is drawn over what is seen
    }
    if (is_line_apart) {
        handles.output =
            add_split_line(graph, handles.output, *settings.compare,
                           wipe_shape(settings, *settings.compare, size_of(graph, handles.hdr)));
    } else if (settings.compare->shows_one) {
        graph.withhold("split line", "the finishing pass draws it: no effect comes after the look");
    }
}

/// Looks at the picture as settings.picture_view does.
void view_picture(Graph& graph, const FrameSettings& settings, const WipeShape& wipe,
                  FrameHandles& handles) {
    const std::string_view reason = no_view_because(settings);
    if (!reason.empty()) {
        graph.withhold("view of the picture", reason);
        return;
    }
    handles.output =
        add_picture_view(graph, {handles.unrounded, handles.before_looks}, *settings.picture_view,
                         settings.zebra_level, settings.format);
    if (settings.compare->shows_one) {
        handles.output = add_split_line(graph, handles.output, *settings.compare, wipe);
    }
}

/// Names the sides of a comparison that shows both, over all else.
void name_sides(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                const WipeShape& wipe, FrameHandles& handles) {
    const bool shows_both = settings.compare->shows_one || settings.compare == &compare_side;
    const bool has_names = !inputs.names[0].empty() || !inputs.names[1].empty();
    if (shows_both && has_names && !settings.without.has(Effect::names)) {
        handles.output = add_names(graph, handles.output, *settings.compare, inputs.names, wipe);
    } else if (!settings.without.has(Effect::names)) {
        graph.withhold("names", shows_both ? "nobody has given any" : "the two sides are not seen");
    }
}

/// Shows an intermediate in place of the picture.
void show(Graph& graph, const FrameSettings& settings, std::string_view name, ImageHandle shown,
          const View& view, FrameHandles& handles) {
    if (!shown) {
        throw lutlib::UsageError("this frame has no '" + std::string(name) +
                                 "' to show; --explain says why");
    }
    handles.output = add_view(graph, shown, view,
                              {.size = settings.output,
                               .format = settings.format,
                               .as_numbers = settings.shows_numbers,
                               .near_plane = settings.orbit.near_plane},
                              handles.materials, handles.surfaces);
    graph.present(handles.output);
}

void show_effect(Graph& graph, const FrameSettings& settings, FrameHandles& handles) {
    const PostEffect& effect = *settings.effect_view;
    const auto made = std::find_if(handles.effects.begin(), handles.effects.end(),
                                   [&](const EffectPicture& it) { return it.effect == &effect; });
    show(graph, settings, effect.name,
         made == handles.effects.end() ? ImageHandle{} : made->picture,
         View{is_on_codes(effect.stage) ? "view_codes.comp" : "view_light.comp"}, handles);
}

} // namespace

FrameHandles build_frame(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings) {
    const Size size = finished_size(inputs, settings);
    FrameHandles handles;
    for (const EffectInfo& row : effects) {
        if (settings.without.has(row.effect)) {
            graph.withhold(row.name, "switched off");
        }
    }

    if (inputs.picture != nullptr) {
        graph.withhold("scene", "a picture is shown");
        handles.lit = graph.import("picture", inputs.picture->image, inputs.picture->image.desc());
    } else {
        handles.lit = render_scene(graph, inputs, settings, size, handles);
    }

    std::optional<FrameSettings> beside;
    if (compares_stills(inputs, settings)) {
        beside = beside_stills(inputs, settings);
    }
    const FrameSettings& finished = beside ? *beside : settings;
    DrawnEffects drawn = drawn_effects(graph, inputs, finished, size, handles);
    resolve(graph, inputs, settings, size, handles);
    if (settings.only_maximum && handles.hdr_maximum) {
        graph.present(handles.hdr_maximum);
        if (settings.reuses_light() || settings.keep_hdr) {
            graph.present(handles.hdr);
        }
        return handles;
    }
    drawn.given.width = size_of(graph, handles.hdr).width;
    handles.hdr = with_effects(graph, Stage::hdr, drawn, handles.hdr, handles);

    Finishing finishing = finishing_of(graph, inputs, finished);
    finishing.picture = handles.hdr;
    finishing.bloom = bloom_of(graph, handles.hdr, inputs, settings, drawn.uses);
    handles.bloomed = finishing.bloom;
    handles.bloom = finishing.bloom.glow;
    finish(graph, finished, drawn, finishing, handles);
    fit_stills(graph, inputs, settings, handles);
    if (beside) {
        compare_with_stills(graph, settings, no_view_because(settings).empty(), handles);
    }

    if (settings.view != nullptr) {
        show(graph, settings, settings.view->name, settings.view->handle(handles),
             settings.view->view, handles);
        return handles;
    }
    if (settings.effect_view != nullptr) {
        show_effect(graph, settings, handles);
        return handles;
    }
    add_instruments(graph, inputs, settings, finishing, probe_place(inputs, settings, size),
                    handles);
    const WipeShape wipe =
        zoom_in(graph, inputs, settings, no_view_because(settings).empty(), handles);
    view_picture(graph, settings, wipe, handles);
    if (settings.scope == nullptr) {
        name_sides(graph, inputs, settings, wipe, handles);
    }
    graph.present(handles.output);
    if (handles.hdr_maximum) {
        graph.present(handles.hdr_maximum);
    }
    if (settings.keep_hdr) {
        graph.present(handles.hdr);
    }
    if (handles.figures) {
        graph.present(handles.figures);
    }
    return handles;
}

} // namespace preview
