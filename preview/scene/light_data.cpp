#include "preview/scene/light_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace preview {

namespace {

constexpr std::array<std::string_view, 6> sides{"+x", "-x", "+y", "-y", "+z", "-z"};

/// The filter of a shadow reaches so many texels beyond a point's own side.
constexpr float border_texels = 3;

ShadowFrustum aimed_frustum(const PointLight& light) {
    ShadowFrustum out;
    const glm::vec3 towards = light.aim - light.position;
    out.forward = glm::dot(towards, towards) > 0 ? glm::normalize(towards) : glm::vec3(0, -1, 0);
    const glm::vec3 above =
        std::abs(out.forward.y) > 0.99F ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
    out.right = glm::normalize(glm::cross(out.forward, above));
    out.up = glm::cross(out.forward, out.right);
    out.tangent = std::tan(glm::radians(std::clamp(light.shadow_angle, 1.0F, 170.0F)) / 2);
    out.near_plane = light.shadow_near;
    out.far_plane = light.shadow_far;
    return out;
}

ShadowFrustum sun_frustum(const PointLight& sun, const Bounds& casters) {
    ShadowFrustum out;
    out.is_parallel = true;
    out.forward = -sun.towards_sun();
    const glm::vec3 above =
        std::abs(out.forward.y) > 0.99F ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
    out.right = glm::normalize(glm::cross(out.forward, above));
    out.up = glm::cross(out.forward, out.right);
    const glm::mat3 axes(out.right, out.up, out.forward); // of the box to the world
    Bounds box;
    box.include(casters.empty() ? Bounds{glm::vec3(-1), glm::vec3(1)} : casters,
                glm::mat4(glm::transpose(axes)));
    const glm::vec3 size = box.max - box.min;
    // Room for the filter beside the casters.
    const float margin = std::max(0.02F * glm::length(size), 1e-4F);
    const glm::vec3 middle = (box.min + box.max) * 0.5F;
    out.origin = axes * glm::vec3(middle.x, middle.y, box.min.z - margin);
    out.tangent = std::max(size.x, size.y) / 2 + margin;
    out.near_plane = 0;
    out.far_plane = size.z + 2 * margin;
    return out;
}

ShadowFrustum frustum_of_face(const PointLight& light, unsigned face, std::uint32_t map_size) {
    ShadowFrustum out;
    const auto axis = static_cast<int>(face / 2);
    out.forward = out.right = out.up = glm::vec3(0);
    out.forward[axis] = face % 2 == 0 ? 1.0F : -1.0F;
    out.right[(axis + 1) % 3] = 1;
    out.up[(axis + 2) % 3] = 1;
    const auto texels = static_cast<float>(std::max(map_size, 1U));
    out.tangent = texels / std::max(texels - 2 * border_texels, 1.0F);
    out.near_plane = light.shadow_near;
    out.far_plane = light.shadow_far;
    return out;
}

/// Why a view shows nothing that a shadow needs; empty when it does. Fills in its casters.
std::string_view look(const Scene& scene, const Geometry& geometry, const PointLight& light,
                      ShadowView& view) {
    bool has_receiver = false;
    for (const std::uint32_t index :
         visible_objects(scene, geometry, shadow_clip(light, view.frustum))) {
        const Object& object = scene.objects[index];
        has_receiver |= !scene.materials[object.material].detail.is_unlit;
        if (object.casts_shadow) {
            view.casters.push_back(index);
        }
    }
    return view.casters.empty() ? "no caster in the light's frustum"
           : !has_receiver      ? "no receiver in the light's frustum"
                                : "";
}

} // namespace

glm::mat4 shadow_clip(const PointLight& light, const ShadowFrustum& frustum) {
    const glm::vec3 origin = frustum.is_parallel ? frustum.origin : light.position;
    const float scale = frustum.far_plane / (frustum.far_plane - frustum.near_plane);
    const float depth = frustum.far_plane - frustum.near_plane;
    const glm::vec4 rows[4] = {
        {frustum.right / frustum.tangent, 0},
        {frustum.up / frustum.tangent, 0},
        frustum.is_parallel ? glm::vec4(frustum.forward / depth, -frustum.near_plane / depth)
                            : glm::vec4(frustum.forward * scale, -scale * frustum.near_plane),
        frustum.is_parallel ? glm::vec4(0, 0, 0, 1) : glm::vec4(frustum.forward, 0)};
    glm::mat4 clip(0);
    for (int row = 0; row < 4; ++row) {
        const glm::vec3 axis(rows[row]);
        for (int column = 0; column < 3; ++column) {
            clip[column][row] = axis[column];
        }
        clip[3][row] = rows[row].w - glm::dot(axis, origin);
    }
    return clip;
}

LightShadow shadow_of(const Scene& scene, const Geometry& geometry, const PointLight& light,
                      std::uint32_t map_size) {
    LightShadow out;
    if (!light.casts_shadow) {
        out.reason = "the light casts none";
        return out;
    }
    if (light.intensity == glm::vec3(0)) {
        out.reason = "the light's intensity is 0";
        return out;
    }
    const auto has_map = [&](ShadowView view) {
        const std::string_view reason = look(scene, geometry, light, view);
        out.views.push_back(std::move(view));
        if (!reason.empty()) {
            out.reason = reason;
        }
        return reason.empty();
    };
    bool has_any = false;
    if (light.is_sun) {
        has_any = has_map({sun_frustum(light, caster_bounds(scene, geometry)), {}, {}});
    } else if (!light.shadows_all_round()) {
        has_any = has_map({aimed_frustum(light), {}, {}});
    } else {
        for (unsigned face = 0; face < sides.size(); ++face) {
            const bool has = has_map({frustum_of_face(light, face, map_size), sides[face], {}});
            out.faces |= has ? 1U << face : 0;
            has_any |= has;
        }
    }
    if (has_any) {
        out.reason.clear();
    } else {
        out.views.clear();
    }
    return out;
}

LightBlock light_block(const PointLight& light, const LightShadow& shadow, int first_layer,
                       std::uint32_t map_size) {
    LightBlock block;
    block.position_layer = glm::vec4(light.is_sun ? light.towards_sun() : light.position,
                                     static_cast<float>(first_layer));
    block.range.w = light.is_sun ? 1 : 0;
    block.intensity_texel = glm::vec4(light.intensity, 0);
    if (!shadow.views.empty()) {
        const ShadowFrustum& frustum = shadow.views.front().frustum;
        block.intensity_texel.w = 2 * frustum.tangent / static_cast<float>(std::max(map_size, 1U));
        block.range.y = frustum.near_plane;
        block.range.z = frustum.far_plane;
        block.right_tangent = glm::vec4(frustum.right, frustum.tangent);
        block.up_thickness = glm::vec4(frustum.up, 0);
        block.forward = glm::vec4(frustum.forward, 0);
        block.faces.x = shadow.faces;
    }
    block.up_thickness.w = light.is_point() ? 0 : light.thickness;
    block.forward.w = light.ends() ? 1 / (light.reach * light.reach) : 0;
    if (light.lit_shape() != PointLight::Shape::point) {
        block.extent_shape = glm::vec4(light.extent, static_cast<float>(light.lit_shape()));
    }
    if (light.is_sun) {
        block.extent_shape =
            glm::vec4(shadow.views.empty() ? glm::vec3(0) : shadow.views.front().frustum.origin, 0);
    }
    if (light.is_spot()) {
        // KHR_lights_punctual.
        const float inner = std::cos(glm::radians(light.inner_angle));
        const float outer = std::cos(glm::radians(light.outer_angle));
        const float scale = 1 / std::max(inner - outer, 0.001F);
        block.axis_scale = glm::vec4(light.axis, scale);
        block.range.x = -outer * scale;
    }
    return block;
}

} // namespace preview
