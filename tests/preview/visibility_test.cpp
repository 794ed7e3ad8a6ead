// The compute rasteriser: which pixels a triangle covers, what they show, and that it agrees with
// the GPU's own.
#include "preview/gpu_scene.h"
#include "preview/headless.h"
#include "preview/passes/visibility.h"
#include "tests/preview/gpu_test.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace preview {
namespace {

constexpr Size size{96, 64};
constexpr float aspect = 1.5F;

/// As it is; all by workgroups; and a list that is too short, so that invocations do the rest.
constexpr VisibilityLimits ways[] = {{}, {0, 1U << 16U, 64}, {8, 3, 64}};

struct Surfaces {
    std::vector<float> depth;
    std::vector<std::array<std::uint16_t, 2>> normal;
    std::vector<std::uint32_t> material;
};

glm::vec3 decoded(std::array<std::uint16_t, 2> bits) {
    const float x = static_cast<float>(bits[0]) / 32767 - 1;
    const float y = static_cast<float>(bits[1]) / 32767 - 1;
    glm::vec3 v(x, y, 1 - std::abs(x) - std::abs(y));
    if (v.z < 0) {
        v.x = (1 - std::abs(y)) * (x < 0 ? -1.0F : 1.0F);
        v.y = (1 - std::abs(x)) * (y < 0 ? -1.0F : 1.0F);
    }
    return glm::normalize(v);
}

/// A mesh of its own, in clip space as it stands when the view is {}.
Scene scene_of(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices) {
    Scene scene;
    scene.meshes.emplace_back();
    for (const glm::vec3& position : positions)
        scene.meshes[0].vertices.push_back({position, {0, 0, 1}});
    scene.meshes[0].indices = std::move(indices);
    scene.materials.emplace_back();
    scene.objects.emplace_back();
    return scene;
}

std::vector<Draw> all_draws(const Scene& scene, const Geometry& geometry) {
    std::vector<std::uint32_t> objects;
    for (std::uint32_t index = 0; index < scene.objects.size(); ++index)
        objects.push_back(index);
    return draws_of(scene, geometry, objects);
}

class VisibilityTest : public GpuTest {
  protected:
    void SetUp() override {
        if (!device().has_int64_atomics())
            GTEST_SKIP() << device().name() << " has no 64-bit atomics on buffers";
        GpuTest::SetUp();
    }

    /// What `add` (a function of graph, scene and target size) makes of the scene.
    template <class Add>
    Surfaces render(const Scene& scene, const GpuScene& gpu_scene, const ViewBlock& view,
                    Size target, const Add& add) {
        Graph graph;
        SceneHandles handles;
        handles.vertices = graph.import("vertices", gpu_scene.vertices, gpu_scene.vertices.bytes());
        handles.indices = graph.import("indices", gpu_scene.indices, gpu_scene.indices.bytes());
        const auto objects = object_blocks(scene);
        handles.objects = graph.data("objects", std::as_bytes(std::span(objects)));
        handles.view = graph.data_of("view", view);
        const GBuffer out = add(graph, handles, target);
        graph.present(out.depth);
        graph.present(out.normal);
        graph.present(out.material);
        executor_.render(graph);
        return {as<float>(executor_.read_image(out.depth)),
                as<std::array<std::uint16_t, 2>>(executor_.read_image(out.normal)),
                as<std::uint32_t>(executor_.read_image(out.material))};
    }
    Surfaces compute(const Scene& scene, const ViewBlock& view, const VisibilityLimits& limits = {},
                     Size target = size) {
        const GpuScene gpu_scene(device(), scene);
        const auto draws = all_draws(scene, gpu_scene.geometry);
        return render(scene, gpu_scene, view, target,
                      [&](Graph& graph, const auto& handles, Size s) {
                          return add_visibility(graph, handles, s, draws, limits);
                      });
    }
    Surfaces hardware(const Scene& scene, const ViewBlock& view, Size target = size) {
        const GpuScene gpu_scene(device(), scene);
        const auto draws = all_draws(scene, gpu_scene.geometry);
        return render(scene, gpu_scene, view, target,
                      [&](Graph& graph, const auto& handles, Size s) {
                          return add_gbuffer(graph, handles, s, draws);
                      });
    }
    /// How many of the scene's triangles, drawn one by one, cover each pixel.
    std::vector<int> coverage(const Scene& scene, const VisibilityLimits& limits) {
        const GpuScene gpu_scene(device(), scene);
        std::vector<int> counts(std::size_t{size.width} * size.height, 0);
        for (std::uint32_t first = 0; first < gpu_scene.geometry.indices.size(); first += 3) {
            const Surfaces one =
                render(scene, gpu_scene, {}, size, [&](Graph& graph, const auto& handles, Size s) {
                    return add_visibility(graph, handles, s, {{3, first, 0, 1, 0}}, limits);
                });
            for (std::size_t at = 0; at < counts.size(); ++at)
                counts[at] += one.material[at] != 0 ? 1 : 0;
        }
        return counts;
    }

  private:
    Executor executor_{device()};
};

/// A grid of columns x rows squares that reaches beyond the picture, its inner points moved by
/// move(column, row), in pixels; every second diagonal is turned.
template <class Move>
Scene tessellated(int columns, int rows, const Move& move) {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const glm::vec2 pixel = move(column, row);
            positions.emplace_back(pixel.x * 2 / size.width - 1, pixel.y * 2 / size.height - 1,
                                   0.5F);
        }
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const auto a = static_cast<std::uint32_t>(row * (columns + 1) + column);
            const auto b = a + 1;
            const auto c = a + static_cast<std::uint32_t>(columns) + 1;
            const auto d = c + 1;
            if ((row + column) % 2 == 0)
                indices.insert(indices.end(), {a, c, d, a, d, b});
            else
                indices.insert(indices.end(), {a, c, b, b, c, d});
        }
    return scene_of(positions, indices);
}

TEST_F(VisibilityTest, a_tessellated_plane_covers_every_pixel_exactly_once) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> jitter(-4, 4);
    const Scene scene = tessellated(8, 6, [&](int column, int row) {
        return glm::vec2(-16 + 16 * column, -16 + 16 * row) +
               glm::vec2(jitter(random), jitter(random));
    });
    for (const VisibilityLimits& limits : ways)
        for (const int count : coverage(scene, limits))
            ASSERT_EQ(count, 1);
}

TEST_F(VisibilityTest, edges_and_corners_on_pixel_centres_belong_to_one_triangle) {
    const Scene scene = tessellated(8, 6, [](int column, int row) {
        return glm::vec2(-15.5F + 16 * static_cast<float>(column),
                         -15.5F + 16 * static_cast<float>(row));
    });
    for (const VisibilityLimits& limits : ways)
        for (const int count : coverage(scene, limits))
            ASSERT_EQ(count, 1);
}

TEST_F(VisibilityTest, triangles_smaller_than_a_pixel_leave_no_hole) {
    const Scene scene = tessellated(160, 110, [](int column, int row) {
        return glm::vec2(0.61F * static_cast<float>(column) - 1.03F,
                         0.6F * static_cast<float>(row) - 1.01F);
    });
    for (const VisibilityLimits& limits : ways) {
        const Surfaces found = compute(scene, {}, limits);
        for (std::size_t at = 0; at < found.material.size(); ++at) {
            ASSERT_EQ(found.material[at], 1U) << at;
            ASSERT_EQ(found.depth[at], 0.5F) << at;
        }
    }
}

TEST_F(VisibilityTest, a_closed_mesh_has_no_hole_and_ends_at_its_silhouette) {
    Scene scene;
    scene.meshes.push_back(sphere(24, 48));
    scene.materials.emplace_back();
    scene.objects.emplace_back();
    scene.orbit = {{0, 0, 0}, 3, 20, 30, 45, 0.1F};
    const ViewBlock view = view_block(scene.orbit, aspect);
    const glm::vec3 eye(view.position_near);
    for (const VisibilityLimits& limits : ways) {
        const Surfaces found = compute(scene, view, limits);
        for (std::uint32_t y = 0; y < size.height; ++y)
            for (std::uint32_t x = 0; x < size.width; ++x) {
                const float sx = (static_cast<float>(x) + 0.5F) / size.width * 2 - 1;
                const float sy = (static_cast<float>(y) + 0.5F) / size.height * 2 - 1;
                const glm::vec3 ray = glm::normalize(
                    glm::vec3(view.forward) + sx * glm::vec3(view.right) + sy * glm::vec3(view.up));
                const float miss = glm::length(glm::cross(ray, eye));
                const std::size_t at = std::size_t{y} * size.width + x;
                // The facets lie between 0.99 and 1, and vertices move by 1/512 pixel at most.
                if (miss < 0.985F) {
                    ASSERT_EQ(found.material[at], 1U) << x << "," << y;
                    const float along = -glm::dot(ray, eye) - std::sqrt(1 - miss * miss);
                    const glm::vec3 point = eye + along * ray;
                    ASSERT_LT(glm::length(decoded(found.normal[at]) - point), 0.1F);
                } else if (miss > 1.001F) {
                    ASSERT_EQ(found.material[at], 0U) << x << "," << y;
                    ASSERT_EQ(found.depth[at], 1.0F);
                }
            }
    }
}

TEST_F(VisibilityTest, a_floor_that_runs_through_the_camera_and_far_away_has_its_true_depth) {
    // Two triangles that cross the near plane, and whose corners lie far outside the grid of
    // sub-pixels.
    for (const float half_side : {10.0F, 400.0F, 20000.0F})
        for (const float azimuth : {0.0F, 33.0F, 45.0F}) {
            Scene scene;
            scene.meshes.push_back(plane());
            scene.materials.emplace_back();
            scene.objects.emplace_back();
            scene.objects[0].transform = glm::scale(glm::mat4(1), glm::vec3(half_side));
            scene.orbit = {{0, 0, 0}, 4, azimuth, 12, 60, 0.1F};
            const ViewBlock view = view_block(scene.orbit, aspect);
            const glm::vec3 eye(view.position_near);
            int covered = 0;
            for (const VisibilityLimits& limits : ways) {
                const Surfaces found = compute(scene, view, limits);
                for (std::uint32_t y = 0; y < size.height; ++y)
                    for (std::uint32_t x = 0; x < size.width; ++x) {
                        const float sx = (static_cast<float>(x) + 0.5F) / size.width * 2 - 1;
                        const float sy = (static_cast<float>(y) + 0.5F) / size.height * 2 - 1;
                        const glm::vec3 ray = glm::vec3(view.forward) + sx * glm::vec3(view.right) +
                                              sy * glm::vec3(view.up);
                        const std::size_t at = std::size_t{y} * size.width + x;
                        const float z = -eye.y / ray.y; // view depth
                        const glm::vec3 point = eye + z * ray;
                        const float reach =
                            std::max(std::abs(point.x), std::abs(point.z)) / half_side;
                        if (ray.y > 0 || reach > 1.1F) {
                            ASSERT_EQ(found.material[at], 0U) << x << "," << y;
                        } else if (ray.y < 0 && reach < 0.9F) {
                            ++covered;
                            ASSERT_EQ(found.material[at], 1U) << x << "," << y;
                            // Depth grows by 0.0026 a row, and corners snap by up to 1/362
                            // pixel; clipping at 0.1 m leaves an error of the last bits of the
                            // corners' distance.
                            const float bound = 8e-6F + 1.5e-6F * half_side * 0.1F / z;
                            ASSERT_NEAR(found.depth[at], 1 - 0.1F / z, bound) << x << "," << y;
                        }
                    }
            }
            EXPECT_GT(covered, 3 * 1000);
        }
}

TEST_F(VisibilityTest, a_triangle_far_larger_than_the_picture_fills_it_with_its_plane) {
    // z = 1/2 + x/4 leaves the near plane at x = -2, outside the picture.
    const auto corner = [](float x, float y) { return glm::vec3(x, y, 0.5F + 0.25F * x); };
    for (const float reach : {3.0F, 100.0F, 5000.0F, 1e6F}) {
        const Scene scene =
            scene_of({corner(-reach, -reach), corner(-reach, 3 * reach), corner(3 * reach, -reach)},
                     {0, 1, 2});
        for (const VisibilityLimits& limits : ways) {
            const Surfaces found = compute(scene, {}, limits);
            for (std::size_t at = 0; at < found.depth.size(); ++at) {
                ASSERT_EQ(found.material[at], 1U) << reach << " " << at;
                const float x = (static_cast<float>(at % size.width) + 0.5F) / size.width * 2 - 1;
                // Clipped at 1e6 in floats, whose steps there are 1/16 of the picture's half width.
                const float bound = reach > 1e5F ? 0.02F : 1e-4F;
                ASSERT_NEAR(found.depth[at], 0.5F + 0.25F * x, bound) << reach << " " << at;
            }
        }
    }
}

TEST_F(VisibilityTest, what_lies_before_the_near_plane_is_cut_off) {
    // z = x/4 over the whole picture, with corners near enough that nothing else clips it.
    const Scene scene = scene_of({{-3, -3, -0.75F}, {-3, 9, -0.75F}, {9, -3, 2.25F}}, {0, 1, 2});
    for (const VisibilityLimits& limits : ways) {
        const Surfaces found = compute(scene, {}, limits);
        for (std::size_t at = 0; at < found.depth.size(); ++at) {
            const float x = (static_cast<float>(at % size.width) + 0.5F) / size.width * 2 - 1;
            ASSERT_EQ(found.material[at], x > 0 ? 1U : 0U) << at;
            ASSERT_NEAR(found.depth[at], x > 0 ? 0.25F * x : 1, 1e-5F) << at;
        }
    }
}

TEST_F(VisibilityTest, what_has_no_front_in_the_picture_draws_nothing) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    using Corners = std::vector<glm::vec3>;
    const Corners cases[] = {
        {{0, 0, 0.5F}, {0, 0, 0.5F}, {0, 0, 0.5F}},        // a point
        {{-1, -1, 0.5F}, {1, 1, 0.5F}, {1, 1, 0.5F}},      // two equal corners
        {{-1, -1, 0.5F}, {0, 0, 0.5F}, {1, 1, 0.5F}},      // on one line
        {{-1, -1, 0.5F}, {1, -1, 0.5F}, {-1, 1, 0.5F}},    // from behind
        {{-1, -1, -0.5F}, {-1, 1, -0.5F}, {1, -1, -0.1F}}, // in front of the near plane
        {{2, -1, 0.5F}, {2, 1, 0.5F}, {4, -1, 0.5F}},      // beside the picture
        {{0.001F, 0, 0.5F}, {0.001F, 0.002F, 0.5F}, {0.003F, 0, 0.5F}}, // between centres
        {{nan, -1, 0.5F}, {-1, 1, 0.5F}, {1, -1, 0.5F}},
        {{-1, -1, nan}, {-1, 1, 0.5F}, {1, -1, 0.5F}},
        {{-inf, -1, 0.5F}, {-1, 1, 0.5F}, {1, -1, 0.5F}},
        {{-1, -1, 0.5F}, {-1, inf, 0.5F}, {1, -1, 0.5F}},
    };
    for (std::size_t index = 0; index < std::size(cases); ++index)
        for (const VisibilityLimits& limits : ways) {
            const Surfaces found = compute(scene_of(cases[index], {0, 1, 2}), {}, limits);
            EXPECT_EQ(std::count(found.material.begin(), found.material.end(), 0U),
                      static_cast<long>(found.material.size()))
                << "case " << index;
            EXPECT_EQ(std::count(found.depth.begin(), found.depth.end(), 1.0F),
                      static_cast<long>(found.depth.size()));
        }
}

TEST_F(VisibilityTest, the_nearest_wins_and_of_equals_the_last) {
    std::vector<glm::vec3> corners;
    for (const float z : {0.5F, 0.25F, 0.25F, 0.75F})
        for (const glm::vec2 at : {glm::vec2(-1, -1), glm::vec2(-1, 3), glm::vec2(3, -1)})
            corners.emplace_back(at, z);
    Scene scene = scene_of(corners, {});
    scene.objects.clear();
    scene.meshes.assign(4, Mesh{});
    for (std::uint32_t index = 0; index < 4; ++index) {
        for (std::size_t corner = 0; corner < 3; ++corner)
            scene.meshes[index].vertices.push_back({corners[index * 3 + corner], {0, 0, 1}});
        scene.meshes[index].indices = {0, 1, 2};
        scene.materials.emplace_back();
        scene.objects.push_back({index, index, glm::mat4(1), true});
    }
    for (const VisibilityLimits& limits : ways)
        for (const std::uint32_t number : compute(scene, {}, limits).material)
            ASSERT_EQ(number, 3U);
    for (const std::uint32_t number : hardware(scene, {}).material)
        ASSERT_EQ(number, 3U);
}

TEST_F(VisibilityTest, every_scene_has_the_surfaces_that_the_gpus_rasteriser_finds) {
    constexpr Size large{320, 180};
    for (const SceneInfo& info : scenes()) {
        const Scene scene = scene_at(info, 1);
        const ViewBlock view = view_block(scene.orbit, 16.0F / 9);
        const Surfaces expected = hardware(scene, view, large);
        for (const VisibilityLimits& limits : ways) {
            const Surfaces found = compute(scene, view, limits, large);
            std::size_t elsewhere = 0;
            for (std::size_t at = 0; at < expected.material.size(); ++at) {
                const bool same_surface =
                    found.material[at] == expected.material[at] &&
                    (found.material[at] == 0 ||
                     (std::abs(found.depth[at] - expected.depth[at]) < 2e-5F &&
                      glm::length(decoded(found.normal[at]) - decoded(expected.normal[at])) <
                          0.002F));
                elsewhere += same_surface ? 0 : 1;
            }
            // Snapping moves an edge across a centre at few pixels, and facets change there.
            EXPECT_LT(static_cast<double>(elsewhere) / static_cast<double>(expected.depth.size()),
                      0.002)
                << info.name << ": " << elsewhere << " pixels";
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
        settings.without.set(Effect::fxaa, true);
        Executor executor(device());
        const auto expected = render_frame(executor, inputs, settings).rgba;
        settings.raster = Raster::compute;
        const auto found = render_frame(executor, inputs, settings).rgba;
        std::size_t differing = 0;
        for (std::size_t at = 0; at < expected.size(); at += 4) {
            int most = 0;
            for (std::size_t c = 0; c < 3; ++c)
                most = std::max(most, std::abs(int{found[at + c]} - int{expected[at + c]}));
            differing += most > 2 ? 1 : 0;
        }
        EXPECT_LT(static_cast<double>(differing) / static_cast<double>(expected.size() / 4), 0.005)
            << info.name << ": " << differing << " pixels";
    }
}

TEST_F(VisibilityTest, a_steady_frame_allocates_and_uploads_nothing) {
    const Scene scene = scene_at(*scene_named("sample"), 0);
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
