// What of the g-buffer a frame writes: the targets that something reads, and no others.
#include "tests/preview/frame/frame_fixture.h"

#include <functional>
#include <map>
#include <set>

namespace preview {
namespace {

/// Bytes a pixel of each target of the g-buffer that the frame gives memory, by name.
using Targets = std::map<std::string, std::uint64_t>;

const Targets all_with_textures{
    {"albedo", 8}, {"depth", 4}, {"emission", 8}, {"material", 4}, {"normal", 4}};

class TargetsTest : public FrameTest {
  protected:
    static constexpr std::uint64_t pixels = std::uint64_t{size.width} * size.height;

    Executor executor_{device()};

    std::vector<Raster> rasters() const {
        return device().has_int64_atomics() ? std::vector{Raster::hardware, Raster::compute}
                                            : std::vector{Raster::hardware};
    }

    static FrameSettings settings_of(const Scene& scene) {
        FrameSettings out = settings_for(scene);
        out.format = Format::rgba32f;
        return out;
    }

    static Targets targets(const FrameInputs& inputs, const FrameSettings& settings) {
        static const std::set<std::string> names{"albedo", "depth", "emission", "material",
                                                 "normal"};
        Graph graph;
        build_frame(graph, inputs, settings);
        Targets out;
        for (const Lifetime& life : make_plan(graph).lifetimes) {
            const Resource& made = graph.resources()[life.resource];
            if (names.contains(made.name)) {
                out.emplace(made.name, made.image.bytes() / pixels);
            }
        }
        return out;
    }

    /// The targets of the frame; its picture is that of a frame with everything in it, to the bit.
    void expect(const Scene& scene, const Targets& wanted,
                const std::function<void(FrameSettings&)>& change = {}) {
        const Loaded loaded(scene);
        FrameSettings settings = settings_of(loaded.scene);
        if (change) {
            change(settings);
        }
        for (const Raster raster : rasters()) {
            settings.raster = raster;
            settings.force_all = false;
            EXPECT_EQ(targets(loaded.inputs(), settings), wanted) << static_cast<int>(raster);
            const Rendered usual = render_frame(executor_, loaded.inputs(), settings);
            settings.force_all = true;
            const Rendered forced = render_frame(executor_, loaded.inputs(), settings);
            EXPECT_EQ(usual.values, forced.values) << usual.explanation;
            if (settings.view == nullptr) {
                EXPECT_GE(targets(loaded.inputs(), settings).size(), wanted.size());
            }
        }
    }
};

void in_the_dark(FrameSettings& settings) {
    settings.without.set(Effect::lights, true);
    settings.without.set(Effect::environment, true);
}

Scene unlit(Scene scene) {
    for (Material& material : scene.materials) {
        material.detail.is_unlit = true;
    }
    return scene;
}

Scene glowing(Scene scene) {
    scene.materials.front().emission = {0.5F, 0.25F, 2};
    return scene;
}

TEST_F(TargetsTest, emission_is_a_target_where_some_surface_has_light_of_its_own) {
    const Scene textured = scene_at(*scene_named("materials"), 0);
    Targets without = all_with_textures;
    without.erase("emission");
    expect(textured, without);
    expect(glowing(textured), all_with_textures);
    Scene one_unlit = textured;
    one_unlit.materials.front().detail.is_unlit = true;
    expect(one_unlit, all_with_textures);
}

TEST_F(TargetsTest, where_nothing_is_lit_nobody_reads_normals_and_colors) {
    const Scene textured = scene_at(*scene_named("materials"), 0);
    expect(textured, {{"depth", 4}}, in_the_dark);
    expect(glowing(textured), {{"depth", 4}, {"emission", 8}}, in_the_dark);
    const Scene plain = scene_at(*scene_named("plain"), 0);
    expect(plain, {{"depth", 4}}, in_the_dark);
    expect(glowing(plain), {{"depth", 4}, {"material", 4}}, in_the_dark);
    expect(plain, {{"depth", 4}, {"material", 4}, {"normal", 4}});
}

TEST_F(TargetsTest, unlit_surfaces_have_their_own_light_and_a_depth) {
    Scene scene = unlit(scene_at(*scene_named("studio"), 0));
    scene.occlusion = 1;
    expect(scene, {{"depth", 4}, {"emission", 8}});
    Executor executor(device());
    const Loaded loaded(scene);
    const Rendered usual = render_frame(executor, loaded.inputs(), settings_of(scene));
    for (const char* line : {"every surface is unlit: no light changes any", "ambient occlusion",
                             "every surface is unlit"}) {
        EXPECT_NE(usual.explanation.find(line), std::string::npos) << usual.explanation;
    }
    EXPECT_EQ(usual.explanation.find("kept      shadow of"), std::string::npos);
    scene.surroundings.kind = SurroundingsKind::sky; // is still seen behind them
    expect(scene, {{"depth", 4}, {"emission", 8}});
}

TEST_F(TargetsTest, a_view_of_one_target_writes_that_one) {
    const Scene textured = glowing(scene_at(*scene_named("materials"), 0));
    for (const char* name : {"depth", "normal"}) {
        Targets wanted{{"depth", 4}};
        wanted.emplace(name, 4);
        expect(textured, wanted,
               [&](FrameSettings& settings) { settings.view = debug_view_named(name); });
    }
    Targets of_surfaces = all_with_textures;
    of_surfaces.erase("normal");
    expect(textured, of_surfaces,
           [](FrameSettings& settings) { settings.view = debug_view_named("roughness"); });
}

TEST_F(TargetsTest, what_is_not_written_is_not_moved_through_memory_either) {
    const Loaded loaded(scene_at(*scene_named("materials"), 0));
    FrameSettings settings = settings_of(loaded.scene);
    for (const Raster raster : rasters()) {
        settings.raster = raster;
        settings.without = {};
        render_frame(executor_, loaded.inputs(), settings);
        const std::uint64_t lit = executor_.unshared_bytes();
        in_the_dark(settings);
        render_frame(executor_, loaded.inputs(), settings);
        // Normals, materials and albedo, but for how the device pads images.
        EXPECT_LT(executor_.unshared_bytes() + pixels * 15, lit);
    }
}

} // namespace
} // namespace preview
