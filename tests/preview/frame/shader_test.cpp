// Every pass declares what its shader expects: bindings, specialisation constants, push constants.
// And no shader is without a pass.
#include "preview/effects/effect.h"
#include "preview/frame/frame.h"
#include "preview/look/gpu_look.h"
#include "preview/look/look_bake.h"
#include "preview/passes/copy.h"
#include "preview/passes/plant.h"
#include "preview/scene/gpu_scene.h"
#include "tests/preview/frame/shader_interface.h"
#include "tests/preview/graph/gpu_test.h"

#include <algorithm>
#include <list>
#include <memory>
#include <set>
#include <string>

namespace preview {
namespace {

constexpr Size size{64, 36};

ShaderBinding declared_by(const Graph& graph, const Use& use) {
    ShaderBinding out;
    out.type = use.binding;
    if (use.binding != BindingType::sampled_image && use.binding != BindingType::storage_image) {
        return out;
    }
    if (use.version == Version::none) {
        out.volume = use.neutral == Neutral::black_3d;
        out.array = use.neutral == Neutral::lit;
        out.integer = use.neutral == Neutral::black_integer;
        return out;
    }
    const ImageDesc& image = graph.resource_of(use.version).image;
    out.volume = image.depth > 0;
    out.array = image.layers > 0;
    out.integer = is_integer(image.format);
    return out;
}

std::string text_of(const std::map<std::uint32_t, ShaderBinding>& bindings) {
    std::string text;
    for (const auto& [number, binding] : bindings) {
        text += std::to_string(number) + ":" + std::to_string(static_cast<int>(binding.type)) +
                (binding.volume ? " 3D" : "") + (binding.array ? " array" : "") +
                (binding.integer ? " integer" : "") + "  ";
    }
    return text;
}

/// The sample with materials that are cut out.
Scene cut_out_scene() {
    Scene scene = scene_at(*scene_named("studio"), 0);
    for (Material& material : scene.materials) {
        material.detail.least_coverage = 0.5F;
    }
    return scene;
}

class ShaderTest : public GpuTest {
  protected:
    ShaderTest() : scene_(scene_at(*scene_named("studio"), 0)), gpu_scene_(device(), scene_) {}

    static const gpu::ShaderCode& code(const std::string& name) {
        const auto all = gpu::shaders();
        const auto found = std::find_if(all.begin(), all.end(), [&](const gpu::ShaderCode& shader) {
            return shader.name == name;
        });
        if (found == all.end()) {
            throw std::runtime_error("there is no shader " + name);
        }
        return *found;
    }

    FrameInputs scene_inputs() const {
        FrameInputs out;
        out.scene = &scene_;
        out.gpu_scene = &gpu_scene_;
        return out;
    }

    FrameSettings settings() const {
        FrameSettings out;
        out.output = size;
        out.orbit = scene_.orbit;
        out.tonemap = tonemap_named("agx");
        out.bloom = bloom_named("glare");
        out.force_all = true;
        return out;
    }

    /// Holds each pass of the frame to its shaders, once for each way of declaring it.
    void check(const FrameInputs& inputs, const FrameSettings& settings) {
        Graph graph;
        build_frame(graph, inputs, settings);
        check(graph);
    }

    void check(const Graph& graph) {
        for (const PassRecord& pass : graph.passes()) {
            if (pass.kind != PassKind::fill) {
                check(graph, pass);
            }
        }
    }

    void check(const Graph& graph, const PassRecord& pass) {
        std::map<std::uint32_t, ShaderBinding> declared;
        for (const Use& use : pass.uses) {
            if (use.binding != BindingType::none) {
                declared.emplace(static_cast<std::uint32_t>(declared.size()),
                                 declared_by(graph, use));
            }
        }
        const std::string bindings = text_of(declared);
        if (!seen_
                 .insert(pass.shader + pass.fragment_shader + bindings +
                         std::to_string(pass.constants.size()))
                 .second) {
            return;
        }
        ShaderInterface wanted = interface_of(code(pass.shader));
        used_.insert(pass.shader);
        if (!pass.fragment_shader.empty()) {
            used_.insert(pass.fragment_shader);
            ShaderInterface fragment = interface_of(code(pass.fragment_shader));
            wanted.bindings.merge(fragment.bindings);
            wanted.constants.merge(fragment.constants);
            wanted.push_bytes = std::max(wanted.push_bytes, fragment.push_bytes);
        }
        std::set<std::uint32_t> constants;
        const bool tells_targets = std::any_of(pass.uses.begin(), pass.uses.end(),
                                               [](const Use& use) { return use.only_if_read; });
        for (std::uint32_t id = 0; id < pass.constants.size() + (tells_targets ? 1 : 0); ++id) {
            constants.insert(id);
        }
        EXPECT_EQ(text_of(wanted.bindings), bindings) << pass.name << ", " << pass.shader;
        EXPECT_EQ(wanted.constants, constants) << pass.name << ", " << pass.shader;
        EXPECT_EQ(wanted.push_bytes, pass.push_bytes) << pass.name << ", " << pass.shader;
    }

    Scene scene_;
    GpuScene gpu_scene_;
    std::set<std::string> seen_, used_;
};

TEST_F(ShaderTest, every_pass_declares_what_its_shader_expects_and_no_shader_is_unused) {
    const FrameInputs inputs = scene_inputs();
    for (const Raster raster : {Raster::hardware, Raster::compute}) {
        for (const DebugView& view : debug_views()) {
            FrameSettings changed = settings();
            changed.raster = raster;
            changed.view = &view;
            check(inputs, changed);
        }
    }
    const Scene cut_out = cut_out_scene();
    const GpuScene gpu_cut_out(device(), cut_out);
    FrameInputs detailed;
    detailed.scene = &cut_out;
    detailed.gpu_scene = &gpu_cut_out;
    for (const Raster raster : {Raster::hardware, Raster::compute}) {
        FrameSettings changed = settings();
        changed.raster = raster;
        changed.orbit = cut_out.orbit;
        check(detailed, changed);
        changed.view = debug_view_named("albedo");
        check(detailed, changed);
    }
    Scene see_through = cut_out;
    see_through.materials.front().detail.is_blended = true;
    FrameInputs blended = detailed;
    blended.scene = &see_through;
    check(blended, settings());
    FrameSettings forward = settings();
    forward.raster = Raster::forward;
    for (const FrameInputs& drawn : {inputs, detailed, blended}) {
        check(drawn, forward);
    }
    const GpuPicture around(device(), {4, 2}, std::vector<float>(std::size_t{4} * 4 * 2), false);
    for (const SurroundingsInfo& row : surroundings_kinds()) {
        Surroundings surroundings;
        surroundings.kind = row.kind;
        for (FrameInputs surrounded : {inputs, detailed}) {
            surrounded.surroundings = &surroundings;
            surrounded.surroundings_picture = &around;
            check(surrounded, settings());
        }
    }
    for (const Tonemap& row : tonemaps()) {
        FrameSettings changed = settings();
        changed.tonemap = &row;
        check(inputs, changed);
    }
    for (const PictureView& row : picture_views()) {
        FrameSettings changed = settings();
        changed.picture_view = &row;
        check(inputs, changed);
    }
    for (const Compare& compare : compares) {
        for (const Magnifier& row : magnifiers) {
            FrameSettings changed = settings();
            changed.compare = &compare;
            changed.zoom = {.scale = 2, .magnifier = &row};
            check(inputs, changed);
        }
    }
    for (const Bloom& row : blooms()) {
        for (const float threshold : {0.0F, 1.0F}) {
            FrameSettings changed = settings();
            changed.bloom = &row;
            changed.bloom_settings.threshold = threshold;
            check(inputs, changed);
            changed.output = {1280, 720}; // not all of them fits into a group
            check(inputs, changed);
        }
    }
    for (const EffectInfo& row : effects) {
        FrameSettings changed = settings();
        changed.without.set(row.effect, true);
        check(inputs, changed);
    }
    for (const PostEffect* effect : post_effects()) {
        for (const StageInfo& row : stages()) {
            PostEffect placed = *effect;
            placed.stage = row.stage;
            FrameSettings changed = settings();
            changed.compare = &compare_split;
            changed.effects = {usual_use(placed)};
            check(inputs, changed);
        }
    }
    FrameSettings instruments = settings();
    for (std::size_t i = 0; i < scopes.size(); ++i) {
        instruments.scope_sizes[i] = {scopes[i].width, scopes[i].height};
    }
    instruments.probe = ProbePlace{1, 1};
    instruments.dithers = true;
    instruments.axes = &lutlib::srgb();
    check(inputs, instruments);
    instruments.scope_levels.encoding = lutlib::encoding_named("pq");
    check(inputs, instruments);

    lutlib::Lut identity;
    identity.cube = lutlib::identity_cube(16);
    const auto look = std::make_shared<const lutlib::Lut>(std::move(identity));
    std::list<GpuLook> looks;
    for (const GpuLookup& row : gpu_lookups()) {
        if (row.source != GpuLookup::Source::none) {
            looks.emplace_back(device(), look_for(look, row).data);
        }
    }
    for (GpuLook& a : looks) {
        for (const bool half : {false, true}) {
            for (const Compare& compare : compares) {
                a.half_arithmetic = half;
                FrameSettings changed = instruments;
                changed.compare = &compare;
                FrameInputs graded = inputs;
                graded.look_a = &a;
                graded.look_b = &looks.back();
                graded.names = {"a", "b"};
                check(graded, changed);
            }
        }
    }

    for (const Size of_picture : {size, Size{size.width / 2, size.height}}) {
        const GpuPicture picture(
            device(), of_picture,
            std::vector<float>(std::size_t{4} * of_picture.width * of_picture.height), true);
        FrameInputs shown;
        shown.picture = &picture;
        FrameSettings changed = settings();
        check(shown, changed);
        for (const Compare& compare : compares) {
            FrameSettings beside = instruments;
            beside.compare = &compare;
            FrameInputs compared = inputs;
            compared.stills = {&picture, nullptr};
            check(compared, beside);
        }
        Graph copied;
        copied.present(add_copy(
            copied, copied.import("picture", picture.image, picture.image.desc()), Format::rgba8));
        copied.present(add_plant(
            copied, copied.import("planted", picture.image, picture.image.desc()), Planted{}));
        check(copied);
    }

    for (const gpu::ShaderCode& shader : gpu::shaders()) {
        EXPECT_TRUE(used_.contains(std::string(shader.name))) << "no pass runs " << shader.name;
    }
}

} // namespace
} // namespace preview
