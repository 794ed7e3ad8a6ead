// The built-in scenes and what they are made of, without a GPU.
#include "preview/scene/builtin.h"
#include "preview/scene/floor.h"
#include "preview/scene/pictures.h"
#include "preview/scene/shapes.h"
#include "preview/scene/swatches.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>
#include <set>

namespace preview {
namespace {

/// A vase with corners at its foot and rim, up the outside and down the inside.
constexpr glm::vec2 vase[]{{0, 0},        {0.5F, 0},     {0.5F, 0},     {0.9F, 0.6F},
                           {0.4F, 1.5F},  {0.45F, 1.6F}, {0.45F, 1.6F}, {0.35F, 1.6F},
                           {0.35F, 1.6F}, {0.7F, 0.6F},  {0, 0.1F}};

/// A sheet that hangs from a rail.
Mesh sheet() {
    return surface(12, 8, [](glm::vec2 at) {
        return glm::vec3{at.x, 0.1F * std::sin(9 * at.x), at.y};
    });
}

std::vector<Mesh> every_generator() {
    std::vector<Mesh> meshes{sphere(16, 24),
                             torus(0.3F, 32, 12),
                             torus_knot(2, 3, 0.42F, 0.2F, 128, 16),
                             box({1, 2, 0.5F}, 0.1F),
                             box({1, 2, 0.5F}, 0),
                             cylinder(24),
                             plane(),
                             lathe(smoothed(vase, 6), 24),
                             two_sided(sheet())};
    return meshes;
}

TEST(Mesh, faces_wind_counter_clockwise_about_their_outward_normals) {
    for (const Mesh& mesh : every_generator()) {
        ASSERT_EQ(mesh.indices.size() % 3, 0u) << mesh.name;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const Vertex& a = mesh.vertices.at(mesh.indices[i]);
            const Vertex& b = mesh.vertices.at(mesh.indices[i + 1]);
            const Vertex& c = mesh.vertices.at(mesh.indices[i + 2]);
            const glm::vec3 face = glm::cross(b.position - a.position, c.position - a.position);
            // The triangles at a pole have no area.
            if (glm::length(face) > 1e-7F) {
                ASSERT_GT(glm::dot(face, a.normal + b.normal + c.normal), 0) << mesh.name;
            }
        }
        for (const Vertex& vertex : mesh.vertices) {
            ASSERT_NEAR(glm::length(vertex.normal), 1, 1e-5) << mesh.name;
        }
    }
}

TEST(Mesh, pictures_on_shapes_are_upright_and_not_mirrored) {
    for (const Mesh& mesh : {lathe(smoothed(vase, 6), 24), sheet()}) {
        ASSERT_EQ(mesh.details.size(), mesh.vertices.size()) << mesh.name;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const std::uint32_t* const corner = &mesh.indices[i];
            const auto edge = [&](std::size_t k) {
                return mesh.vertices[corner[k]].position - mesh.vertices[corner[0]].position;
            };
            const auto turn = [&](std::size_t k) {
                return mesh.details[corner[k]].uv[0] - mesh.details[corner[0]].uv[0];
            };
            // Seen from the front, u grows to the right and v downwards: clockwise turns are
            // positive.
            const float area = turn(1).x * turn(2).y - turn(1).y * turn(2).x;
            if (glm::length(glm::cross(edge(1), edge(2))) > 1e-7F) {
                ASSERT_LT(area, 0) << mesh.name;
                const glm::vec3 along = edge(1) * turn(2).y - edge(2) * turn(1).y;
                EXPECT_LT(glm::dot(along, glm::vec3{mesh.details[corner[0]].tangent}), 0)
                    << mesh.name;
            }
        }
    }
}

// By the divergence theorem a closed mesh encloses the sum of its triangles' signed volumes.
double enclosed_volume(const Mesh& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) {
            return mesh.vertices[mesh.indices[i + k]].position;
        };
        sum += static_cast<double>(glm::dot(corner(0), glm::cross(corner(1), corner(2)))) / 6;
    }
    return sum;
}

TEST(Mesh, closed_shapes_enclose_their_volume) {
    constexpr double pi = 3.14159265358979;
    // Inscribed facets lose a little: the tolerance is the loss at these tessellations.
    EXPECT_NEAR(enclosed_volume(sphere(64, 128)), 4 * pi / 3, 0.01);
    EXPECT_NEAR(enclosed_volume(torus(0.3F, 128, 64)), 2 * pi * pi * 0.09, 0.01);
    EXPECT_NEAR(enclosed_volume(cylinder(256)), 2 * pi, 0.01);
    EXPECT_NEAR(enclosed_volume(box({1, 2, 0.5F}, 0)), 8, 1e-5);
    constexpr glm::vec2 cone[]{{0, 0}, {1, 0}, {1, 0}, {0, 3}};
    EXPECT_NEAR(enclosed_volume(lathe(cone, 256)), pi, 0.01);
    const double rounded = enclosed_volume(box({1, 2, 0.5F}, 0.1F, 16));
    EXPECT_LT(rounded, 8);
    EXPECT_GT(rounded, 7.8);
}

TEST(Camera, puts_the_target_in_the_middle_and_up_on_top) {
    const Orbit orbit{{1, 2, 3}, 4, 30, 20, 40, 0.1F};
    const Camera camera = camera_of(orbit, 2);
    const auto project = [&](glm::vec3 p) {
        const glm::vec4 clip = camera.projection * camera.view * glm::vec4{p, 1};
        return glm::vec3{clip} / clip.w;
    };
    const glm::vec3 centre = project(orbit.target);
    EXPECT_NEAR(centre.x, 0, 1e-5);
    EXPECT_NEAR(centre.y, 0, 1e-5);
    EXPECT_NEAR(centre.z, 1 - orbit.near_plane / orbit.distance, 1e-5);
    EXPECT_LT(project(orbit.target + glm::vec3{0, 0.1F, 0}).y, 0);
    EXPECT_NEAR(glm::length(camera.position - orbit.target), orbit.distance, 1e-4);
}

TEST(Camera, a_pan_moves_everything_at_the_targets_distance_by_as_much) {
    Orbit orbit{{1, 2, 3}, 4, 30, 20, 40, 0.1F};
    const Camera before = camera_of(orbit, 1.5F);
    orbit.pan = {0.5F, -0.25F};
    const Camera after = camera_of(orbit, 1.5F);
    const glm::vec4 shift =
        after.view * glm::vec4(orbit.target, 1) - before.view * glm::vec4(orbit.target, 1);
    EXPECT_NEAR(shift.x, -0.5F, 1e-5);
    EXPECT_NEAR(shift.y, 0.25F, 1e-5);
    EXPECT_NEAR(shift.z, 0, 1e-5);
}

TEST(Camera, turned_on_the_spot_it_stays_where_it_is_and_looks_to_the_right_and_up) {
    Orbit orbit{{1, 2, 3}, 4, 30, 20, 40, 0.1F};
    orbit.pan = {0.5F, -0.25F};
    const Camera before = camera_of(orbit, 1.5F);
    const Camera after = camera_of(turned_on_the_spot(orbit, 10, 5), 1.5F);
    EXPECT_LT(glm::length(after.position - before.position), 1e-5F);
    // What was in the middle has gone to the left and down, clip space having y downwards.
    const glm::vec4 ahead = glm::inverse(before.view) * glm::vec4(0, 0, -4, 1);
    const glm::vec4 clip = after.projection * after.view * ahead;
    EXPECT_LT(clip.x / clip.w, -0.1F);
    EXPECT_GT(clip.y / clip.w, 0.1F);
}

TEST(Floor, is_put_under_what_has_none) {
    SceneBuilder build;
    const auto grey = build.material({});
    build.place(build.mesh(sphere(12, 24)), grey, at({0, 1, 0}));
    EXPECT_FALSE(has_floor(build.scene));
    build.place(build.mesh(plane()), grey, at({0, 0.01F, 0}, glm::vec3(2)));
    EXPECT_TRUE(has_floor(build.scene));

    SceneBuilder standing; // neither a box that is seen from inside nor a sheet has one
    standing.place(standing.mesh(two_sided(box(glm::vec3(1), 0))), standing.material({}),
                   glm::mat4(1));
    EXPECT_FALSE(has_floor(standing.scene));
    SceneBuilder sheet;
    sheet.place(sheet.mesh(plane()), sheet.material({}), turned(glm::mat4(1), 90, {1, 0, 0}));
    EXPECT_FALSE(has_floor(sheet.scene));

    Scene& scene = build.scene;
    scene.objects.pop_back();
    const Bounds before = scene.bounds();
    add_floor(scene);
    ASSERT_TRUE(scene.floor);
    const Object& floor = scene.objects[*scene.floor];
    EXPECT_FALSE(floor.casts_shadow);
    Bounds stage;
    stage.include(bounds_of(scene.meshes[floor.mesh]), floor.transform);
    EXPECT_NEAR(stage.max.y, before.min.y, 1e-5);
    EXPECT_LT(stage.min.x, before.min.x - 1);
}

TEST(Camera, survives_any_orbit) {
    for (const float wild : {0.0F, 90.0F, -90.0F, 1e6F, -1e6F}) {
        const Camera camera = camera_of({{0, 0, 0}, wild, wild, wild, wild, 0.1F}, 1);
        const glm::vec4 clip = camera.projection * camera.view * glm::vec4{0, 0, 0, 1};
        EXPECT_TRUE(std::isfinite(clip.x + clip.y + clip.z + clip.w)) << wild;
    }
}

class EveryScene : public testing::TestWithParam<const SceneInfo*> {};

TEST_P(EveryScene, refers_only_to_what_it_has_and_holds_finite_values) {
    const Scene scene = scene_at(*GetParam(), 1.5);
    ASSERT_FALSE(scene.objects.empty());
    for (const Object& object : scene.objects) {
        ASSERT_LT(object.mesh, scene.meshes.size());
        ASSERT_LT(object.material, scene.materials.size());
    }
    for (const Material& material : scene.materials) {
        for (int c = 0; c < 3; ++c) {
            EXPECT_GE(material.albedo[c], 0);
            EXPECT_LE(material.albedo[c], 1);
            EXPECT_GE(material.emission[c], 0);
            // Half floats end at 65504; what is seen must stay below after any usual exposure.
            EXPECT_LE(material.emission[c], 4096);
        }
    }
    const Bounds bounds = scene.bounds();
    EXPECT_TRUE(std::isfinite(glm::length(bounds.max - bounds.min)));
    EXPECT_LE(scene.environment.soft_box_count, Environment::max_soft_boxes);
}

TEST_P(EveryScene, moves_with_time_without_changing_its_counts_and_repeats_itself) {
    const Scene at_rest = scene_at(*GetParam(), 0);
    const Scene later = scene_at(*GetParam(), 2.25), again = scene_at(*GetParam(), 2.25);
    const Scene made = GetParam()->make();
    ASSERT_EQ(at_rest.objects.size(), later.objects.size());
    ASSERT_EQ(at_rest.lights.size(), later.lights.size());
    bool moved = false;
    for (std::size_t i = 0; i < later.objects.size(); ++i) {
        EXPECT_EQ(later.objects[i].transform, again.objects[i].transform);
        EXPECT_EQ(at_rest.objects[i].transform, made.objects[i].transform);
        moved = moved || later.objects[i].transform != at_rest.objects[i].transform;
    }
    EXPECT_EQ(moved, GetParam()->animate != nullptr);
}

INSTANTIATE_TEST_SUITE_P(Table, EveryScene, testing::ValuesIn([] {
                             std::vector<const SceneInfo*> rows;
                             for (const SceneInfo& row : scenes()) {
                                 rows.push_back(&row);
                             }
                             return rows;
                         }()),
                         [](const auto& row) { return std::string(row.param->name); });

TEST(Scenes, have_names_of_their_own) {
    std::set<std::string_view> names;
    for (const SceneInfo& info : scenes()) {
        EXPECT_TRUE(names.insert(info.name).second) << info.name;
    }
    EXPECT_EQ(scene_named("sample"), &scenes().front());
    EXPECT_EQ(scene_named("nowhere"), nullptr);
}

TEST(Scenes, sample_has_everything_and_plain_has_neither_caster_nor_emitter) {
    EXPECT_TRUE(sample_scene().has_casting_light());
    EXPECT_TRUE(sample_scene().has_emitter());
    EXPECT_TRUE(sample_scene().has_detail());
    EXPECT_TRUE(studio_scene().has_casting_light());
    EXPECT_TRUE(studio_scene().has_emitter());
    EXPECT_FALSE(studio_scene().has_detail());
    EXPECT_FALSE(plain_scene().has_casting_light());
    EXPECT_FALSE(plain_scene().has_emitter());
}

TEST(Noise, repeats_without_a_seam_and_stays_in_0_to_1) {
    for (int i = 0; i <= 40; ++i) {
        const float y = 0.1F * static_cast<float>(i);
        for (const float x : {0.0F, 0.3F, 2.7F}) {
            const float here = layered_noise({x, y}, {3, 4}, 3, 5);
            EXPECT_GE(here, 0);
            EXPECT_LE(here, 1);
            EXPECT_NEAR(layered_noise({x + 3, y}, {3, 4}, 3, 5), here, 1e-5);
            EXPECT_NEAR(layered_noise({x, y + 4}, {3, 4}, 3, 5), here, 1e-4);
        }
    }
}

TEST(Swatches, lab_of_white_and_of_middle_grey_is_as_cie_has_it) {
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(linear_of_lab({100, 0, 0})[c], 1, 1e-5);
        EXPECT_NEAR(linear_of_lab({49.4961F, 0, 0})[c], 0.18, 1e-5); // 116 cbrt(.18) - 16
    }
    // Rec.709's red under D65.
    const glm::vec3 red = linear_of_lab({53.2408F, 80.0925F, 67.2032F});
    EXPECT_NEAR(red.r, 1, 2e-3);
    EXPECT_NEAR(red.g, 0, 2e-3);
    EXPECT_NEAR(red.b, 0, 2e-3);
}

TEST(Swatches, decode_as_srgb) {
    EXPECT_EQ(linear_of(0xffffff), glm::vec3{1});
    EXPECT_EQ(linear_of(0x000000), glm::vec3{0});
    // Neutral 5 of the ColorChecker reflects 19.8 %.
    EXPECT_NEAR(linear_of(color_checker[21]).g, 0.195, 0.005);
}

// The integral of radiance(d) cos over the hemisphere, by a regular grid of directions.
glm::dvec3 integrated_irradiance(const Environment& environment, glm::vec3 normal) {
    constexpr int rows = 256, columns = 512;
    constexpr double pi = 3.14159265358979;
    glm::dvec3 sum{0};
    for (int i = 0; i < rows; ++i) {
        const double polar = pi * (i + 0.5) / rows;
        for (int j = 0; j < columns; ++j) {
            const double angle = 2 * pi * j / columns;
            const glm::dvec3 d{std::sin(polar) * std::cos(angle), std::cos(polar),
                               std::sin(polar) * std::sin(angle)};
            const double cosine = std::max(0.0, glm::dot(d, glm::dvec3{normal}));
            const double area = std::sin(polar) * (pi / rows) * (2 * pi / columns);
            sum += glm::dvec3{radiance(environment, glm::vec3{d}, 0)} * cosine * area;
        }
    }
    return sum;
}

TEST(Environment, irradiance_is_the_integral_of_radiance) {
    const glm::vec3 normals[]{{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0.6F, 0.8F, 0}, {0, -0.6F, 0.8F}};
    for (const SceneInfo& info : scenes()) {
        const Environment environment = info.make().environment;
        std::vector<glm::dvec3> exact;
        glm::dvec3 brightest{0};
        for (const glm::vec3 normal : normals) {
            exact.push_back(integrated_irradiance(environment, normal));
            brightest = glm::max(brightest, exact.back());
        }
        for (std::size_t i = 0; i < exact.size(); ++i) {
            const glm::dvec3 fast = irradiance(environment, normals[i]);
            // The gradient's shares are fits, and the Gaussian cosine does not quite reach zero for
            // light from behind: a share of the brightest light.
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(fast[c], exact[i][c], 0.1 * exact[i][c] + 0.05 * brightest[c])
                    << info.name << ' ' << i;
            }
        }
    }
}

TEST(Environment, blur_keeps_the_light_of_a_soft_box) {
    Environment environment;
    environment.soft_boxes[0] = {{0, 0, 1}, 30, {1, 1, 1}};
    environment.soft_box_count = 1;
    const auto total = [&](float roughness) {
        double sum = 0;
        constexpr int steps = 4000;
        for (int i = 0; i < steps; ++i) {
            const float z = -1 + 2 * (static_cast<float>(i) + 0.5F) / steps;
            sum += radiance(environment, {std::sqrt(1 - z * z), 0, z}, roughness).r;
        }
        return sum / steps;
    };
    // Gaussians wider than the sphere wrap: 1 - e^(-2s) of the light is left.
    EXPECT_NEAR(total(0.2F) / total(0), 1, 1e-3);
    EXPECT_NEAR(total(0.5F) / total(0), 1, 1e-3);
}

} // namespace
} // namespace preview
