// What is done with light once it is there: depth of field, the looks, antialiasing and effects.
#include "lutlib/error.h"
#include "preview/effects/effect.h"
#include "preview/look/gpu_look.h"
#include "preview/look/look_bake.h"
#include "preview/reference/depth_of_field.h"
#include "preview/report/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace preview::report {

namespace {

const PostEffect& depth_of_field() {
    return *post_effect_named("depth-of-field");
}

double number_of(const EffectUse& use, std::string_view parameter) {
    const auto& rows = use.effect->parameters;
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const lutlib::Parameter& row) {
        return parameter == row.name;
    });
    return static_cast<double>(
        number_at(use.values, static_cast<std::size_t>(found - rows.begin())));
}

// Depth of field

std::string_view no_depth(const Situation& s) {
    return s.has_scene() ? "" : "it needs the depth of a scene, and a picture has none";
}

/// The lens that is asked for, or the usual one; the finish is the tone map alone.
void prepare_depth_of_field(Situation& s) {
    const EffectUse* const asked = use_of(s.settings.effects, depth_of_field());
    s.settings.effects = {asked != nullptr ? *asked : usual_use(depth_of_field())};
    s.settings.bloom = bloom_named("none");
    s.settings.without.set(Effect::looks, true);
}

void set_lens(Situation& s, std::string_view parameter, int value) {
    const EffectUse* const asked = use_of(s.settings.effects, depth_of_field());
    EffectUse use = asked != nullptr ? *asked : usual_use(depth_of_field());
    set_number(use, parameter, value);
    put_use(s.settings.effects, std::move(use));
}

std::vector<Variant> lenses(const Situation& situation, const StudyTools&) {
    const EffectUse* const use = use_of(situation.settings.effects, depth_of_field());
    std::vector<Variant> out{{"none",
                              [](Situation& s) { take_out(s.settings.effects, depth_of_field()); },
                              use == nullptr}};
    for (const int rings : {1, 2, 3, 4, 6}) {
        out.push_back({fmt::format("{} points", 1 + 4 * rings * (rings + 1)),
                       [rings](Situation& s) { set_lens(s, "rings", rings); },
                       use != nullptr && std::lround(number_of(*use, "rings")) == rings});
    }
    const EffectUse asked = use != nullptr ? *use : usual_use(depth_of_field());
    const long rings = std::lround(number_of(asked, "rings")),
               usual_cell = std::lround(number_of(asked, "cell"));
    for (const int cell : {1, 2, 4}) {
        if (cell != usual_cell) {
            out.push_back({fmt::format("{} points, {}", 1 + 4 * rings * (rings + 1),
                                       cell == 1 ? "every pixel by itself"
                                                 : fmt::format("of {0}x{0} pixels", cell)),
                           [cell](Situation& s) { set_lens(s, "cell", cell); }});
        }
    }
    return out;
}

ImageHandle first_effect(Graph&, const FrameHandles& handles) {
    return handles.effects.empty() ? ImageHandle{} : handles.effects.front().picture;
}

/// Radius of each texel's circle, by the depths that the frame shows.
std::vector<double> radii_of(const Situation& s, const std::vector<float>& depths) {
    const EffectUse& use = s.settings.effects.front();
    const Size size = s.settings.output;
    const Camera camera = camera_of(s.settings.orbit, static_cast<float>(size.width) /
                                                          static_cast<float>(size.height));
    const auto z_of = [&](float depth) {
        return depth >= 1 ? 1e30
                          : static_cast<double>(s.settings.orbit.near_plane) /
                                (1 - static_cast<double>(depth));
    };
    const auto texel = [](double share, std::uint32_t length) {
        return std::min(static_cast<std::uint32_t>(share * length), length - 1);
    };
    reference::ThinLens lens;
    lens.sensor = number_of(use, "sensor") / 1000;
    lens.focal = lens.sensor / 2 * -static_cast<double>(camera.projection[1][1]);
    lens.aperture = number_of(use, "aperture") / strength_of(use);
    lens.largest = number_of(use, "largest") / 1000 * size.height / 2;
    lens.focus = number_of(use, "focus");
    if (lens.focus <= 0) {
        lens.focus = std::min(
            z_of(depths[std::size_t{texel(number_of(use, "at-y"), size.height)} * size.width +
                        texel(number_of(use, "at-x"), size.width)]),
            1e6);
    }
    std::vector<double> out;
    for (const float depth : depths) {
        out.push_back(reference::circle_radius(lens, z_of(depth), static_cast<int>(size.height)));
    }
    return out;
}

Truth focused_truth(const TruthRequest& request) {
    Situation sharp = request.base;
    sharp.settings.effects.clear();
    const Frame frame = request.tools.renderer.render(sharp, {.light = true, .depth = true});
    Truth out;
    out.result = reference::focused(frame.light, radii_of(request.base, frame.depth));
    out.finished = out.result;
    for (lutlib::RgbD& pixel : out.finished.pixels) {
        pixel = request.base.settings.tonemap->apply(pixel);
    }
    return out;
}

// Looks

std::string_view no_none(const Situation&) {
    return "";
}

void prepare_looks(Situation& s) {
    s.settings.effects.clear();
    s.settings.compare = &compare_a;
    s.settings.without.set(Effect::looks, false);
    s.look_a = s.look_b = nullptr;
}

std::vector<Variant> lookups(const Situation&, const StudyTools& tools) {
    std::vector<Variant> out{{"none", [](Situation&) {}, false, false}};
    const GpuLookup& usual = table_lookup(*tools.look.table);
    for (const GpuLookup& row : gpu_lookups()) {
        if (row.source == GpuLookup::Source::none) {
            continue;
        }
        try {
            const auto look = std::make_shared<const GpuLook>(
                tools.renderer.device(), look_for(tools.look.table, tools.look.exact, row).data);
            out.push_back({std::string(row.name), [look](Situation& s) { s.look_a = look.get(); },
                           &row == &usual});
        } catch (const lutlib::Error&) {
            continue; // it cannot hold this look
        }
    }
    return out;
}

/// Exactly the look, of the codes that it is given.
Truth look_truth(const TruthRequest& request) {
    Truth out;
    out.finished = request.tools.renderer.render(request.base).finished;
    auto& pixels = out.finished.pixels;
    constexpr std::size_t grain = 4096;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, pixels.size(), grain), [&](const auto& part) {
            const std::span some = std::span(pixels).subspan(part.begin(), part.size());
            request.tools.look.exact(some);
            for (lutlib::RgbD& pixel : some) {
                for (std::size_t c = 0; c < 3; ++c) {
                    pixel[c] = std::clamp(pixel[c], 0.0, 1.0);
                }
            }
        });
    out.result = out.finished;
    return out;
}

// Antialiasing

void prepare_antialiasing(Situation& s) {
    s.settings.effects.clear();
}

std::string_view no_edges(const Situation& s) {
    return s.has_scene() ? "" : "a picture has no edges of surfaces";
}

const PostEffect& fxaa() {
    return *post_effect_named("fxaa");
}

void set_antialiasing(Situation& s, bool is_specular, double strength) {
    s.settings.without.set(Effect::specular_aa, !is_specular);
    take_out(s.settings.effects, fxaa());
    if (strength > 0) {
        EffectUse use = usual_use(fxaa());
        set_number(use, "strength", strength);
        put_use(s.settings.effects, use);
    }
}

std::vector<Variant> antialiasings(const Situation& situation, const StudyTools&) {
    struct Row {
        const char* name;
        bool is_specular;
        double fxaa;
    };
    constexpr Row rows[] = {{"none", false, 0},
                            {"specular", true, 0},
                            {"fxaa", false, 1},
                            {"specular and half of fxaa", true, 0.5},
                            {"specular and fxaa", true, 1}};
    const EffectUse* const use = use_of(situation.settings.effects, fxaa());
    const double strength = use != nullptr ? strength_of(*use) : 0;
    std::vector<Variant> out;
    for (const Row& row : rows) {
        const bool is_usual =
            row.is_specular != situation.settings.without.has(Effect::specular_aa) &&
            row.fxaa == strength;
        out.push_back({row.name,
                       [row](Situation& s) { set_antialiasing(s, row.is_specular, row.fxaa); },
                       is_usual});
    }
    return out;
}

// Effects

bool has_a_study_of_its_own(const PostEffect& effect) {
    return effect.name == "fxaa" || effect.name == "depth-of-field";
}

std::vector<Variant> effect_rows(const Situation& situation, const StudyTools&) {
    std::vector<Variant> out;
    for (const PostEffect* const effect : post_effects()) {
        if (!has_a_study_of_its_own(*effect) && (situation.has_scene() || !effect->needs_depth)) {
            out.push_back({std::string(effect->name),
                           [effect](Situation& s) { s.settings.effects = {usual_use(*effect)}; },
                           false, false});
        }
    }
    return out;
}

bool is_of_an_effect(std::string_view pass) {
    const auto rows = post_effects();
    return std::any_of(rows.begin(), rows.end(),
                       [&](const PostEffect* row) { return pass.starts_with(row->name); });
}

Truth larger(const TruthRequest& request, const Situation& situation) {
    Truth out;
    out.finished = supersampled(request.tools.renderer, situation, supersamples);
    out.result = out.finished;
    return out;
}

} // namespace

StudiedLook usual_studied_look() {
    const auto formula = [](lutlib::RgbD c) {
        const double luma = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
        for (std::size_t i = 0; i < 3; ++i) {
            const double v = std::clamp(luma + 1.3 * (c[i] - luma), 0.0, 1.0);
            c[i] = v * v * (3 - 2 * v);
        }
        return c;
    };
    lutlib::Lut table;
    table.cube = lutlib::identity_cube(33);
    for (lutlib::Rgb& node : table.cube->nodes) {
        const lutlib::RgbD c = formula({static_cast<double>(node.r), static_cast<double>(node.g),
                                        static_cast<double>(node.b)});
        node = {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
    }
    return {"a saturated look with contrast", std::make_shared<const lutlib::Lut>(std::move(table)),
            lutlib::Transform::each(formula)};
}

const Study depth_of_field_study{
    .name = "depth-of-field",
    .title = "Depth of field",
    .help = "The points of a circle that are gathered, and the side of the cells of pixels that "
            "are blurred as one; 49 of two by two where nobody asks for others.",
    .reference = "Every texel spread over its own circle, and gathered, at full resolution in "
                 "double; then the tone map in double.",
    .none_because = no_depth,
    .variants = lenses,
    .truth = focused_truth,
    .counts = [](std::string_view pass) { return pass.starts_with("depth-of-field"); },
    .looked = {.result = first_effect},
    .prepare = prepare_depth_of_field,
    .is_truth_slow = true,
    .is_budgeted =
        [](const Situation& s) { return use_of(s.settings.effects, depth_of_field()) != nullptr; }};

const Study lookup_study{
    .name = "lookups",
    .title = "Look lookups",
    .help = "Every way of reading a look: engines' pictures as they are baked, the texture unit's "
            "filter, float tables, shared memory. The time is the whole finishing pass's.",
    .reference = "The look's own formula, recipe or table in double, of the codes that it gets.",
    .none_because = no_none,
    .variants = lookups,
    .truth = look_truth,
    .counts = [](std::string_view pass) { return pass == "finish"; },
    .prepare = prepare_looks,
    .takes_test_pictures = true,
    .is_budgeted = [](const Situation& s) { return s.look_a != nullptr || s.look_b != nullptr; }};

const Study antialiasing_study{
    .name = "antialiasing",
    .title = "Antialiasing",
    .help = "FXAA, and rougher surfaces where normals vary within a pixel.",
    .reference = "The same frame four times as wide and high, without either, averaged in double.",
    .none_because = no_edges,
    .variants = antialiasings,
    .truth =
        [](const TruthRequest& request) {
            Situation plain = request.base;
            set_antialiasing(plain, false, 0);
            return larger(request, plain);
        },
    .counts = [](std::string_view pass) { return pass == "fxaa" || pass == "g-buffer"; },
    .prepare = prepare_antialiasing,
    .converge = [](Situation& s, const StudyTools&) { set_antialiasing(s, false, 0); }};

const Study effect_study{
    .name = "effects",
    .title = "Stylised effects",
    .help = "Each by itself at this resolution. What is made of noise, cells and lines of texels "
            "differs from one resolution to the next by its nature, and so do edges of surfaces, "
            "which no effect smooths.",
    .reference = "The same four times as wide and high, averaged in double.",
    .none_because = no_none,
    .variants = effect_rows,
    .truth = [](const TruthRequest& request) { return larger(request, request.varied); },
    .counts = is_of_an_effect,
    .truth_key = [](const Situation&, const Variant& variant) { return variant.name; },
    .is_budgeted = [](const Situation&) { return false; }};

} // namespace preview::report
