#include "lutlib/error.h"
#include "preview/scene/gltf_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace preview {

namespace {

using nlohmann::json;

float unit(float value) {
    return std::clamp(value, 0.0F, 1.0F);
}

struct WrapMode {
    std::size_t number;
    Wrap wrap;
};
constexpr WrapMode wrap_modes[] = {
    {10497, Wrap::repeat}, {33648, Wrap::mirror}, {33071, Wrap::clamp}};

struct FilterMode {
    std::size_t number;
    bool is_smooth;
    Mips mips;
};
constexpr FilterMode filter_modes[] = {
    {9728, false, Mips::none},   {9729, true, Mips::none},    {9984, false, Mips::nearest},
    {9985, true, Mips::nearest}, {9986, false, Mips::linear}, {9987, true, Mips::linear},
};

template <class Row>
const Row* row_of(std::span<const Row> rows, std::size_t number) {
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [&](const Row& row) { return row.number == number; });
    return found == rows.end() ? nullptr : &*found;
}

class Materials {
  public:
    Materials(const GltfFile& file, Scene& scene, LeftOut& left_out)
        : file_(file), scene_(scene), left_out_(left_out) {}

    GltfMaterial one(const json& given) {
        sets_.clear();
        GltfMaterial out;
        Material& material = out.material;
        MaterialDetail& detail = material.detail;
        const json& surface = gltf_object(given, "pbrMetallicRoughness");
        float base[4] = {1, 1, 1, 1};
        gltf_numbers(surface, "baseColorFactor", base, 4);
        material.albedo = {unit(base[0]), unit(base[1]), unit(base[2])};
        material.metalness = unit(gltf_number(surface, "metallicFactor", 1));
        material.roughness = unit(gltf_number(surface, "roughnessFactor", 1));
        detail.base = use(surface, "baseColorTexture", true);
        detail.surface = use(surface, "metallicRoughnessTexture", false);
        detail.normal = use(given, "normalTexture", false);
        detail.occlusion = use(given, "occlusionTexture", false);
        detail.normal_scale = gltf_number(gltf_object(given, "normalTexture"), "scale", 1);
        detail.occlusion_strength =
            unit(gltf_number(gltf_object(given, "occlusionTexture"), "strength", 1));
        const json& extensions = gltf_object(given, "extensions");
        float emission[3] = {0, 0, 0};
        gltf_numbers(given, "emissiveFactor", emission, 3);
        constexpr float most_emission = 65504;
        const float strength =
            std::clamp(gltf_number(gltf_object(extensions, "KHR_materials_emissive_strength"),
                                   "emissiveStrength", 1),
                       0.0F, most_emission);
        material.emission =
            strength * glm::vec3(unit(emission[0]), unit(emission[1]), unit(emission[2]));
        if (material.emission != glm::vec3(0)) {
            detail.emission = use(given, "emissiveTexture", true);
        }
        detail.is_unlit = extensions.contains("KHR_materials_unlit");
        set_coverage(given, unit(base[3]), detail);
        out.is_double_sided = given.value("doubleSided", json(false)) == json(true);
        for (std::size_t i = 0; i < sets_.size(); ++i) {
            out.uv_sets[i] = sets_[i];
        }
        gltf_extensions(given, "materials'",
                        {"KHR_materials_emissive_strength", "KHR_materials_unlit"}, left_out_);
        return out;
    }

  private:
    void set_coverage(const json& given, float coverage, MaterialDetail& detail) {
        const std::string mode = gltf_text(given, "alphaMode");
        if (mode == "MASK") {
            detail.least_coverage = unit(gltf_number(given, "alphaCutoff", 0.5F));
            detail.coverage = coverage;
        } else if (mode == "BLEND") {
            detail.is_blended = true;
            detail.coverage = coverage;
        }
    }

    TextureUse use(const json& object, const char* key, bool is_color) {
        TextureUse out;
        const json& info = gltf_object(object, key);
        const auto texture = file_.index(info, "index", "textures");
        if (!texture) {
            return out;
        }
        out.texture = texture_of(*texture, is_color);
        gltf_extensions(info, "textures'", {"KHR_texture_transform"}, left_out_);
        const json& moved = gltf_object(gltf_object(info, "extensions"), "KHR_texture_transform");
        const std::size_t given = file_.count(info, "texCoord", 0);
        const std::size_t set = file_.count(moved, "texCoord", given);
        auto known = std::find(sets_.begin(), sets_.end(), set);
        if (known == sets_.end()) {
            if (sets_.size() == 2) {
                left_out_.add("textures by a third set of texture coordinates");
                return {};
            }
            known = sets_.insert(sets_.end(), set);
        }
        out.uv_set = static_cast<std::uint32_t>(known - sets_.begin());
        float offset[2] = {0, 0};
        float scale[2] = {1, 1};
        gltf_numbers(moved, "offset", offset, 2);
        gltf_numbers(moved, "scale", scale, 2);
        const float angle = gltf_number(moved, "rotation", 0);
        // Translation times rotation times scale, as the extension has it.
        out.u_row = {std::cos(angle) * scale[0], std::sin(angle) * scale[1], offset[0]};
        out.v_row = {-std::sin(angle) * scale[0], std::cos(angle) * scale[1], offset[1]};
        return out;
    }

    std::uint32_t texture_of(std::size_t index, bool is_color) {
        const auto [known, is_new] = textures_.try_emplace({index, is_color}, TextureUse::none);
        if (!is_new) {
            return known->second;
        }
        const json& given = file_.list("textures")[index];
        gltf_extensions(given, "textures'", {}, left_out_);
        const auto image = file_.index(given, "source", "images");
        const std::uint32_t picture = image ? picture_at(*image) : TextureUse::none;
        if (picture == TextureUse::none) {
            return TextureUse::none;
        }
        Texture texture;
        texture.picture = picture;
        texture.is_color = is_color;
        if (const auto sampler = file_.index(given, "sampler", "samplers")) {
            set_sampler(file_.list("samplers")[*sampler], texture);
        }
        known->second = static_cast<std::uint32_t>(scene_.textures.size());
        scene_.textures.push_back(texture);
        return known->second;
    }

    void set_sampler(const json& sampler, Texture& texture) const {
        const auto wrap = [&](const char* key) {
            const auto* row =
                row_of(std::span<const WrapMode>(wrap_modes), file_.count(sampler, key, 10497));
            return row != nullptr ? row->wrap : Wrap::repeat;
        };
        texture.wrap_u = wrap("wrapS");
        texture.wrap_v = wrap("wrapT");
        texture.is_smooth_near = file_.count(sampler, "magFilter", 9729) != 9728;
        const auto* far = row_of(std::span<const FilterMode>(filter_modes),
                                 file_.count(sampler, "minFilter", 9987));
        if (far != nullptr) {
            texture.is_smooth_far = far->is_smooth;
            texture.mips = far->mips;
        }
    }

    std::uint32_t picture_at(std::size_t index) {
        const auto [known, is_new] = pictures_.try_emplace(index, TextureUse::none);
        if (!is_new) {
            return known->second;
        }
        const json& image = file_.list("images")[index];
        try {
            Picture picture = decoded(image);
            texels_ += picture.rgba.size() / 4;
            if (texels_ > import_limits.texels) {
                file_.refuse("its textures have more texels than the limit");
            }
            known->second = static_cast<std::uint32_t>(scene_.pictures.size());
            scene_.pictures.push_back(std::move(picture));
        } catch (const lutlib::Error& error) {
            left_out_.add("pictures that cannot be read: " + printable(error.what(), 240));
        }
        return known->second;
    }

    Picture decoded(const json& image) const {
        const std::string uri = gltf_text(image, "uri");
        const std::string name =
            uri.empty() || uri.starts_with("data:") ? "a picture in the file" : printable(uri);
        if (const auto view = file_.index(image, "bufferView", "bufferViews")) {
            return picture_of(file_.view_bytes(*view), name);
        }
        return picture_of(file_.uri_bytes(uri, import_limits.file_bytes), name);
    }

    const GltfFile& file_;
    Scene& scene_;
    LeftOut& left_out_;
    std::vector<std::size_t> sets_; ///< of texture coordinates, of the material being read
    std::map<std::pair<std::size_t, bool>, std::uint32_t> textures_;
    std::map<std::size_t, std::uint32_t> pictures_;
    std::size_t texels_ = 0;
};

} // namespace

std::vector<GltfMaterial> gltf_materials(const GltfFile& file, Scene& scene, LeftOut& left_out) {
    Materials materials(file, scene, left_out);
    std::vector<GltfMaterial> out;
    for (const json& given : file.list("materials")) {
        out.push_back(materials.one(given));
    }
    out.push_back(materials.one(json::object()));
    return out;
}

} // namespace preview
