#include "preview/scene/scene_data.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/packing.hpp>

#include <algorithm>
#include <cmath>

namespace preview {

namespace {

float sign_not_zero(float v) {
    return v < 0 ? -1.0F : 1.0F;
}

std::uint32_t snorm16(float v) {
    return static_cast<std::uint32_t>(
               static_cast<std::int32_t>(std::lround(std::clamp(v, -1.0F, 1.0F) * 32767.0F))) &
           0xffffU;
}

/// The rows of an affine transform.
void set_rows(glm::vec4 (&rows)[3], const glm::mat4& transform) {
    for (int row = 0; row < 3; ++row) {
        rows[row] = {transform[0][row], transform[1][row], transform[2][row], transform[3][row]};
    }
}

/// Whether the transform turns outsides in.
bool is_mirroring(const glm::mat4& m) {
    return glm::dot(glm::cross(glm::vec3(m[0]), glm::vec3(m[1])), glm::vec3(m[2])) < 0;
}

/// Lists the mesh's triangles once more with their winding reversed.
void add_mirrored(Geometry& geometry, Geometry::Range& mesh) {
    if (mesh.mirrored_first_index != Geometry::Range::none) {
        return;
    }
    mesh.mirrored_first_index = static_cast<std::uint32_t>(geometry.indices.size());
    for (std::uint32_t at = mesh.first_index; at < mesh.first_index + mesh.index_count; at += 3) {
        for (const std::uint32_t corner : {0U, 2U, 1U}) {
            geometry.indices.push_back(geometry.indices[at + corner]);
        }
    }
}

Geometry::Detail packed(const VertexDetail& detail) {
    Geometry::Detail out;
    out.uv[0] = detail.uv[0];
    out.uv[1] = detail.uv[1];
    out.color[0] = glm::packUnorm2x16({detail.color.x, detail.color.y});
    out.color[1] = glm::packUnorm2x16({detail.color.z, detail.color.w});
    out.tangent = encode_octahedral(glm::vec3(detail.tangent));
    out.side = detail.tangent.w;
    return out;
}

TextureUseBlock block_of(const TextureUse& use) {
    return {use.u_row, use.texture, use.v_row, use.uv_set};
}

/// True when all corners of the box lie outside one and the same plane of the frustum.
bool outside(const Bounds& box, const glm::mat4& to_clip) {
    int beyond[6] = {};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec4 p = to_clip * glm::vec4((corner & 1) != 0 ? box.max.x : box.min.x,
                                                (corner & 2) != 0 ? box.max.y : box.min.y,
                                                (corner & 4) != 0 ? box.max.z : box.min.z, 1);
        beyond[0] += p.x < -p.w ? 1 : 0;
        beyond[1] += p.x > p.w ? 1 : 0;
        beyond[2] += p.y < -p.w ? 1 : 0;
        beyond[3] += p.y > p.w ? 1 : 0;
        beyond[4] += p.z < 0 ? 1 : 0;
        beyond[5] += p.z > p.w ? 1 : 0;
    }
    return std::any_of(std::begin(beyond), std::end(beyond), [](int count) { return count == 8; });
}

} // namespace

std::uint32_t encode_octahedral(glm::vec3 unit) {
    const float sum = std::abs(unit.x) + std::abs(unit.y) + std::abs(unit.z);
    if (!(sum > 0)) {
        return 0;
    }
    float x = unit.x / sum;
    float y = unit.y / sum;
    if (unit.z < 0) {
        const float folded = (1 - std::abs(y)) * sign_not_zero(x);
        y = (1 - std::abs(x)) * sign_not_zero(y);
        x = folded;
    }
    return snorm16(x) | snorm16(y) << 16U;
}

Geometry geometry_of(const Scene& scene) {
    Geometry geometry;
    const bool has_detail = scene.has_detail();
    for (const Mesh& mesh : scene.meshes) {
        geometry.meshes.push_back({static_cast<std::uint32_t>(geometry.indices.size()),
                                   static_cast<std::uint32_t>(mesh.indices.size()),
                                   static_cast<std::int32_t>(geometry.vertices.size()),
                                   bounds_of(mesh), Geometry::Range::none});
        for (const Vertex& vertex : mesh.vertices) {
            geometry.vertices.push_back({vertex.position, encode_octahedral(vertex.normal)});
        }
        if (has_detail) {
            for (const VertexDetail& detail : mesh.details) {
                geometry.details.push_back(packed(detail));
            }
            geometry.details.resize(geometry.vertices.size(), packed({}));
        }
        geometry.indices.insert(geometry.indices.end(), mesh.indices.begin(), mesh.indices.end());
    }
    for (const Object& object : scene.objects) {
        if (is_mirroring(object.transform)) {
            add_mirrored(geometry, geometry.meshes[object.mesh]);
        }
    }
    return geometry;
}

std::vector<ObjectBlock> object_blocks(const Scene& scene) {
    std::vector<ObjectBlock> blocks;
    for (const Object& object : scene.objects) {
        const glm::mat4& m = object.transform;
        const glm::vec3 x(m[0]);
        const glm::vec3 y(m[1]);
        const glm::vec3 z(m[2]);
        // The columns of the cofactor matrix; it carries normals also under uneven scales, and a
        // mirroring transform turns them round.
        const float side = is_mirroring(m) ? -1.0F : 1.0F;
        const glm::vec3 c[3] = {side * glm::cross(y, z), side * glm::cross(z, x),
                                side * glm::cross(x, y)};
        ObjectBlock block;
        set_rows(block.model, m);
        for (int row = 0; row < 3; ++row) {
            block.normal[row] = {c[0][row], c[1][row], c[2][row], 0};
        }
        block.material.x = object.material;
        blocks.push_back(block);
    }
    return blocks;
}

std::vector<CasterBlock> caster_blocks(const Scene& scene) {
    std::vector<CasterBlock> blocks;
    for (const Object& object : scene.objects) {
        if (object.casts_shadow) {
            set_rows(blocks.emplace_back().model, object.transform);
        }
    }
    return blocks;
}

std::vector<MaterialBlock> material_blocks(const Scene& scene) {
    std::vector<MaterialBlock> blocks;
    for (const Material& material : scene.materials) {
        blocks.push_back({glm::vec4(material.albedo, material.roughness),
                          glm::vec4(material.emission, material.metalness)});
    }
    return blocks;
}

std::vector<std::uint32_t> caster_materials(const Scene& scene) {
    std::vector<std::uint32_t> materials;
    for (const Object& object : scene.objects) {
        if (object.casts_shadow) {
            materials.push_back(object.material);
        }
    }
    return materials;
}

std::vector<MaterialDetailBlock> material_detail_blocks(const Scene& scene) {
    std::vector<MaterialDetailBlock> blocks;
    for (const Material& material : scene.materials) {
        const MaterialDetail& detail = material.detail;
        MaterialDetailBlock& block = blocks.emplace_back();
        block.base = block_of(detail.base);
        block.surface = block_of(detail.surface);
        block.normal = block_of(detail.normal);
        block.occlusion = block_of(detail.occlusion);
        block.emission = block_of(detail.emission);
        block.normal_scale = detail.normal_scale;
        block.occlusion_strength = detail.occlusion_strength;
        block.coverage = detail.coverage;
        block.least_coverage = detail.least_coverage;
        block.is_unlit.x = detail.is_unlit ? 1 : 0;
    }
    return blocks;
}

EnvironmentBlock environment_block(const Environment& environment) {
    EnvironmentBlock block;
    block.zenith = glm::vec4(environment.zenith, 0);
    block.horizon = glm::vec4(environment.horizon, 0);
    block.ground = glm::vec4(environment.ground, 0);
    for (int box = 0; box < environment.soft_box_count; ++box) {
        const SoftBox& soft = environment.soft_boxes[box];
        block.soft_boxes[2 * box] = glm::vec4(soft.axis, soft.sharpness);
        block.soft_boxes[2 * box + 1] = glm::vec4(soft.radiance, 0);
    }
    return block;
}

ViewBlock view_block(const Orbit& orbit, float aspect) {
    const Camera camera = camera_of(orbit, aspect);
    const glm::mat4 world = glm::transpose(camera.view); // its columns 0..2 are the camera's axes
    ViewBlock block;
    block.clip = camera.projection * camera.view;
    block.position_near = glm::vec4(camera.position, orbit.near_plane);
    block.right = glm::vec4(glm::vec3(world[0]) / camera.projection[0][0], 0);
    block.up = glm::vec4(glm::vec3(world[1]) / camera.projection[1][1], 0);
    block.forward = glm::vec4(-glm::vec3(world[2]), 0);
    return block;
}

Bounds caster_bounds(const Scene& scene, const Geometry& geometry) {
    Bounds all;
    for (const Object& object : scene.objects) {
        const Bounds& box = geometry.meshes[object.mesh].bounds;
        if (object.casts_shadow && !box.empty()) {
            all.include(box, object.transform);
        }
    }
    return all;
}

std::vector<std::uint32_t> visible_objects(const Scene& scene, const Geometry& geometry,
                                           const glm::mat4& clip) {
    std::vector<std::uint32_t> visible;
    for (std::uint32_t index = 0; index < scene.objects.size(); ++index) {
        const Object& object = scene.objects[index];
        const Bounds& bounds = geometry.meshes[object.mesh].bounds;
        if (!bounds.empty() && !outside(bounds, clip * object.transform)) {
            visible.push_back(index);
        }
    }
    return visible;
}

Coverings by_covering(const Scene& scene, const Geometry& geometry,
                      const std::vector<std::uint32_t>& objects, glm::vec3 eye) {
    Coverings out;
    std::vector<std::pair<float, std::uint32_t>> blended;
    for (const std::uint32_t index : objects) {
        const Object& object = scene.objects[index];
        if (!scene.materials[object.material].detail.is_blended) {
            out.opaque.push_back(index);
            continue;
        }
        Bounds box;
        box.include(geometry.meshes[object.mesh].bounds, object.transform);
        blended.emplace_back(-glm::distance(eye, (box.min + box.max) * 0.5F), index);
    }
    std::stable_sort(blended.begin(), blended.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [away, index] : blended) {
        out.blended.push_back(index);
    }
    return out;
}

std::vector<Draw> draws_of(const Scene& scene, const Geometry& geometry,
                           const std::vector<std::uint32_t>& objects) {
    std::vector<Draw> draws;
    for (const std::uint32_t index : objects) {
        const Object& object = scene.objects[index];
        const Geometry::Range& mesh = geometry.meshes[object.mesh];
        const bool is_mirrored =
            mesh.mirrored_first_index != Geometry::Range::none && is_mirroring(object.transform);
        draws.push_back({mesh.index_count,
                         is_mirrored ? mesh.mirrored_first_index : mesh.first_index,
                         mesh.vertex_offset, 1, index});
    }
    return draws;
}

} // namespace preview
