#include "preview/reference/surface.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace preview::reference {

DetailedSurface surface_of(const Scene& scene, const Material& material, const SurfacePoint& at) {
    const MaterialDetail& detail = material.detail;
    const auto texel = [&](const TextureUse& use) {
        return texture_at(scene, use, at.uv[use.uv_set], at.dx[use.uv_set], at.dy[use.uv_set]);
    };
    DetailedSurface out;
    const glm::dvec4 base =
        glm::dvec4(material.albedo, detail.coverage) * at.color * texel(detail.base);
    out.albedo = glm::clamp(glm::dvec3(base), 0.0, 1.0);
    out.is_cut_out = base.w < static_cast<double>(detail.least_coverage);
    out.normal = at.normal;
    out.roughness = static_cast<double>(material.roughness);
    out.metalness = static_cast<double>(material.metalness);
    out.emission = glm::dvec3(material.emission);
    if (detail.is_unlit) {
        out.emission = out.albedo;
        return out;
    }
    out.roughness *= texel(detail.surface).g;
    out.metalness *= texel(detail.surface).b;
    out.occlusion +=
        static_cast<double>(detail.occlusion_strength) * (texel(detail.occlusion).r - 1);
    out.emission *= glm::dvec3(texel(detail.emission));
    if (detail.normal.texture != TextureUse::none && at.tangent.w != 0) {
        const glm::dvec3 tangent(at.tangent);
        glm::dvec3 turned = glm::dvec3(texel(detail.normal)) * 2.0 - 1.0;
        turned.x *= static_cast<double>(detail.normal_scale);
        turned.y *= static_cast<double>(detail.normal_scale);
        out.normal = glm::normalize(turned.x * tangent +
                                    turned.y * at.tangent.w * glm::cross(at.normal, tangent) +
                                    turned.z * at.normal);
    }
    return out;
}

} // namespace preview::reference
