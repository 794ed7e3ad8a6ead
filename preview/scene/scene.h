// What there is to see, as plain data: meshes, materials, objects, lights, surroundings, a camera.
// No Vulkan; nothing here owns or knows a GPU object.
//
// Colours are linear with sRGB primaries, radiance in units in which 1 is diffuse white at
// exposure 0. A light of intensity I (radiance units times m^2) gives a surface at distance d, seen
// under the angle t, the irradiance I cos(t) / d^2; a Lambert surface answers with albedo / pi.
#pragma once

#include "preview/scene/camera.h"
#include "preview/scene/environment.h"
#include "preview/scene/mesh.h"
#include "preview/scene/surroundings.h"
#include "preview/scene/texture.h"

#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

namespace preview {

struct Material {
    glm::vec3 albedo{0.5F}; ///< 0..1; a metal's reflectance at normal incidence
    float roughness = 0.5F; ///< perceptual, 0..1; alpha = roughness^2
    float metalness = 0;    ///< 0..1
    glm::vec3 emission{0};  ///< radiance, >= 0
    MaterialDetail detail{};
};

struct Object {
    std::uint32_t mesh = 0, material = 0;
    glm::mat4 transform{1}; ///< may scale unevenly
    bool casts_shadow = true;
};

/// A light that shines in all directions, a spot, or a sun. Its shadow, if it casts one, falls
/// inside the cone-like frustum from `position` towards `aim`, and outside of it the light is
/// unshadowed; or it falls all round.
struct PointLight {
    enum class Shape : std::uint8_t { point, rod, ring };
    static constexpr float all_round = 360; ///< a shadow_angle
    glm::vec3 position{0};
    glm::vec3 intensity{0};
    bool casts_shadow = false;
    glm::vec3 aim{0};
    float shadow_angle = 60; ///< full angle of the square shadow frustum, 1..170 degrees, or more
    float shadow_near = 0.1F, shadow_far = 20;
    std::string name; ///< for people
    bool is_on = true;
    /// A spot shines along `axis`, fully up to the half angle `inner_angle`, not at all from
    /// `outer_angle` on, in degrees. 180: it is no spot.
    glm::vec3 axis{0, -1, 0};
    float inner_angle = 0, outer_angle = 180;
    bool is_spot() const { return outer_angle < 180; }
    /// A sun's rays are parallel, from `position` towards `aim`, and `intensity` is its irradiance
    /// at normal incidence.
    bool is_sun = false;
    glm::vec3 towards_sun() const; ///< unit; up where position and aim are the same
    /// What shines with all of `intensity`: a point or ball, a rod from position - extent to
    /// position + extent, or a ring about position and across `extent`, which is as long as its
    /// radius.
    Shape shape = Shape::point;
    glm::vec3 extent{0};
    float thickness = 0; ///< radius of the ball, the rod or the ring's tube
    /// A rod or ring that is too small to be told from a point is one.
    Shape lit_shape() const { return glm::dot(extent, extent) > 1e-10F ? shape : Shape::point; }
    bool is_point() const { return is_sun || (lit_shape() == Shape::point && thickness == 0); }
    bool shadows_all_round() const { return shadow_angle > 170; }
    /// Metres from its middle at which it has faded to nothing, as KHR_lights_punctual's `range`
    /// has it: the light times 1 - (d / reach)^4. 0: it reaches everywhere. Not of a sun.
    float reach = 0;
    bool ends() const { return reach > 0 && !is_sun; }
    friend bool operator==(const PointLight&, const PointLight&) = default;
};

struct NamedCamera {
    std::string name;
    Orbit orbit;
};

struct Scene {
    std::vector<Mesh> meshes;
    std::vector<Material> materials;
    std::vector<Object> objects;
    std::vector<PointLight> lights;
    Environment environment;
    Surroundings surroundings; ///< in place of the environment, where they are of another kind
    Orbit orbit;
    std::vector<NamedCamera> cameras; ///< of the file that it comes from
    float exposure = 0;               ///< stops, added to the command line's
    float occlusion = 0;              ///< strength of the ambient occlusion that it asks for, 0..1
    std::uint32_t shadow_size =
        1024; ///< texels of a shadow map's side, unless others are asked for
    std::optional<std::uint32_t> floor; ///< the object that was put under what has none
    std::vector<Picture> pictures;
    std::vector<Texture> textures; ///< of the pictures

    /// Whether a surface differs from its material's numbers: by textures, colours of vertices,
    /// cut-outs, or because no light changes it.
    bool has_detail() const;
    bool has_casting_light() const;
    bool has_emitter() const;
    /// Whether its surfaces give light off whatever shines on them, the unlit ones included.
    bool has_own_light() const;
    /// Whether light changes any object but `without`.
    bool takes_light(std::optional<std::uint32_t> without = {}) const;
    Bounds bounds() const; ///< of every object, in world space
};

/// One built-in scene. `make` gives it as it stands at time 0; `animate` moves it to `seconds`: it
/// changes transforms, lights and emission only (never a mesh, never a count), depends on nothing
/// but its arguments, and is null where nothing moves.
struct SceneInfo {
    std::string_view name;
    std::string_view help;
    Scene (*make)();
    void (*animate)(Scene& scene, double seconds) = nullptr;
    /// Rows of the tone maps and blooms that it is made for; empty: the program's defaults.
    std::string_view tonemap = {}, bloom = {};
    bool is_antialiased = true; ///< unless it is asked for otherwise
};

std::span<const SceneInfo> scenes();
const SceneInfo* scene_named(std::string_view name);

/// The scene as it stands at `seconds`.
Scene scene_at(const SceneInfo& info, double seconds);

} // namespace preview
