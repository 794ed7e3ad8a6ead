// The compute rasteriser beside the GPU's own, and in a frame.
#include "preview/cli/headless.h"
#include "preview/frame/frame.h"
#include "preview/scene/gpu_scene.h"
#include "tests/preview/passes/visibility_fixture.h"

#include <algorithm>

namespace preview {
namespace {

TEST_F(VisibilityTest, the_nearest_wins_and_of_equals_the_last) {
    std::vector<glm::vec3> corners;
    for (const float z : {0.5F, 0.25F, 0.25F, 0.75F}) {
        for (const glm::vec2 at : {glm::vec2(-1, -1), glm::vec2(-1, 3), glm::vec2(3, -1)}) {
            corners.emplace_back(at, z);
        }
    }
    Scene scene = scene_of(corners, {});
    scene.objects.clear();
    scene.meshes.assign(4, Mesh{});
    for (std::uint32_t index = 0; index < 4; ++index) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            scene.meshes[index].vertices.push_back({corners[index * 3 + corner], {0, 0, 1}});
        }
        scene.meshes[index].indices = {0, 1, 2};
        scene.materials.emplace_back();
        scene.objects.push_back({index, index, glm::mat4(1), true});
    }
    for (const VisibilityLimits& limits : ways) {
        for (const std::uint32_t number : compute(scene, {}, limits).material) {
            ASSERT_EQ(number, 3U);
        }
    }
    for (const std::uint32_t number : hardware(scene, {}).material) {
        ASSERT_EQ(number, 3U);
    }
}

/// Words of surfaces.glsl, which a texture's filter may round the other way, or numbers.
bool is_same_material(std::uint32_t a, std::uint32_t b, bool has_detail) {
    if (a == b || !has_detail || a == 0 || b == 0) {
        return a == b;
    }
    bool is_same = a >> 30U == b >> 30U;
    for (const std::uint32_t shift : {0U, 10U, 20U}) {
        const int steps =
            static_cast<int>(a >> shift & 1023U) - static_cast<int>(b >> shift & 1023U);
        is_same = is_same && std::abs(steps) <= 2;
    }
    return is_same;
}

TEST_F(VisibilityTest, every_scene_has_the_surfaces_that_the_gpus_rasteriser_finds) {
    constexpr Size large{320, 180};
    for (const SceneInfo& info : scenes()) {
        const Scene scene = scene_at(info, 1);
        const ViewBlock view = view_block(scene.orbit, 16.0F / 9);
        const Surfaces expected = hardware(scene, view, large);
        for (const VisibilityLimits& limits : ways) {
            const Surfaces found = compute(scene, view, limits, large);
            std::size_t elsewhere = 0, turned = 0;
            for (std::size_t at = 0; at < expected.material.size(); ++at) {
                const bool same_place = is_same_material(found.material[at], expected.material[at],
                                                         scene.has_detail()) &&
                                        (found.material[at] == 0 ||
                                         std::abs(found.depth[at] - expected.depth[at]) < 2e-5F);
                const float turn =
                    same_place && found.material[at] != 0
                        ? glm::length(decoded(found.normal[at]) - decoded(expected.normal[at]))
                        : 0;
                elsewhere += !same_place || turn > 0.02F ? 1 : 0;
                turned += turn > 0.002F ? 1 : 0;
            }
            const auto share = [&](std::size_t pixels) {
                return static_cast<double>(pixels) / static_cast<double>(expected.depth.size());
            };
            // Snapping moves an edge across a centre at few pixels, and facets change there.
            EXPECT_LT(share(elsewhere), 0.002) << info.name << ": " << elsewhere << " pixels";
            // A GPU may interpolate from corners that it has moved to its grid, by 1/512 pixel;
            // normals of thin facets at a silhouette turn by that. Ours come from the corners
            // themselves.
            EXPECT_LT(share(turned), 0.01) << info.name << ": " << turned << " pixels";
        }
    }
}

TEST_F(VisibilityTest, the_finished_frame_differs_at_edges_only) {
    for (const SceneInfo& info : scenes()) {
        const Scene scene = scene_at(info, 1);
        const GpuScene gpu_scene(device(), scene);
        FrameInputs inputs;
        inputs.scene = &scene;
        inputs.gpu_scene = &gpu_scene;
        FrameSettings settings;
        settings.output = {320, 180};
        settings.orbit = scene.orbit;
        settings.tonemap = tonemap_named("agx");
        settings.shadow_size = 256;
        settings.bloom = bloom_named("none");
        Executor executor(device());
        const auto expected = render_frame(executor, inputs, settings).rgba;
        settings.raster = Raster::compute;
        const auto found = render_frame(executor, inputs, settings).rgba;
        std::size_t differing = 0;
        for (std::size_t at = 0; at < expected.size(); at += 4) {
            int most = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                most = std::max(most, std::abs(int{found[at + c]} - int{expected[at + c]}));
            }
            differing += most > 2 ? 1 : 0;
        }
        EXPECT_LT(static_cast<double>(differing) / static_cast<double>(expected.size() / 4), 0.005)
            << info.name << ": " << differing << " pixels";
    }
}

TEST_F(VisibilityTest, a_steady_frame_allocates_and_uploads_nothing) {
    const Scene scene = scene_at(*scene_named("studio"), 0);
    const GpuScene gpu_scene(device(), scene);
    FrameInputs inputs;
    inputs.scene = &scene;
    inputs.gpu_scene = &gpu_scene;
    FrameSettings settings;
    settings.output = size;
    settings.orbit = scene.orbit;
    settings.shadow_size = 64;
    settings.raster = Raster::compute;
    Executor executor(device());
    std::uint64_t allocations = 0;
    std::uint64_t uploads = 0;
    for (int frame = 0; frame < 6; ++frame) {
        if (frame == 3) {
            allocations = device().allocation_count();
            uploads = executor.uploads();
        }
        Graph graph;
        build_frame(graph, inputs, settings);
        executor.render(graph);
    }
    EXPECT_EQ(device().allocation_count(), allocations);
    EXPECT_EQ(executor.uploads(), uploads);
    EXPECT_EQ(executor.rebuilds(), 1U);
}

TEST_F(VisibilityTest, the_automatic_choice_is_one_that_the_device_can_do) {
    ASSERT_EQ(rasters().front().name, "auto");
    const Raster chosen = rasters().front().on(device(), size);
    const bool discrete =
        device().physical().getProperties().deviceType == vk::PhysicalDeviceType::eDiscreteGpu;
    EXPECT_EQ(chosen, discrete ? Raster::compute : Raster::hardware);
    // A picture whose keys no storage buffer holds is left to the hardware.
    const std::uint32_t too_large =
        static_cast<std::uint32_t>(device().limits().maxStorageBufferRange / 8 / 8 + 8);
    EXPECT_EQ(rasters().front().on(device(), {too_large, 8}), Raster::hardware);
}

TEST(ClusterTest, draws_are_cut_into_runs_of_at_most_64_triangles) {
    const std::vector<Draw> draws{{3 * 130, 30, 7, 1, 4}, {0, 0, 0, 1, 5}, {3, 420, 9, 1, 6}};
    const auto blocks = cluster_blocks(draws);
    ASSERT_EQ(blocks.size(), 4U);
    const std::uint32_t firsts[] = {30, 30 + 192, 30 + 384, 420};
    const std::uint32_t counts[] = {64, 64, 2, 1};
    for (std::size_t index = 0; index < blocks.size(); ++index) {
        EXPECT_EQ(blocks[index].first_index, firsts[index]);
        EXPECT_EQ(blocks[index].triangle_count, counts[index]);
        EXPECT_EQ(blocks[index].object, index < 3 ? 4U : 6U);
        EXPECT_EQ(blocks[index].vertex_offset, index < 3 ? 7 : 9);
    }
}

} // namespace
} // namespace preview
