#include "preview/scene/import_parts.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/image.h"

#include <assimp/GltfMaterial.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>

namespace preview {

namespace {

namespace io = lutlib::io;

float linear(float encoded) {
    return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

/// A channel of a file's materials: 0..1, and `usual` where it is no number.
float unit(float value, float usual) {
    return std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : usual;
}

io::FloatImage decoded(const aiScene& scene, const std::string& name, const std::string& folder) {
    const aiTexture* const embedded = scene.GetEmbeddedTexture(name.c_str());
    if (embedded == nullptr) {
        return io::read_image((std::filesystem::path(folder) / name).string());
    }
    if (embedded->mHeight != 0) {
        throw lutlib::Error("a texture in the file has no picture format", {name, 0, {}});
    }
    return io::decode_image(
        {reinterpret_cast<const char*>(embedded->pcData), std::size_t{embedded->mWidth}},
        embedded->achFormatHint, name);
}

glm::vec3 mean_of(const io::FloatImage& image, bool is_color) {
    double sum[3] = {};
    for (std::size_t at = 0; at < image.rgba.size(); at += 4) {
        for (std::size_t c = 0; c < 3; ++c) {
            sum[c] +=
                static_cast<double>(is_color ? linear(image.rgba[at + c]) : image.rgba[at + c]);
        }
    }
    const auto texels = static_cast<double>(std::max<std::size_t>(image.rgba.size() / 4, 1));
    return {unit(static_cast<float>(sum[0] / texels), 1),
            unit(static_cast<float>(sum[1] / texels), 1),
            unit(static_cast<float>(sum[2] / texels), 1)};
}

/// The mean of a texture, white for a material that has none. Colours are sRGB-encoded in files.
glm::vec3 texture_mean(const aiScene& scene, const aiMaterial& material, aiTextureType type,
                       bool is_color, const std::string& folder, LeftOut& left_out) {
    aiString name;
    if (material.GetTexture(type, 0, &name) != aiReturn_SUCCESS) {
        return glm::vec3(1);
    }
    try {
        const glm::vec3 mean = mean_of(decoded(scene, name.C_Str(), folder), is_color);
        left_out.add("textures' detail (replaced by their mean)");
        return mean;
    } catch (const lutlib::Error&) {
        left_out.add("textures that cannot be read");
        return glm::vec3(1);
    }
}

// Assimp's names of properties are three arguments each.
float factor(const aiMaterial& material, const char* key, unsigned type, unsigned index,
             float usual) {
    float value = usual;
    material.Get(key, type, index, value);
    return unit(value, usual);
}

glm::vec3 color(const aiMaterial& material, const char* key, unsigned type, unsigned index,
                glm::vec3 usual) {
    aiColor4D value(usual.x, usual.y, usual.z, 1);
    material.Get(key, type, index, value);
    return {unit(value.r, usual.x), unit(value.g, usual.y), unit(value.b, usual.z)};
}

} // namespace

Material import_material(const aiScene& scene, const aiMaterial& material,
                         const std::string& folder, LeftOut& left_out) {
    const auto mean = [&](aiTextureType type, bool is_color) {
        return texture_mean(scene, material, type, is_color, folder, left_out);
    };
    Material out;
    out.albedo =
        color(material, AI_MATKEY_BASE_COLOR, glm::vec3(1)) * mean(aiTextureType_BASE_COLOR, true);
    // Roughness is in green, metalness in blue.
    const glm::vec3 surface = mean(aiTextureType_METALNESS, false);
    out.metalness = factor(material, AI_MATKEY_METALLIC_FACTOR, 1) * surface.b;
    out.roughness = factor(material, AI_MATKEY_ROUGHNESS_FACTOR, 1) * surface.g;
    out.emission = color(material, AI_MATKEY_COLOR_EMISSIVE, glm::vec3(0));
    if (out.emission != glm::vec3(0)) {
        out.emission *= mean(aiTextureType_EMISSIVE, true);
    }
    return out;
}

} // namespace preview
