#include "preview/check/seen_surfaces.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace preview {

namespace {

using lutlib::RgbD;

RgbD texel_of(const Observed& image, std::size_t at) {
    const float* const from = image.values.data() + image.channels * at;
    return lutlib::to_double(lutlib::Rgb{from[0], from[1], from[2]});
}

RgbD color_of(glm::vec4 v) {
    return lutlib::to_double(lutlib::Rgb{v.x, v.y, v.z});
}

/// Of the word of a surface with detail: ten bits, as a share.
double share_in(std::uint32_t word, unsigned shift) {
    return static_cast<double>(word >> shift & 1023U) / 1023;
}

/// Of the word of a material: what normals that vary within the pixel add to alpha^2. Its root is
/// kept in eight bits; 0.18 is the most.
double added_in(std::uint32_t word) {
    return std::pow(static_cast<double>(word >> 24U) / 255, 2) * 0.18;
}

} // namespace

reference::SeenSurfaces seen_surfaces(const TwinInput& in, const Observed& depth,
                                      const Observed* normals) {
    reference::SeenSurfaces out;
    out.width = static_cast<int>(depth.desc.width);
    out.height = static_cast<int>(depth.desc.height);
    out.view = view_block(in.situation.settings.orbit, static_cast<float>(depth.desc.width) /
                                                           static_cast<float>(depth.desc.height));
    out.depth = depth.values;
    for (std::size_t i = 0; normals != nullptr && i < out.depth.size(); ++i) {
        const auto word = [&](std::size_t c) {
            return std::round(static_cast<double>(normals->values[2 * i + c]) * 65535);
        };
        out.normal.push_back(reference::octahedral_normal(word(0), word(1)));
    }
    return out;
}

GBufferRead::GBufferRead(const TwinInput& in, const ReadBy& read, bool has_detail)
    : seen_(seen_surfaces(in, *read.image(3), read.image(4))), words_(read.image(5)),
      occlusion_(read.image(8)), takes_light_(read.image(4) != nullptr), has_detail_(has_detail) {
    if (has_detail_) {
        albedo_ = read.image(6);
        emission_ = read.image(10);
    } else {
        materials_ = read.blocks<MaterialBlock>(6);
    }
}

glm::dvec3 GBufferRead::direction(int x, int y) const {
    const auto place = [](int at, int size) { return (at + 0.5) / size * 2 - 1; };
    return glm::normalize(glm::dvec3(seen_.view.forward) +
                          place(x, seen_.width) * glm::dvec3(seen_.view.right) +
                          place(y, seen_.height) * glm::dvec3(seen_.view.up));
}

double GBufferRead::rounding(int x, int y) const {
    return 0x1p-22 *
           (glm::length(glm::dvec3(seen_.view.position_near)) + glm::length(seen_.position(x, y)));
}

/// Where textures have turned the normal: of the plane through what the picture shows beside it, on
/// the side of each axis that is nearer in depth.
void GBufferRead::find_face(reference::LitSurface& surface, int x, int y) const {
    const auto depth = [&](int at_x, int at_y) {
        return static_cast<double>(seen_.depth[seen_.index(at_x, at_y)]);
    };
    const auto along = [&](int dx, int dy) {
        glm::dvec3 found(0);
        double least = 2;
        for (const int side : {-1, 1}) {
            const int at_x = x + side * dx, at_y = y + side * dy;
            if (at_x < 0 || at_y < 0 || at_x >= seen_.width || at_y >= seen_.height ||
                !seen_.shows(at_x, at_y)) {
                continue;
            }
            const double step = std::abs(depth(at_x, at_y) - depth(x, y));
            if (step < least) {
                least = step;
                found =
                    (seen_.position(at_x, at_y) - seen_.position(x, y)) * static_cast<double>(side);
            }
        }
        return found;
    };
    const glm::dvec3 found = glm::cross(along(1, 0), along(0, 1));
    const double length = glm::length(found);
    if (length > 0) {
        const double facing = glm::dot(found, surface.material.normal) / length;
        surface.face = found / (facing < 0 ? -length : length);
        surface.is_face_in_doubt = std::abs(facing) < 1e-4;
    }
}

reference::LitSurface GBufferRead::at(int x, int y) const {
    const std::size_t index = seen_.index(x, y);
    const std::uint32_t word = words_ != nullptr ? words_->words[index] : 0;
    reference::LitSurface out;
    const MaterialBlock* material = nullptr;
    if (!has_detail_) {
        const std::size_t number = (word & 0xFFFFFFU) - std::size_t{1};
        if (number >= materials_.size()) { // nothing can be the twin of a surface of none
            out.emission = {NAN, NAN, NAN};
            out.is_unlit = true;
            return out;
        }
        material = &materials_[number];
        out.emission = color_of(material->emission_metalness);
    } else if (emission_ != nullptr) {
        out.emission = texel_of(*emission_, index);
    }
    out.is_unlit = !takes_light_ || (has_detail_ && (word >> 30U & 1U) != 0);
    if (out.is_unlit) {
        return out;
    }
    out.position = glm::dvec3(seen_.view.position_near) + seen_.position(x, y);
    out.view = -direction(x, y);
    out.material.normal = out.face = seen_.normal[index];
    if (occlusion_ != nullptr) {
        out.unoccluded = static_cast<double>(occlusion_->values[index]);
    }
    if (material == nullptr) {
        out.material.albedo = texel_of(*albedo_, index);
        out.material.roughness = share_in(word, 20);
        out.material.metalness = share_in(word, 10);
        out.occlusion = share_in(word, 0);
        find_face(out, x, y);
        return out;
    }
    const auto roughness = static_cast<double>(material->albedo_roughness.w);
    const double added = added_in(word);
    out.material.albedo = color_of(material->albedo_roughness);
    out.material.roughness =
        added > 0 ? std::pow(std::min(std::pow(roughness, 4) + added, 1.0), 0.25) : roughness;
    out.material.metalness = static_cast<double>(material->emission_metalness.w);
    return out;
}

} // namespace preview
