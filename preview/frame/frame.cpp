#include "preview/frame/frame.h"

#include "lutlib/error.h"
#include "lutlib/named.h"
#include "preview/frame/instruments.h"
#include "preview/passes/fxaa.h"
#include "preview/passes/shadow.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace preview {

namespace {

template <class T>
BufferHandle data_or_nothing(Graph& graph, std::string_view name, const std::vector<T>& blocks) {
    return blocks.empty() ? BufferHandle{} : graph.data(name, std::as_bytes(std::span(blocks)));
}

struct DeclaredScene {
    SceneHandles handles;
    std::vector<ShadowMap> shadow_maps;
    std::vector<Draw> visible;
};

/// The lights that reach the frame, named.
std::vector<PointLight> shining_lights(Graph& graph, const std::vector<PointLight>& lights,
                                       const FrameSettings& settings) {
    std::vector<PointLight> shining;
    if (settings.without.has(Effect::lights))
        return shining;
    for (std::size_t index = 0; index < lights.size(); ++index) {
        PointLight light = lights[index];
        light.name = "light " + (light.name.empty() ? std::to_string(index) : light.name);
        if (!light.is_on)
            graph.withhold(light.name, "switched off");
        else if (!settings.force_all && light.intensity == glm::vec3(0))
            graph.withhold(light.name, "its intensity is 0");
        else
            shining.push_back(std::move(light));
    }
    return shining;
}

DeclaredScene declare_scene(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                            Size size) {
    DeclaredScene out;
    const Scene& scene = *inputs.scene;
    const GpuScene& gpu_scene = *inputs.gpu_scene;
    const Geometry& geometry = gpu_scene.geometry;
    const std::vector<PointLight> lights =
        shining_lights(graph, inputs.lights != nullptr ? *inputs.lights : scene.lights, settings);
    std::vector<int> layers;
    for (std::uint32_t index = 0; index < lights.size(); ++index) {
        if (settings.without.has(Effect::shadows)) {
            layers.push_back(-1);
            continue;
        }
        const ShadowCasters casters = shadow_casters(scene, geometry, lights[index]);
        if (casters.objects.empty()) {
            graph.withhold("shadow of " + lights[index].name, casters.reason);
            layers.push_back(-1);
        } else {
            layers.push_back(static_cast<int>(out.shadow_maps.size()));
            out.shadow_maps.push_back(
                {lights[index].name, index, draws_of(scene, geometry, casters.objects)});
        }
    }
    const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
    const ViewBlock view = view_block(settings.orbit, aspect);
    out.visible = draws_of(scene, geometry, visible_objects(scene, geometry, view.clip));

    SceneHandles& handles = out.handles;
    handles.vertices = graph.import("vertices", gpu_scene.vertices, gpu_scene.vertices.bytes());
    handles.indices = graph.import("indices", gpu_scene.indices, gpu_scene.indices.bytes());
    handles.objects = data_or_nothing(graph, "objects", object_blocks(scene));
    handles.materials = data_or_nothing(graph, "materials", material_blocks(scene));
    handles.lights =
        data_or_nothing(graph, "lights", light_blocks(lights, layers, settings.shadow_size));
    handles.environment = graph.data_of("environment", environment_block(scene.environment));
    handles.view = graph.data_of("view", view);
    handles.light_count = static_cast<std::uint32_t>(lights.size());
    return out;
}

/// Radiance of the scene; fills in what it is made of.
ImageHandle render_scene(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                         Size size, FrameHandles& handles) {
    const Scene& scene = *inputs.scene;
    DeclaredScene declared = declare_scene(graph, inputs, settings, size);
    handles.shadow_maps =
        add_shadows(graph, declared.handles, settings.shadow_size, std::move(declared.shadow_maps));
    handles.surfaces =
        settings.raster == Raster::compute
            ? add_visibility(graph, declared.handles, size, declared.visible, settings.visibility)
            : add_gbuffer(graph, declared.handles, size, std::move(declared.visible));
    handles.materials = declared.handles.materials;
    LightingInputs lighting;
    lighting.surfaces = handles.surfaces;
    lighting.shadow_maps = handles.shadow_maps;
    const bool has_surroundings = !settings.without.has(Effect::environment);
    lighting.environment =
        has_surroundings && (settings.force_all || !scene.environment.is_black());
    if (has_surroundings && !lighting.environment)
        graph.withhold("environment", "the surroundings are black");
    return add_lighting(graph, declared.handles, lighting);
}

/// Why there is no bloom; empty when there is.
std::string_view no_bloom_because(const FrameInputs& inputs, const FrameSettings& settings,
                                  const BloomPlan& plan) {
    if (settings.tonemap == nullptr)
        return "the picture is display-encoded already";
    if (settings.bloom == nullptr || plan.empty())
        return "it is off, or its strength is 0";
    if (!settings.force_all && inputs.hdr_maximum &&
        static_cast<double>(*inputs.hdr_maximum) <= bloom_onset(settings.bloom_settings))
        return "no light is bright enough to bloom";
    return {};
}

BloomLayers bloom_of(Graph& graph, ImageHandle hdr, const FrameInputs& inputs,
                     const FrameSettings& settings) {
    if (settings.without.has(Effect::bloom))
        return {};
    const Size size = size_of(graph, hdr);
    BloomPlan plan;
    if (settings.bloom != nullptr)
        plan = bloom_plan(*settings.bloom,
                          {static_cast<int>(size.width), static_cast<int>(size.height)},
                          settings.bloom_settings);
    const std::string_view reason = no_bloom_because(inputs, settings, plan);
    if (!reason.empty()) {
        graph.withhold("bloom", reason);
        return {};
    }
    return add_bloom(graph, hdr, plan);
}

constexpr DebugView views[] = {
    {.name = "depth",
     .help = "distance from the camera, near is bright",
     .handle = [](const FrameHandles& h) { return h.surfaces.depth; },
     .view = {.shader = "view_depth.comp"}},
    {.name = "normal",
     .help = "world-space normals as n / 2 + 1/2",
     .handle = [](const FrameHandles& h) { return h.surfaces.normal; },
     .view = {.shader = "view_normal.comp"}},
    {.name = "albedo",
     .help = "surface colour",
     .handle = [](const FrameHandles& h) { return h.surfaces.material; },
     .view = {.shader = "view_albedo.comp", .shows_material = true}},
    {.name = "roughness",
     .help = "perceptual roughness",
     .handle = [](const FrameHandles& h) { return h.surfaces.material; },
     .view = {.shader = "view_roughness.comp", .shows_material = true}},
    {.name = "metalness",
     .help = "metalness",
     .handle = [](const FrameHandles& h) { return h.surfaces.material; },
     .view = {.shader = "view_metalness.comp", .shows_material = true}},
    {.name = "emission",
     .help = "light that surfaces emit",
     .handle = [](const FrameHandles& h) { return h.surfaces.material; },
     .view = {.shader = "view_emission.comp", .shows_material = true}},
    {.name = "shadows",
     .help = "the shadow maps side by side, near is bright",
     .handle = [](const FrameHandles& h) { return h.shadow_maps; },
     .view = {.shader = "view_shadow.comp"}},
    {.name = "lit",
     .help = "radiance before the HDR resolve",
     .handle = [](const FrameHandles& h) { return h.lit; },
     .view = {.shader = "view_light.comp"}},
    {.name = "hdr",
     .help = "exposed light after the HDR resolve",
     .handle = [](const FrameHandles& h) { return h.hdr; },
     .view = {.shader = "view_light.comp"}},
    {.name = "bloom",
     .help = "the last level of the bloom, before its composite",
     .handle = [](const FrameHandles& h) { return h.bloom; },
     .view = {.shader = "view_light.comp"}},
    {.name = "graded",
     .help = "the finished picture before antialiasing",
     .handle = [](const FrameHandles& h) { return h.graded; },
     .view = {.shader = "view_codes.comp"}},
};

/// What the finishing pass is asked for; says which looks there are not.
Finishing finishing_of(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings) {
    Finishing out;
    out.settings.tonemap = settings.tonemap;
    if (settings.tonemap != nullptr && settings.without.has(Effect::tonemap))
        out.settings.tonemap = tonemap_named("none");
    out.settings.compare = settings.compare;
    out.settings.split = settings.split;
    out.settings.heat_scale = settings.heat_scale;
    if (settings.without.has(Effect::looks))
        return out;
    if (settings.compare->shows_a && inputs.look_a == nullptr)
        graph.withhold("look A", "there is none");
    if (settings.compare->shows_b && inputs.look_b == nullptr)
        graph.withhold("look B", "there is none");
    out.look_a = inputs.look_a;
    out.look_b = inputs.look_b;
    return out;
}

ImageHandle antialiased(Graph& graph, ImageHandle picture, const FrameSettings& settings) {
    if (settings.without.has(Effect::fxaa))
        return picture;
    if (settings.compare == &compare_difference) {
        graph.withhold("fxaa", "a heat map has no edges to smooth");
        return picture;
    }
    return add_fxaa(graph, picture);
}

} // namespace

std::span<const DebugView> debug_views() {
    return views;
}

const DebugView* debug_view_named(std::string_view name) {
    return lutlib::find_named(views, name);
}

FrameHandles build_frame(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings) {
    const Size size = picture_size(settings.output, *settings.compare);
    FrameHandles handles;
    for (const EffectInfo& row : effects)
        if (settings.without.has(row.effect))
            graph.withhold(row.name, "switched off");

    if (inputs.picture != nullptr) {
        graph.withhold("scene", "a picture is shown");
        handles.lit = graph.import("picture", inputs.picture->image, inputs.picture->image.desc());
    } else {
        handles.lit = render_scene(graph, inputs, settings, size, handles);
    }

    const Resolved resolved = add_resolve(graph, handles.lit, size, std::exp2(settings.exposure));
    handles.hdr = resolved.hdr;
    handles.hdr_maximum = resolved.maximum;

    Finishing finishing = finishing_of(graph, inputs, settings);
    finishing.picture = handles.hdr;
    finishing.bloom = bloom_of(graph, handles.hdr, inputs, settings);
    handles.bloom = finishing.bloom.images[0];
    const Finished finished = add_finish(graph, finishing);
    handles.graded = finished.picture;
    handles.figures = finished.figures;
    handles.output = antialiased(graph, handles.graded, settings);

    if (settings.view != nullptr) {
        const ImageHandle shown = settings.view->handle(handles);
        if (!shown)
            throw lutlib::UsageError("this frame has no '" + std::string(settings.view->name) +
                                     "' to show; --explain says why");
        handles.output =
            add_view(graph, shown, settings.view->view, settings.output, handles.materials);
        graph.present(handles.output);
        return handles;
    }
    add_instruments(graph, settings, finishing, handles);
    graph.present(handles.output);
    graph.present(handles.hdr_maximum);
    if (settings.keep_hdr)
        graph.present(handles.hdr);
    if (handles.figures)
        graph.present(handles.figures);
    return handles;
}

} // namespace preview
