// The compute rasteriser: which pixels a triangle covers, and how deep they lie.
#include "tests/preview/passes/visibility_fixture.h"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <limits>
#include <random>

namespace preview {
namespace {

/// A grid of columns x rows squares that reaches beyond the picture, its inner points moved by
/// move(column, row), in pixels; every second diagonal is turned.
template <class Move>
Scene tessellated(int columns, int rows, const Move& move) {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const glm::vec2 pixel = move(column, row);
            positions.emplace_back(pixel.x * 2 / size.width - 1, pixel.y * 2 / size.height - 1,
                                   0.5F);
        }
    }
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const auto a = static_cast<std::uint32_t>(row * (columns + 1) + column);
            const auto b = a + 1;
            const auto c = a + static_cast<std::uint32_t>(columns) + 1;
            const auto d = c + 1;
            if ((row + column) % 2 == 0) {
                indices.insert(indices.end(), {a, c, d, a, d, b});
            } else {
                indices.insert(indices.end(), {a, c, b, b, c, d});
            }
        }
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
    for (const VisibilityLimits& limits : ways) {
        for (const int count : coverage(scene, limits)) {
            ASSERT_EQ(count, 1);
        }
    }
}

TEST_F(VisibilityTest, edges_and_corners_on_pixel_centres_belong_to_one_triangle) {
    const Scene scene = tessellated(8, 6, [](int column, int row) {
        return glm::vec2(-15.5F + 16 * static_cast<float>(column),
                         -15.5F + 16 * static_cast<float>(row));
    });
    for (const VisibilityLimits& limits : ways) {
        for (const int count : coverage(scene, limits)) {
            ASSERT_EQ(count, 1);
        }
    }
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
        for (std::uint32_t y = 0; y < size.height; ++y) {
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
}

TEST_F(VisibilityTest, a_floor_that_runs_through_the_camera_and_far_away_has_its_true_depth) {
    // Two triangles that cross the near plane, and whose corners lie far outside the grid of
    // sub-pixels.
    for (const float half_side : {10.0F, 400.0F, 20000.0F}) {
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
                for (std::uint32_t y = 0; y < size.height; ++y) {
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
            }
            EXPECT_GT(covered, 3 * 1000);
        }
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
    for (std::size_t index = 0; index < std::size(cases); ++index) {
        for (const VisibilityLimits& limits : ways) {
            const Surfaces found = compute(scene_of(cases[index], {0, 1, 2}), {}, limits);
            EXPECT_EQ(std::count(found.material.begin(), found.material.end(), 0U),
                      static_cast<long>(found.material.size()))
                << "case " << index;
            EXPECT_EQ(std::count(found.depth.begin(), found.depth.end(), 1.0F),
                      static_cast<long>(found.depth.size()));
        }
    }
}

} // namespace
} // namespace preview
