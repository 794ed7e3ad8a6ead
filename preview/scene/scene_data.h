// A scene in the form that the shaders read (shaders/common/scene.glsl): flat arrays, and for each
// view the objects that it can see. Plain data.
#pragma once

#include "preview/graph/graph.h"
#include "preview/scene/scene.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace preview {

/// All meshes of a scene, one after the other, then those of mirrored objects wound the other way.
/// They stay while a scene stands.
struct Geometry {
    struct Vertex {
        glm::vec3 position{0};
        std::uint32_t normal = 0; ///< octahedral, two signed 16-bit numbers
    };
    struct Range {
        std::uint32_t first_index = 0, index_count = 0;
        std::int32_t vertex_offset = 0;
        Bounds bounds;
        /// Where its triangles stand once more, wound the other way: for objects that are mirrored.
        std::uint32_t mirrored_first_index = none;
        static constexpr std::uint32_t none = UINT32_MAX;
    };
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<Range> meshes;
    /// shaders/common/detail.glsl
    struct Detail {
        glm::vec2 uv[2]{};
        std::uint32_t color[2]{};  ///< four numbers of 16 bits
        std::uint32_t tangent = 0; ///< octahedral
        float side = 0;            ///< 0: there is none
    };
    std::vector<Detail> details; ///< one a vertex; empty for a scene without detail
};

Geometry geometry_of(const Scene& scene);

/// A unit vector as two signed numbers of 16 bits. Cigolle et al. 2014, "A survey of efficient
/// representations for independent unit vectors".
std::uint32_t encode_octahedral(glm::vec3 unit);

struct ObjectBlock {
    glm::vec4 model[3]{};  ///< rows of the affine transform
    glm::vec4 normal[3]{}; ///< rows of its cofactors, which carry normals
    glm::uvec4 material{0};
};

/// What a shadow map needs of an object.
struct CasterBlock {
    glm::vec4 model[3]{}; ///< rows of the affine transform
};

struct MaterialBlock {
    glm::vec4 albedo_roughness{0};
    glm::vec4 emission_metalness{0};
};

/// shaders/common/detail.glsl
struct TextureUseBlock {
    glm::vec3 u_row{1, 0, 0};
    std::uint32_t texture = TextureUse::none;
    glm::vec3 v_row{0, 1, 0};
    std::uint32_t uv_set = 0;
};
struct MaterialDetailBlock {
    TextureUseBlock base, surface, normal, occlusion, emission;
    float normal_scale = 1, occlusion_strength = 1, coverage = 1, least_coverage = 0;
    glm::uvec4 is_unlit{0}; ///< x
};

struct LightBlock {
    /// A sun's unit direction in place of a position; w: first layer of the shadow maps, -1: none.
    glm::vec4 position_layer{0, 0, 0, -1};
    glm::vec4 intensity_texel{0}; ///< w: size of a shadow texel at distance 1, or at any of a sun
    /// How much of the light arrives: the square of (axis . direction) w + range.x, held in 0..1.
    glm::vec4 axis_scale{0};
    glm::vec4 range{1, 0, 0, 0}; ///< y, z: near and far plane of its shadow maps; w: 1 of a sun
    glm::vec4 right_tangent{0};  ///< of a shadow map; w: of half its angle; a sun's: half its side
    glm::vec4 up_thickness{0};   ///< w: of a rod or ring
    glm::vec4 forward{0};        ///< of a shadow map; w: 1 / reach^2 of a light that ends, else 0
    glm::vec4 extent_shape{0};   ///< w: number of PointLight::Shape; a sun's: its map's origin
    glm::uvec4 faces{0};         ///< x: of six maps those that show casters, by bits; 0: one map
};

struct EnvironmentBlock {
    glm::vec4 zenith{0}, horizon{0}, ground{0};
    glm::vec4 soft_boxes[2 * Environment::max_soft_boxes]{};
};

struct ViewBlock {
    glm::mat4 clip{1}; ///< world to clip space
    glm::vec4 position_near{0};
    /// A pixel's ray is forward + x right + y up with x, y in -1..1, y down; its length is such
    /// that position + z ray has the view depth z.
    glm::vec4 forward{0}, right{0}, up{0};
};

std::vector<ObjectBlock> object_blocks(const Scene& scene);
/// Of the objects that cast shadows.
std::vector<CasterBlock> caster_blocks(const Scene& scene);
std::vector<MaterialBlock> material_blocks(const Scene& scene);
/// The numbers of the materials of caster_blocks().
std::vector<std::uint32_t> caster_materials(const Scene& scene);
std::vector<MaterialDetailBlock> material_detail_blocks(const Scene& scene);
EnvironmentBlock environment_block(const Environment& environment);
ViewBlock view_block(const Orbit& orbit, float aspect);

/// Of the objects that cast shadows, in the world.
Bounds caster_bounds(const Scene& scene, const Geometry& geometry);

/// The objects whose boxes meet the frustum of `clip`.
std::vector<std::uint32_t> visible_objects(const Scene& scene, const Geometry& geometry,
                                           const glm::mat4& clip);

/// One draw for each object, with the object's number as its instance. A mirrored object is drawn
/// from the triangles that are wound the other way, so that its outside is its front in every
/// rasteriser.
std::vector<Draw> draws_of(const Scene& scene, const Geometry& geometry,
                           const std::vector<std::uint32_t>& objects);

/// Parts `objects` into those that hide what is behind them, in their order, and those that are
/// blended, the farthest from `eye` first by the middles of their boxes.
struct Coverings {
    std::vector<std::uint32_t> opaque, blended;
};
Coverings by_covering(const Scene& scene, const Geometry& geometry,
                      const std::vector<std::uint32_t>& objects, glm::vec3 eye);

/// The scene on the graph.
struct SceneHandles {
    BufferHandle vertices, indices, objects, materials, lights, environment, view;
    std::uint32_t light_count = 0;
    bool has_spots = false, has_suns = false;
    bool has_ends = false;         ///< some light does not reach everywhere
    bool has_own_light = true;     ///< Scene::has_own_light(); without it nobody reads emission
    std::uint32_t area_shapes = 0; ///< of the lights that are no points: 1 << PointLight::Shape
    std::uint32_t soft_boxes = 0;
    /// Of a scene with detail; else empty.
    struct Detail {
        BufferHandle vertices, materials, textures, texels;
        bool has_cutouts = false;
        explicit operator bool() const { return static_cast<bool>(vertices); }
    };
    Detail detail;
};

} // namespace preview
