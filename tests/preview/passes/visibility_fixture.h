// What the tests of the compute rasteriser share: its surfaces and the GPU's own of a scene.
#pragma once

#include "preview/passes/gbuffer.h"
#include "preview/passes/visibility.h"
#include "preview/scene/gpu_scene.h"
#include "tests/preview/graph/gpu_test.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace preview {

inline constexpr Size size{96, 64};
inline constexpr float aspect = 1.5F;

/// As it is; all by workgroups; and a list that is too short, so that invocations do the rest.
inline constexpr VisibilityLimits ways[] = {{}, {0, 1U << 16U, 64}, {8, 3, 64}};

struct Surfaces {
    std::vector<float> depth;
    std::vector<std::array<std::uint16_t, 2>> normal;
    std::vector<std::uint32_t> material;
};

inline glm::vec3 decoded(std::array<std::uint16_t, 2> bits) {
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
inline Scene scene_of(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices) {
    Scene scene;
    scene.meshes.emplace_back();
    for (const glm::vec3& position : positions) {
        scene.meshes[0].vertices.push_back({position, {0, 0, 1}});
    }
    scene.meshes[0].indices = std::move(indices);
    scene.materials.emplace_back();
    scene.objects.emplace_back();
    return scene;
}

inline std::vector<Draw> all_draws(const Scene& scene, const Geometry& geometry) {
    std::vector<std::uint32_t> objects;
    for (std::uint32_t index = 0; index < scene.objects.size(); ++index) {
        objects.push_back(index);
    }
    return draws_of(scene, geometry, objects);
}

class VisibilityTest : public GpuTest {
  protected:
    void SetUp() override {
        if (!device().has_int64_atomics()) {
            GTEST_SKIP() << device().name() << " has no 64-bit atomics on buffers";
        }
        GpuTest::SetUp();
    }

    /// What `add` (a function of graph, scene and target size) makes of the scene.
    template <class Add>
    Surfaces render(const Scene& scene, const GpuScene& gpu_scene, const ViewBlock& view,
                    Size target, const Add& add) {
        Graph graph;
        const SceneHandles handles = import_scene(graph, scene, gpu_scene, view);
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
            for (std::size_t at = 0; at < counts.size(); ++at) {
                counts[at] += one.material[at] != 0 ? 1 : 0;
            }
        }
        return counts;
    }

  private:
    Executor executor_{device()};
};

} // namespace preview
