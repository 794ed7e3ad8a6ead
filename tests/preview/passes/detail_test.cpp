// Textures, colours of vertices, cut-outs and unlit materials in both rasterisers, against the twin
// in double; mirrored objects and spots.
#include "preview/passes/gbuffer.h"
#include "preview/passes/lighting.h"
#include "preview/passes/shadow.h"
#include "preview/passes/visibility.h"
#include "preview/reference/surface.h"
#include "preview/scene/gpu_scene.h"
#include "preview/scene/texture_data.h"
#include "tests/preview/graph/gpu_test.h"
#include "tests/preview/passes/visibility_fixture.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/packing.hpp>

#include <random>

namespace preview {
namespace {

Picture noise(std::uint32_t width, std::uint32_t height) {
    std::mt19937 random(width * 131 + height);
    Picture out{"noise", width, height, {}};
    for (std::size_t i = 0; i < std::size_t{width} * height * 4; ++i) {
        out.rgba.push_back(static_cast<std::uint8_t>(random() >> 8U));
    }
    return out;
}

/// A square of 2 x 2 units in the plane z = 0 that looks at the camera and is turned away a little,
/// with everything that a material can have.
Scene detailed_scene() {
    Scene scene;
    Mesh mesh;
    const glm::vec2 corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const glm::vec4 colors[] = {{1, 1, 1, 1}, {1, .5F, 1, 1}, {.25F, 1, 1, 1}, {1, 1, .5F, 1}};
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::vec2& at = corners[i];
        mesh.vertices.push_back({{at, 0}, {0, 0, 1}});
        VertexDetail detail;
        detail.uv[0] = {(at.x + 1) / 2, (1 - at.y) / 2};
        detail.uv[1] = {at.x * 3 - .2F, at.y * 2};
        detail.color = colors[i];
        detail.tangent = {1, 0, 0, 1};
        mesh.details.push_back(detail);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back(mesh);
    Object square;
    square.transform = glm::rotate(glm::mat4(1), 0.5F, glm::vec3(0, 1, 0));
    scene.objects.push_back(square);
    scene.pictures = {noise(8, 8), noise(13, 5)};
    Material material;
    material.albedo = {.9F, .8F, .7F};
    material.roughness = .75F;
    material.metalness = .5F;
    material.emission = {2, 1, .5F};
    scene.materials.push_back(material);
    scene.orbit.elevation = 0;
    scene.orbit.distance = 3;
    return scene;
}

/// Where the pixel's ray meets the square, as texture coordinates of its first set; outside 0..1
/// where it does not.
glm::dvec2 place_on(const Scene& scene, const ViewBlock& view, double x, double y) {
    const glm::dvec2 screen(x / size.width * 2 - 1, y / size.height * 2 - 1);
    const glm::dvec3 ray = glm::dvec3(view.forward) + screen.x * glm::dvec3(view.right) +
                           screen.y * glm::dvec3(view.up);
    const glm::dmat4 back = glm::inverse(glm::dmat4(scene.objects[0].transform));
    const glm::dvec3 eye(back * glm::dvec4(glm::dvec3(view.position_near), 1));
    const glm::dvec3 along(back * glm::dvec4(ray, 0));
    const glm::dvec3 at = eye - along * (eye.z / along.z);
    return {(at.x + 1) / 2, (1 - at.y) / 2};
}

reference::SurfacePoint point_on(const Scene& scene, glm::dvec2 uv, glm::dvec2 dx, glm::dvec2 dy) {
    reference::SurfacePoint out;
    const auto second = [](glm::dvec2 first) {
        return glm::dvec2((first.x * 2 - 1) * 3 - static_cast<double>(.2F), (1 - first.y * 2) * 2);
    };
    out.uv[0] = uv;
    out.dx[0] = dx;
    out.dy[0] = dy;
    out.uv[1] = second(uv);
    out.dx[1] = second(uv + dx) - second(uv);
    out.dy[1] = second(uv + dy) - second(uv);
    // Two triangles; their diagonal runs from the first corner to the third.
    const double x = uv.x, y = 1 - uv.y;
    const auto color = [&](std::size_t i) { return glm::dvec4(scene.meshes[0].details[i].color); };
    out.color = y < x ? (1 - x) * color(0) + (x - y) * color(1) + y * color(2)
                      : (1 - y) * color(0) + x * color(2) + (y - x) * color(3);
    const glm::dmat3 turn(scene.objects[0].transform);
    out.normal = turn * glm::dvec3(0, 0, 1);
    out.tangent = glm::dvec4(turn * glm::dvec3(1, 0, 0), 1);
    return out;
}

struct Pictures {
    std::vector<glm::vec4> albedo, emission;
    std::vector<std::array<std::uint16_t, 2>> normal;
    std::vector<std::uint32_t> material;
    std::vector<float> depth;
};

class DetailTest : public GpuTest {
  protected:
    Executor executor_{device()};

    Pictures render(const Scene& scene, const ViewBlock& view, bool by_compute,
                    const VisibilityLimits& limits = {}) {
        const GpuScene gpu_scene(device(), scene);
        Graph graph;
        SceneHandles handles = import_scene(graph, scene, gpu_scene, view);
        const auto draws = all_draws(scene, gpu_scene.geometry);
        const GBuffer out = by_compute ? add_visibility(graph, handles, size, draws, limits)
                                       : add_gbuffer(graph, handles, size, draws);
        std::vector<ImageHandle> shown{out.depth, out.normal, out.material};
        if (gpu_scene.detail) {
            shown.push_back(out.albedo);
            shown.push_back(out.emission);
        }
        for (const ImageHandle image : shown) {
            graph.present(image);
        }
        executor_.render(graph);
        Pictures read;
        read.depth = as<float>(executor_.read_image(out.depth));
        read.normal = as<std::array<std::uint16_t, 2>>(executor_.read_image(out.normal));
        read.material = as<std::uint32_t>(executor_.read_image(out.material));
        if (gpu_scene.detail) {
            read.albedo = colors(out.albedo);
            read.emission = colors(out.emission);
        }
        return read;
    }

    std::vector<glm::vec4> colors(ImageHandle image) {
        std::vector<glm::vec4> out;
        for (const auto& half : as<std::array<std::uint32_t, 2>>(executor_.read_image(image))) {
            out.emplace_back(glm::unpackHalf2x16(half[0]), glm::unpackHalf2x16(half[1]));
        }
        return out;
    }

    bool has_compute() const { return device().has_int64_atomics(); }

    /// Holds every pixel inside the square to the twin.
    void compare(const Scene& scene, const char* what) {
        const ViewBlock view = view_block(scene.orbit, aspect);
        for (const bool by_compute : {false, true}) {
            if (by_compute && !has_compute()) {
                continue;
            }
            const Pictures found = render(scene, view, by_compute);
            double worst = 0;
            std::size_t compared = 0, cut = 0, differently_cut = 0;
            for (std::uint32_t y = 0; y < size.height; ++y) {
                for (std::uint32_t x = 0; x < size.width; ++x) {
                    const glm::dvec2 uv = place_on(scene, view, x + 0.5, y + 0.5);
                    if (glm::min(uv.x, uv.y) < 0.02 || glm::max(uv.x, uv.y) > 0.98) {
                        continue;
                    }
                    const std::size_t at = std::size_t{y} * size.width + x;
                    // A rasteriser takes both differences within a block of 2 x 2 pixels, the
                    // other to the right and below.
                    const double left = by_compute ? x : x / 2 * 2;
                    const double top = by_compute ? y : y / 2 * 2;
                    const glm::dvec2 dx = place_on(scene, view, left + 1.5, y + 0.5) -
                                          place_on(scene, view, left + 0.5, y + 0.5);
                    const glm::dvec2 dy = place_on(scene, view, x + 0.5, top + 1.5) -
                                          place_on(scene, view, x + 0.5, top + 0.5);
                    const reference::DetailedSurface want = reference::surface_of(
                        scene, scene.materials[0], point_on(scene, uv, dx, dy));
                    cut += want.is_cut_out ? 1 : 0;
                    if (want.is_cut_out != (found.material[at] == 0)) {
                        ++differently_cut;
                        continue;
                    }
                    if (want.is_cut_out) {
                        continue;
                    }
                    ++compared;
                    const std::uint32_t word = found.material[at];
                    const auto share = [&](unsigned shift) {
                        return static_cast<double>(word >> shift & 1023U) / 1023;
                    };
                    for (int c = 0; c < 3; ++c) {
                        worst = std::max(worst, std::abs(static_cast<double>(found.albedo[at][c]) -
                                                         want.albedo[c]));
                        worst =
                            std::max(worst, std::abs(static_cast<double>(found.emission[at][c]) -
                                                     want.emission[c]) /
                                                2);
                    }
                    if (!scene.materials[0].detail.is_unlit) {
                        worst = std::max({worst, std::abs(share(20) - want.roughness),
                                          std::abs(share(10) - want.metalness),
                                          std::abs(share(0) - want.occlusion)});
                        worst = std::max(worst, glm::length(glm::dvec3(decoded(found.normal[at])) -
                                                            want.normal));
                    }
                }
            }
            // Half floats and ten bits; steep noise magnifies the rounding of coordinates.
            EXPECT_LT(worst, 0.004) << what << (by_compute ? ", compute" : ", hardware");
            EXPECT_GT(compared + cut, 1000U) << what;
            EXPECT_GT(compared, 400U) << what;
            // Coverage at the very threshold.
            EXPECT_LE(differently_cut, compared / 200) << what;
        }
    }
};

TEST_F(DetailTest, surfaces_are_those_of_the_double_twin_under_every_sampler) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp}) {
        for (const Mips mips : {Mips::none, Mips::nearest, Mips::linear}) {
            Scene scene = detailed_scene();
            MaterialDetail& detail = scene.materials[0].detail;
            for (const std::uint32_t picture : {0U, 1U}) {
                for (const bool is_color : {true, false}) {
                    scene.textures.push_back({picture, is_color, wrap, wrap, true, true, mips});
                }
            }
            detail.base.texture = 0;
            detail.surface = {3, 1, {1, 0, 0}, {0, 1, 0}};
            detail.normal = {1, 0, {.5F, .25F, .1F}, {-.25F, .5F, .2F}};
            detail.occlusion = {1, 1, {1, 0, 0}, {0, 1, 0}};
            detail.emission = {2, 1, {-1, 0, .3F}, {0, 4, 0}};
            detail.normal_scale = .5F;
            detail.occlusion_strength = .75F;
            compare(scene, "a sampler");
        }
    }
}

TEST_F(DetailTest, small_textures_are_shown_by_nearest_texels_where_that_is_asked) {
    Scene scene = detailed_scene();
    scene.pictures[0] = {
        "2x2", 2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255}};
    scene.textures.push_back({0, true, Wrap::clamp, Wrap::clamp, false, false, Mips::none});
    scene.materials[0].detail.base.texture = 0;
    const ViewBlock view = view_block(scene.orbit, aspect);
    for (const bool by_compute : {false, true}) {
        if (by_compute && !has_compute()) {
            continue;
        }
        const Pictures found = render(scene, view, by_compute);
        const glm::dvec2 upper_left = place_on(scene, view, 36, 20);
        ASSERT_LT(glm::max(upper_left.x, upper_left.y), 0.5);
        const glm::vec4 red = found.albedo[20 * size.width + 36];
        EXPECT_GT(red.r, 0.2F);
        EXPECT_EQ(red.g, 0);
        const glm::vec4 blue = found.albedo[44 * size.width + 36];
        EXPECT_EQ(blue.r, 0);
        EXPECT_GT(blue.b, 0.2F);
    }
}

TEST_F(DetailTest, cut_outs_are_holes_in_both_rasterisers) {
    Scene scene = detailed_scene();
    scene.textures.push_back({0, true});
    MaterialDetail& detail = scene.materials[0].detail;
    detail.base.texture = 0;
    detail.least_coverage = .5F;
    compare(scene, "cut-outs");
    if (!has_compute()) {
        return;
    }
    const ViewBlock view = view_block(scene.orbit, aspect);
    const Pictures usual = render(scene, view, true);
    for (const VisibilityLimits& limits : ways) {
        EXPECT_EQ(render(scene, view, true, limits).material, usual.material);
    }
}

TEST_F(DetailTest, an_unlit_material_emits_its_albedo) {
    Scene scene = detailed_scene();
    scene.textures.push_back({0, true});
    scene.materials[0].detail.base.texture = 0;
    scene.materials[0].detail.is_unlit = true;
    compare(scene, "unlit");
}

// Drivers may cut off where a shader leaves the rounding to half floats to them.
TEST_F(DetailTest, colors_are_the_nearest_half_floats) {
    Scene scene = detailed_scene();
    for (VertexDetail& detail : scene.meshes[0].details) {
        detail.color = glm::vec4(1);
    }
    constexpr double red = 0.7, half_step = 0x1p-12; // between halves below 1
    scene.materials[0].albedo.r = scene.materials[0].emission.r = static_cast<float>(red);
    for (const bool by_compute : {false, true}) {
        if (by_compute && !has_compute()) {
            continue;
        }
        const Pictures found = render(scene, view_block(scene.orbit, aspect), by_compute);
        const std::size_t middle = std::size_t{size.height} / 2 * size.width + size.width / 2;
        EXPECT_NEAR(found.albedo[middle].r, red, half_step) << by_compute;
        EXPECT_NEAR(found.emission[middle].r, red, half_step) << by_compute;
    }
}

TEST_F(DetailTest, a_scene_without_detail_has_no_buffer_for_it) {
    Scene scene = detailed_scene();
    scene.meshes[0].details.clear();
    const GpuScene gpu_scene(device(), scene);
    EXPECT_FALSE(gpu_scene.detail);
    EXPECT_TRUE(gpu_scene.geometry.details.empty());
}

TEST_F(DetailTest, textures_beyond_the_room_lose_their_largest_levels) {
    Scene scene = detailed_scene();
    scene.textures = {{0, true}, {1, false}, {0, true, Wrap::clamp}};
    const TextureData all = texture_data(scene, 1U << 20U);
    EXPECT_EQ(all.halvings, 0U);
    EXPECT_EQ(all.table[0].first, all.table[2].first); // shared
    EXPECT_EQ(all.table[0].levels, 4U);
    const TextureData less = texture_data(scene, 800);
    EXPECT_EQ(less.halvings, 1U);
    EXPECT_EQ(less.table[0].sides, 4U | 4U << 16U);
    EXPECT_LE(less.texels.size() * 4, 800U);
}

TEST_F(DetailTest, the_outside_of_a_mirrored_object_is_its_front) {
    Scene scene;
    scene.meshes.push_back(sphere(16, 32));
    scene.materials.emplace_back();
    scene.objects.emplace_back();
    scene.orbit.distance = 3;
    const ViewBlock view = view_block(scene.orbit, aspect);
    for (const bool by_compute : {false, true}) {
        if (by_compute && !has_compute()) {
            continue;
        }
        scene.objects[0].transform = glm::mat4(1);
        const Pictures plain = render(scene, view, by_compute);
        scene.objects[0].transform = glm::scale(glm::mat4(1), glm::vec3(-1, 1, 1));
        const Pictures mirrored = render(scene, view, by_compute);
        std::size_t elsewhere = 0;
        for (std::size_t at = 0; at < plain.depth.size(); ++at) {
            // The ball is its own mirror image.
            elsewhere += std::abs(plain.depth[at] - mirrored.depth[at]) > 1e-4F ? 1 : 0;
        }
        EXPECT_LT(elsewhere, 30U);
        const std::size_t middle = std::size_t{size.height / 2} * size.width + size.width / 2;
        EXPECT_LT(mirrored.depth[middle], 1);
        EXPECT_LT(glm::length(decoded(mirrored.normal[middle]) - decoded(plain.normal[middle])),
                  0.1F);
    }
}

} // namespace
} // namespace preview
