// glTF files as scenes: what is taken over, what is told, what is refused.
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "preview/scene/builtin.h"
#include "tests/preview/scene/import_fixture.h"

#include <cmath>
#include <numbers>
#include <set>

namespace preview {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::json;

TEST_F(ImportTest, takes_triangles_with_the_transforms_of_their_nodes) {
    GltfWriter gltf;
    const std::size_t mesh = gltf.add_mesh(square_corners());
    const std::size_t child = gltf.add("nodes", {{"mesh", mesh}, {"translation", {10, 0, 0}}});
    gltf.add_node({{"mesh", mesh}, {"children", {child}}, {"scale", {2, 2, 2}}});
    const ImportedScene imported = import(gltf);
    const Scene& scene = imported.scene;
    EXPECT_TRUE(imported.left_out.empty());
    ASSERT_EQ(scene.objects.size(), 2U);
    // 2 wide about 0, and 4 wide about 20.
    const glm::vec3 first(scene.objects[0].transform[3]);
    const glm::vec3 second(scene.objects[1].transform[3]);
    const float scale = glm::length(glm::vec3(scene.objects[0].transform[0])) / 2;
    expect_near(second - first, {20 * scale, 0, 0}, rounding);
    const Bounds box = scene.bounds();
    expect_near(box.max - box.min, glm::vec3(24, 4, 0) * scale, rounding);
    for (const Vertex& vertex : scene.meshes[0].vertices) {
        expect_near(vertex.normal, {0, 0, 1}, rounding);
    }
}

TEST_F(ImportTest, frames_all_of_a_file_without_a_camera_at_any_scale) {
    for (const float size : {1e-3F, 1.0F, 1e4F}) {
        GltfWriter gltf;
        gltf.add_node({{"mesh", gltf.add_mesh(square_corners())}, {"scale", {size, size, size}}});
        const Scene scene = import(gltf).scene;
        const Camera camera = camera_of(scene.orbit, 16.0F / 9);
        for (const float x : {-1.0F, 1.0F}) {
            for (const float y : {-1.0F, 1.0F}) {
                const glm::vec4 clip = camera.projection * camera.view *
                                       scene.objects[0].transform * glm::vec4(x, y, 0, 1);
                EXPECT_LT(std::abs(clip.x), clip.w) << size;
                EXPECT_LT(std::abs(clip.y), clip.w) << size;
                EXPECT_GT(std::abs(clip.y), 0.4F * clip.w) << size;
            }
        }
    }
}

TEST_F(ImportTest, takes_the_factors_of_materials) {
    GltfWriter gltf;
    gltf.add("materials",
             {{"pbrMetallicRoughness",
               {{"baseColorFactor", {0.25, 0.5, 0.75, 1}},
                {"metallicFactor", 0.125},
                {"roughnessFactor", 0.625}}},
              {"emissiveFactor", {1, 0.5, 0.25}},
              {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}}}});
    gltf.root["extensionsUsed"] = {"KHR_materials_emissive_strength"};
    gltf.add_node({{"mesh", gltf.add_mesh(square_corners())}});
    const ImportedScene imported = import(gltf);
    const Scene& scene = imported.scene;
    const Material& material = scene.materials[scene.objects[0].material];
    expect_near(material.albedo, {0.25F, 0.5F, 0.75F}, rounding);
    EXPECT_NEAR(material.metalness, 0.125F, rounding);
    EXPECT_NEAR(material.roughness, 0.625F, rounding);
    expect_near(material.emission, {8, 4, 2}, rounding);
}

TEST_F(ImportTest, looks_through_the_file_s_camera) {
    GltfWriter gltf = one_square();
    gltf.add("cameras", {{"type", "perspective"},
                         {"perspective", {{"yfov", 0.5}, {"aspectRatio", 2}, {"znear", 0.1}}}});
    gltf.add("cameras", {{"type", "perspective"},
                         {"perspective", {{"yfov", 1.0}, {"aspectRatio", 2}, {"znear", 0.1}}}});
    // Turned to the right by 90 degrees about y it looks along -x.
    const double turn = std::numbers::sqrt2 / 2;
    gltf.add_node({{"camera", 0}, {"translation", {6, 0, 0}}, {"rotation", {0, turn, 0, turn}}});
    gltf.add_node({{"camera", 1}});
    const ImportedScene imported = import(gltf);
    const Scene& scene = imported.scene;
    const Camera camera = camera_of(scene.orbit, 16.0F / 9);
    const glm::mat4& fit = scene.objects[0].transform;
    expect_near(camera.position, glm::vec3(fit * glm::vec4(6, 0, 0, 1)), rounding);
    expect_near(scene.orbit.target, glm::vec3(fit * glm::vec4(0, 0, 0, 1)), rounding);
    EXPECT_NEAR(scene.orbit.field_of_view, 0.5 * 180 / std::numbers::pi, 1e-3);
    EXPECT_EQ(scene.cameras.size(), 2U);
}

TEST_F(ImportTest, shines_with_the_file_s_lights_as_bright_as_they_were) {
    GltfWriter gltf = one_square();
    gltf.root["extensionsUsed"] = {"KHR_lights_punctual"};
    gltf.root["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "point"},
         {"color", {1, 0.5, 0.25}},
         {"intensity", 8},
         {"name", "lamp"},
         {"range", 6}},
        {{"type", "directional"}, {"intensity", 3}, {"name", "sun"}},
        {{"type", "spot"}, {"intensity", 2}, {"spot", {{"outerConeAngle", 0.5}}}}};
    const auto light_node = [](int light, json at) {
        return json{{"extensions", {{"KHR_lights_punctual", {{"light", light}}}}},
                    {"translation", std::move(at)},
                    {"name", light == 0   ? "lamp"
                             : light == 1 ? "sun"
                                          : "spot"}};
    };
    gltf.add_node(light_node(0, {0, 0, 4}));
    gltf.add_node(light_node(1, {0, 0, 0}));
    gltf.add_node(light_node(2, {0, 0, 4}));
    const ImportedScene imported = import(gltf);
    const Scene& scene = imported.scene;
    ASSERT_EQ(scene.lights.size(), 3U);
    const glm::mat4& fit = scene.objects[0].transform;
    const glm::vec3 middle(fit * glm::vec4(0, 0, 0, 1));
    const auto irradiance = [&](const PointLight& light) {
        const glm::vec3 away = light.position - middle;
        return light.is_sun ? light.intensity : light.intensity / glm::dot(away, away);
    };
    EXPECT_EQ(scene.lights[0].name, "lamp");
    expect_near(scene.lights[0].position, glm::vec3(fit * glm::vec4(0, 0, 4, 1)), rounding);
    expect_near(irradiance(scene.lights[0]), glm::vec3(1, 0.5F, 0.25F) * 8.0F / 16.0F, rounding);
    // Half as far again from the square as the lamp stands, in whatever metres that is here.
    EXPECT_NEAR(scene.lights[0].reach, 1.5F * glm::length(scene.lights[0].position - middle),
                1e-3F);
    EXPECT_FALSE(scene.lights[1].ends() || scene.lights[2].ends());
    expect_near(irradiance(scene.lights[1]), glm::vec3(3), 1e-3F);
    expect_near(glm::normalize(scene.lights[1].position - middle), {0, 0, 1}, rounding);
    EXPECT_TRUE(scene.lights[1].is_sun);
    EXPECT_FALSE(scene.lights[0].is_spot() || scene.lights[0].is_sun);
    EXPECT_TRUE(scene.lights[2].is_spot());
    EXPECT_NEAR(scene.lights[2].outer_angle, 0.5 * 180 / std::numbers::pi, 1e-3);
    expect_near(scene.lights[2].axis, {0, 0, -1}, rounding);
    EXPECT_NEAR(std::exp2(scene.exposure) * (0.5F + 3 + 0.125F), std::numbers::pi_v<float>, 1e-2F);
    expect_near(scene.environment.zenith * std::exp2(scene.exposure),
                studio_scene().environment.zenith, rounding);
    for (const PointLight& light : scene.lights) {
        EXPECT_TRUE(light.casts_shadow);
    }
}

TEST_F(ImportTest, drops_triangles_with_a_vertex_that_is_not_finite_and_counts_them) {
    std::vector<float> corners = square_corners();
    for (const float bad : {std::nanf(""), HUGE_VALF, 1e30F}) {
        std::vector<float> both = corners;
        both.insert(both.end(), corners.begin(), corners.end());
        both[both.size() - 1] = bad;
        GltfWriter gltf;
        gltf.add_node({{"mesh", gltf.add_mesh(both)}});
        const ImportedScene imported = import(gltf);
        EXPECT_EQ(imported.scene.meshes[0].indices.size(), 9U) << bad;
        EXPECT_TRUE(tells(imported, "1 triangles with a missing or non-finite vertex")) << bad;
        const Bounds box = imported.scene.bounds();
        EXPECT_LT(glm::length(box.max - box.min), 3.1F);
    }
}

TEST_F(ImportTest, shows_both_sides_of_a_double_sided_material) {
    GltfWriter gltf;
    gltf.add("materials", {{"doubleSided", true}});
    gltf.add_node({{"mesh", gltf.add_mesh(square_corners())}});
    const Mesh mesh = import(gltf).scene.meshes[0];
    ASSERT_EQ(mesh.indices.size(), 12U);
    float sum = 0;
    for (const std::uint32_t index : mesh.indices) {
        sum += mesh.vertices[index].normal.z;
    }
    EXPECT_EQ(sum, 0);
}

TEST_F(ImportTest, what_is_blended_lets_light_through) {
    GltfWriter gltf;
    gltf.add("materials", {{"alphaMode", "BLEND"},
                           {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.25}}}}});
    gltf.add_node({{"mesh", gltf.add_mesh(square_corners())}});
    const Scene scene = import(gltf).scene;
    EXPECT_TRUE(scene.materials[0].detail.is_blended);
    EXPECT_EQ(scene.materials[0].detail.coverage, 0.25F);
    EXPECT_FALSE(scene.objects[0].casts_shadow);
}

TEST_F(ImportTest, tells_what_it_leaves_out) {
    GltfWriter gltf;
    gltf.add("materials", {{"normalTexture", {{"index", 0}}},
                           {"extensions", {{"KHR_materials_clearcoat", json::object()}}}});
    gltf.add("images", {{"uri", "missing.png"}});
    gltf.add("textures", {{"source", 0}});
    gltf.add_node({{"mesh", gltf.add_mesh(square_corners())}});
    const ImportedScene imported = import(gltf);
    for (const char* what :
         {"1 pictures that cannot be read: ", "1 materials' KHR_materials_clearcoat"}) {
        EXPECT_TRUE(tells(imported, what)) << what;
    }
}

TEST_F(ImportTest, tells_extensions_that_a_file_requires_and_models_that_are_not_read) {
    GltfWriter gltf = one_square();
    gltf.root["extensionsRequired"] = {"KHR_technique_webgl", "KHR_mesh_quantization"};
    const ImportedScene imported = import(gltf);
    EXPECT_TRUE(tells(imported, "1 extensions that the file requires: KHR_technique_webgl"));
    EXPECT_FALSE(tells(imported, "KHR_mesh_quantization"));
    for (const char* name : {"a.FBX", "b.stl"}) {
        EXPECT_TRUE(is_model_file(name));
        EXPECT_THROW(import_scene(name), lutlib::Error);
    }
}

struct Damage {
    const char* name;
    const char* told; ///< part of the message
    void (*apply)(GltfWriter& gltf);
};
constexpr Damage damages[] = {
    {"an old version", "glTF 1.0", [](GltfWriter& g) { g.root["asset"]["version"] = "1.0"; }},
    {"no version", "asset.version", [](GltfWriter& g) { g.root.erase("asset"); }},
    {"nothing in it", "no triangle", [](GltfWriter& g) { g.root["nodes"][0].erase("mesh"); }},
    {"a view beyond its buffer", "beyond its buffer",
     [](GltfWriter& g) { g.root["bufferViews"][0]["byteLength"] = 1'000'000; }},
    {"a view whose end overflows", "beyond its buffer",
     [](GltfWriter& g) { g.root["bufferViews"][0]["byteOffset"] = UINT64_MAX - 4; }},
    {"an accessor beyond its view", "beyond its bufferView",
     [](GltfWriter& g) { g.root["accessors"][0]["count"] = 7; }},
    {"a huge accessor", "the limit",
     [](GltfWriter& g) { g.root["accessors"][0]["count"] = UINT64_MAX; }},
    {"a huge accessor of nothing", "the limit",
     [](GltfWriter& g) {
         g.root["accessors"][0].erase("bufferView");
         g.root["accessors"][0]["count"] = 4'000'000'000U;
     }},
    {"a negative count", "is not a valid count",
     [](GltfWriter& g) { g.root["accessors"][0]["count"] = -1; }},
    {"a sparse accessor of more than there is", "replaces more",
     [](GltfWriter& g) {
         g.root["accessors"][0]["sparse"] = {{"count", 7}, {"indices", {{"componentType", 5123}}}};
     }},
    {"a sparse accessor of nothing", "no indices",
     [](GltfWriter& g) {
         g.root["accessors"][0]["sparse"] = {{"count", 1}, {"indices", {{"componentType", 5123}}}};
     }},
    {"a node above itself", "cycle", [](GltfWriter& g) { g.root["nodes"][0]["children"] = {0}; }},
    {"a child that does not exist", "does not exist",
     [](GltfWriter& g) { g.root["nodes"][0]["children"] = {5}; }},
    {"a mesh that is not there", "", [](GltfWriter& g) { g.root["nodes"][0]["mesh"] = 5; }},
    {"compressed meshes", "compressed",
     [](GltfWriter& g) { g.root["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }},
    {"a buffer that is shorter than it says", "",
     [](GltfWriter& g) { g.root["accessors"][0]["count"] = 2'000; }},
    {"too many nodes", "nodes",
     [](GltfWriter& g) {
         for (std::size_t i = 0; i <= import_limits.nodes; ++i) {
             g.root["nodes"].push_back(json::object());
         }
     }},
};

TEST_F(ImportTest, refuses_a_broken_file_by_one_error_that_names_it) {
    for (const Damage& damage : damages) {
        GltfWriter gltf = one_square();
        damage.apply(gltf);
        const std::string message = refused(gltf);
        EXPECT_EQ(message.find("it was not refused"), std::string::npos) << damage.name;
        EXPECT_NE(message.find(damage.told), std::string::npos) << damage.name << ": " << message;
    }
}

TEST_F(ImportTest, refuses_what_is_no_gltf_at_all) {
    std::string deep(100'000, '[');
    const std::string binary = std::string("glTF\2\0\0\0\xff\xff\xff\0", 12);
    for (const std::string& bytes :
         {std::string("{"), std::string("[]"), std::string("null"), std::string("\x89PNG\r\n"),
          deep, binary, binary + std::string("\xff\xff\xff\xffJSON{}", 10)}) {
        lutlib::io::write_file(file("model.gltf"), bytes);
        EXPECT_EQ(refused().find("it was not refused"), std::string::npos) << bytes.substr(0, 9);
    }
    GltfWriter gltf = one_square();
    gltf.write(file("model.gltf"));
    fs::remove(file("model.bin"));
    EXPECT_NE(refused().find("model.bin"), std::string::npos);
}

TEST_F(ImportTest, survives_every_cut_of_a_file) {
    one_square().write(file("model.gltf"));
    const std::string whole = lutlib::io::read_file(file("model.gltf"));
    for (std::size_t length = 1; length + 3 < whole.size(); length += 29) {
        lutlib::io::write_file(file("model.gltf"), whole.substr(0, length));
        EXPECT_EQ(refused().find("it was not refused"), std::string::npos) << length;
    }
}

TEST_F(ImportTest, takes_or_refuses_every_model_of_a_foreign_collection) {
    const fs::path models = "/usr/share/assimp/models/glTF2";
    if (!fs::exists(models)) {
        GTEST_SKIP() << "the package assimp-testmodels is not installed";
    }
    std::size_t taken = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(models)) {
        if (!is_model_file(entry.path().string())) {
            continue;
        }
        try {
            const Scene scene = import_scene(entry.path().string()).scene;
            EXPECT_FALSE(scene.objects.empty()) << entry.path();
            const Bounds box = scene.bounds();
            EXPECT_NEAR(glm::length(box.max - box.min), 3, 0.01) << entry.path();
            ++taken;
        } catch (const lutlib::Error& error) {
            EXPECT_NE(std::string(error.what()).find(entry.path().filename().string()),
                      std::string::npos);
        }
    }
    EXPECT_GT(taken, 10U);
}

TEST_F(ImportTest, takes_the_forms_of_files_that_people_report) {
    const fs::path cases = fs::path(EXTRA_DATA) / "cases";
    if (!fs::exists(cases)) {
        GTEST_SKIP() << "LUT_EXTRA_DATA names no folder with cases";
    }
    const ImportedScene mirrored = import_scene((cases / "g2_negscale.gltf").string());
    ASSERT_FALSE(mirrored.scene.objects.empty());
    EXPECT_FALSE(import_scene((cases / "g4_quant.gltf").string()).scene.objects.empty());
    const ImportedScene spaced = import_scene((cases / "g6_space_uri.gltf").string());
    EXPECT_FALSE(spaced.scene.pictures.empty());
    EXPECT_FALSE(tells(spaced, "cannot be read"));
}

} // namespace
} // namespace preview
