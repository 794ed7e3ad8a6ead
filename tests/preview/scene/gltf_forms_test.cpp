// The forms in which exporters write glTF: each gives the scene that the plain form gives.
#include "lutlib/io/file.h"
#include "lutlib/io/png.h"
#include "preview/scene/scene.h"
#include "tests/preview/scene/import_fixture.h"

#include <cmath>
#include <numbers>

namespace preview {
namespace {

using json = nlohmann::json;

constexpr int i8 = 5120, u8 = 5121, u16 = 5123, f32 = 5126;

/// A square of four corners, with its positions by this accessor.
GltfWriter quad(GltfWriter gltf, std::size_t positions, json attributes = json::object()) {
    const std::size_t indices =
        gltf.add_accessor(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, "SCALAR", 1, u16);
    attributes["POSITION"] = positions;
    json primitive = {{"attributes", attributes}, {"indices", indices}};
    if (gltf.root.contains("materials")) {
        primitive["material"] = 0;
    }
    const std::size_t mesh = gltf.add("meshes", {{"primitives", json::array({primitive})}});
    gltf.add_node({{"mesh", mesh}});
    return gltf;
}

const std::vector<float> corners{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};

GltfWriter plain_quad(GltfWriter gltf = {}, json attributes = json::object()) {
    const std::size_t positions = gltf.add_accessor(corners, "VEC3", 3, f32);
    return quad(std::move(gltf), positions, std::move(attributes));
}

/// Corners of the triangles where they stand.
std::vector<glm::vec3> places(const Scene& scene) {
    std::vector<glm::vec3> out;
    for (const Object& object : scene.objects) {
        const Mesh& mesh = scene.meshes[object.mesh];
        for (const std::uint32_t index : mesh.indices) {
            out.emplace_back(object.transform * glm::vec4(mesh.vertices[index].position, 1));
        }
    }
    return out;
}

void expect_same_places(const ImportedScene& got, const ImportedScene& want, float bound) {
    const std::vector<glm::vec3> a = places(got.scene), b = places(want.scene);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        expect_near(a[i], b[i], bound);
    }
    EXPECT_TRUE(got.left_out.empty()) << got.left_out.front();
}

TEST_F(ImportTest, a_sparse_accessor_replaces_elements_of_another_or_of_zeros) {
    for (const bool has_base : {true, false}) {
        GltfWriter gltf;
        std::vector<float> wrong = corners;
        for (std::size_t i = 3; i < wrong.size(); ++i) {
            wrong[i] = 7;
        }
        const std::size_t positions = gltf.add_accessor(wrong, "VEC3", 3, f32);
        std::vector<float> all = corners;
        const std::size_t first = has_base ? 1 : 0;
        const std::size_t values = gltf.add_view(all.data() + 3 * first, (4 - first) * 12);
        const std::vector<std::uint8_t> numbers{0, 1, 2, 3};
        const std::size_t indices = gltf.add_view(numbers.data() + first, 4 - first);
        json& accessor = gltf.root["accessors"][positions];
        accessor["sparse"] = {{"count", 4 - first},
                              {"indices", {{"bufferView", indices}, {"componentType", u8}}},
                              {"values", {{"bufferView", values}}}};
        if (!has_base) {
            accessor.erase("bufferView");
        }
        // Views are of any bytes, and indices need no alignment of four.
        expect_same_places(import(quad(gltf, positions)), import(plain_quad()), rounding);
    }
}

TEST_F(ImportTest, quantized_positions_and_normals_are_those_of_the_plain_file) {
    GltfWriter gltf;
    const std::size_t positions = gltf.add_accessor(
        std::vector<std::uint16_t>{0, 0, 0, 65535, 0, 0, 65535, 65535, 0, 0, 65535, 0}, "VEC3", 3,
        u16);
    gltf.root["accessors"][positions]["normalized"] = true;
    const std::size_t normals = gltf.add_accessor(
        std::vector<std::int8_t>{0, 0, 127, 0, 0, 127, 0, 0, 127, 0, 0, 127}, "VEC3", 3, i8);
    gltf.root["accessors"][normals]["normalized"] = true;
    gltf.root["extensionsRequired"] = {"KHR_mesh_quantization"};
    gltf = quad(gltf, positions, {{"NORMAL", normals}});
    gltf.root["nodes"][0]["scale"] = {2, 2, 2};
    gltf.root["nodes"][0]["translation"] = {-1, -1, 0};
    const ImportedScene imported = import(gltf);
    expect_same_places(imported, import(plain_quad()), rounding);
    expect_near(imported.scene.meshes[0].vertices[0].normal, {0, 0, 1}, rounding);
}

TEST_F(ImportTest, buffers_may_be_data_uris_or_files_whose_names_are_percent_encoded) {
    const ImportedScene expected = import(plain_quad());
    GltfWriter gltf = plain_quad();
    gltf.root["buffers"] = {{{"uri", gltf.data_uri()}, {"byteLength", gltf.bytes.size()}}};
    lutlib::io::write_file(file("model.gltf"), gltf.root.dump());
    expect_same_places(import_scene(file("model.gltf")), expected, 0.0F + rounding);
    lutlib::io::write_file(file("a b\xc3\xa9%.bin"), gltf.bytes);
    gltf.root["buffers"][0]["uri"] = "a%20b%C3%A9%25.bin";
    lutlib::io::write_file(file("model.gltf"), gltf.root.dump());
    expect_same_places(import_scene(file("model.gltf")), expected, 0.0F + rounding);
    for (const char* bad : {"data:application/octet-stream;base64,A*", "data:text/plain,abc",
                            "http://example.org/a.bin", "nothing%2"}) {
        gltf.root["buffers"][0]["uri"] = bad;
        lutlib::io::write_file(file("model.gltf"), gltf.root.dump());
        EXPECT_THROW(import_scene(file("model.gltf")), lutlib::Error) << bad;
    }
}

TEST_F(ImportTest, strips_and_fans_are_the_triangles_that_they_stand_for) {
    for (const int mode : {5, 6}) {
        GltfWriter gltf = plain_quad();
        json& primitive = gltf.root["meshes"][0]["primitives"][0];
        primitive["mode"] = mode;
        const std::vector<std::uint8_t> order = mode == 5 ? std::vector<std::uint8_t>{0, 1, 3, 2}
                                                          : std::vector<std::uint8_t>{0, 1, 2, 3};
        primitive["indices"] = gltf.add_accessor(order, "SCALAR", 1, u8);
        const Scene scene = import(gltf).scene;
        ASSERT_EQ(scene.meshes[0].indices.size(), 6U);
        for (const Vertex& vertex : scene.meshes[0].vertices) {
            expect_near(vertex.normal, {0, 0, 1}, rounding);
        }
    }
}

TEST_F(ImportTest, a_skin_stands_in_its_bind_pose_wherever_its_node_is) {
    GltfWriter gltf;
    const std::size_t joints = gltf.add_accessor(
        std::vector<std::uint8_t>{0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, "VEC4", 4, u8);
    const std::size_t weights = gltf.add_accessor(
        std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, .5F, .5F, 0, 0, 0, 1, 0, 0}, "VEC4", 4, f32);
    gltf = plain_quad(gltf, {{"JOINTS_0", joints}, {"WEIGHTS_0", weights}});
    std::vector<float> bound(32, 0);
    for (const std::size_t at : {0U, 5U, 10U, 15U, 16U, 21U, 26U, 31U}) {
        bound[at] = 1;
    }
    bound[16 + 12] = -3; // the second joint was at x = 3
    const std::size_t matrices = gltf.add_accessor(bound, "MAT4", 16, f32);
    gltf.add_node({{"name", "root"}});
    gltf.add_node({{"translation", {5, 0, 0}}}); // and is at 5: two further
    gltf.add("skins", {{"joints", {1, 2}}, {"inverseBindMatrices", matrices}});
    gltf.root["nodes"][0]["skin"] = 0;
    gltf.root["nodes"][0]["translation"] = {100, 100, 100};
    const ImportedScene imported = import(gltf);
    EXPECT_TRUE(tells(imported, "1 skins"));
    const Mesh& mesh = imported.scene.meshes[0];
    Bounds box = bounds_of(mesh);
    expect_near(box.min, {-1, -1, 0}, rounding);
    expect_near(box.max, {2, 1, 0}, rounding); // 1 and half of 2
    gltf.root["skins"][0]["joints"] = {1, 9};
    EXPECT_NE(refused(gltf).find("joint"), std::string::npos);
    gltf.root["skins"][0]["joints"] = {1};
    EXPECT_NE(refused(gltf).find("joint"), std::string::npos);
}

TEST_F(ImportTest, textures_come_with_their_samplers_transforms_and_sets_of_coordinates) {
    lutlib::io::PngImage image;
    image.width = 2;
    image.height = 1;
    image.samples = {255, 255, 255, 0, 64, 0};
    lutlib::io::write_file(file("my half.png"), lutlib::io::write_png(image));
    GltfWriter gltf;
    gltf.add("images", {{"uri", "my%20half.png"}});
    gltf.add("samplers",
             {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9985}});
    gltf.add("textures", {{"source", 0}, {"sampler", 0}});
    gltf.add("textures", {{"source", 0}});
    gltf.add("materials", {{"pbrMetallicRoughness",
                            {{"baseColorTexture",
                              {{"index", 0},
                               {"extensions",
                                {{"KHR_texture_transform",
                                  {{"offset", {.25, .5}},
                                   {"rotation", std::numbers::pi / 2},
                                   {"scale", {2, 4}},
                                   {"texCoord", 3}}}}}}}}},
                           {"normalTexture", {{"index", 1}, {"scale", .5}}},
                           {"occlusionTexture", {{"index", 1}, {"strength", .25}, {"texCoord", 3}}},
                           {"alphaMode", "MASK"},
                           {"alphaCutoff", .25}});
    const std::size_t uv0 =
        gltf.add_accessor(std::vector<float>{0, 1, 1, 1, 1, 0, 0, 0}, "VEC2", 2, f32);
    const std::size_t uv3 =
        gltf.add_accessor(std::vector<std::uint8_t>{0, 255, 255, 255, 255, 0, 0, 0}, "VEC2", 2, u8);
    gltf.root["accessors"][uv3]["normalized"] = true;
    const std::size_t colors = gltf.add_accessor(
        std::vector<std::uint8_t>{255, 0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0}, "VEC3", 3, u8);
    gltf.root["accessors"][colors]["normalized"] = true;
    gltf = plain_quad(gltf, {{"TEXCOORD_0", uv0}, {"TEXCOORD_3", uv3}, {"COLOR_0", colors}});
    const ImportedScene imported = import(gltf);
    EXPECT_TRUE(imported.left_out.empty()) << imported.left_out.front();
    const Scene& scene = imported.scene;
    ASSERT_TRUE(scene.has_detail());
    ASSERT_EQ(scene.pictures.size(), 1U);
    EXPECT_EQ(scene.pictures[0].rgba,
              (std::vector<std::uint8_t>{255, 255, 255, 255, 0, 64, 0, 255}));
    const MaterialDetail& detail = scene.materials[0].detail;
    const Texture& base = scene.textures[detail.base.texture];
    EXPECT_TRUE(base.is_color);
    EXPECT_EQ(base.wrap_u, Wrap::clamp);
    EXPECT_EQ(base.wrap_v, Wrap::mirror);
    EXPECT_FALSE(base.is_smooth_near);
    EXPECT_TRUE(base.is_smooth_far);
    EXPECT_EQ(base.mips, Mips::nearest);
    EXPECT_FALSE(scene.textures[detail.normal.texture].is_color);
    // The extension's own example of a place: offset + rotation of the scaled (1, 0) and (0, 1).
    expect_near(detail.base.u_row, {0, 4, .25F}, rounding);
    expect_near(detail.base.v_row, {-2, 0, .5F}, rounding);
    EXPECT_EQ(detail.base.uv_set, detail.occlusion.uv_set);
    EXPECT_NE(detail.base.uv_set, detail.normal.uv_set);
    EXPECT_EQ(detail.normal_scale, .5F);
    EXPECT_EQ(detail.occlusion_strength, .25F);
    EXPECT_EQ(detail.least_coverage, .25F);
    const Mesh& mesh = scene.meshes[0];
    ASSERT_EQ(mesh.details.size(), mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const VertexDetail& vertex = mesh.details[i];
        const glm::vec3& at = mesh.vertices[i].position;
        for (const glm::vec2& uv : vertex.uv) {
            EXPECT_NEAR(uv.x, (at.x + 1) / 2, rounding);
            EXPECT_NEAR(uv.y, (1 - at.y) / 2, rounding);
        }
        EXPECT_EQ(vertex.color, glm::vec4(1, 0, 0, 1));
        // u grows to the right, and the picture's top is up.
        expect_near(glm::vec3(vertex.tangent), {1, 0, 0}, rounding);
        EXPECT_EQ(vertex.tangent.w, 1);
    }
}

TEST_F(ImportTest, a_mirrored_picture_has_tangents_of_the_other_hand) {
    lutlib::io::PngImage image;
    image.width = image.height = 1;
    image.samples = {128, 128, 255};
    lutlib::io::write_file(file("n.png"), lutlib::io::write_png(image));
    GltfWriter gltf;
    gltf.add("images", {{"uri", "n.png"}});
    gltf.add("textures", {{"source", 0}});
    gltf.add("materials", {{"normalTexture", {{"index", 0}}}, {"doubleSided", true}});
    const std::size_t uv =
        gltf.add_accessor(std::vector<float>{1, 1, 0, 1, 0, 0, 1, 0}, "VEC2", 2, f32);
    gltf = plain_quad(gltf, {{"TEXCOORD_0", uv}});
    const Mesh mesh = import(gltf).scene.meshes[0];
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const float side = mesh.vertices[i].normal.z; // the back's frame is turned round as a whole
        expect_near(glm::vec3(mesh.details[i].tangent), {-side, 0, 0}, rounding);
        EXPECT_EQ(mesh.details[i].tangent.w, -side);
    }
}

TEST_F(ImportTest, cameras_that_see_nothing_are_left_out_and_said) {
    GltfWriter gltf = one_square();
    for (const double field : {0.0, -0.5, 3.2}) {
        gltf.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", field}}}});
    }
    gltf.add("cameras", {{"type", "orthographic"}, {"orthographic", {{"xmag", 2}, {"ymag", 0}}}});
    gltf.add("cameras",
             {{"name", "good"}, {"type", "perspective"}, {"perspective", {{"yfov", .5}}}});
    for (int camera = 0; camera < 5; ++camera) {
        gltf.add_node({{"camera", camera}, {"translation", {0, 0, 6}}});
    }
    const ImportedScene imported = import(gltf);
    ASSERT_EQ(imported.scene.cameras.size(), 1U);
    EXPECT_EQ(imported.scene.cameras[0].name, "good");
    EXPECT_TRUE(tells(imported, "3 perspective cameras whose yfov"));
    EXPECT_TRUE(tells(imported, "1 orthographic cameras whose ymag is 0"));
}

TEST_F(ImportTest, a_mesh_far_from_the_origin_keeps_its_shape) {
    constexpr float away = 1 << 22; // where floats still hold halves
    std::vector<float> moved = corners;
    for (std::size_t x = 0; x < moved.size(); x += 3) {
        moved[x] += away;
    }
    GltfWriter far;
    const std::size_t positions = far.add_accessor(moved, "VEC3", 3, f32);
    expect_same_places(import(quad(std::move(far), positions, json::object())),
                       import(plain_quad()), rounding);
}

TEST_F(ImportTest, names_of_a_file_never_reach_the_terminal_raw) {
    GltfWriter gltf = one_square();
    const std::string bad = "\x1b]0;owned\x07\x1b[31m\xc2\x9b";
    gltf.add("materials", {{"extensions", {{bad, json::object()}}}});
    gltf.root["nodes"][0]["extensions"][bad] = json::object();
    gltf.root["extensionsUsed"] = {"KHR_lights_punctual"};
    gltf.root["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"name", bad}}};
    gltf.add("cameras", {{"name", bad}, {"type", "perspective"}});
    gltf.add("images", {{"uri", "no" + bad + ".png"}});
    gltf.add("textures", {{"source", 0}});
    gltf.root["materials"][0]["normalTexture"] = {{"index", 0}};
    gltf.add_node({{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    const ImportedScene imported = import(gltf);
    std::string all;
    for (const std::string& line : imported.left_out) {
        all += line;
    }
    all += imported.scene.lights.at(0).name + imported.scene.cameras.at(0).name;
    EXPECT_EQ(all.find('\x1b'), std::string::npos) << all;
    EXPECT_EQ(all.find('\x07'), std::string::npos);
    EXPECT_EQ(all.find('\x9b'), std::string::npos);
    EXPECT_NE(all.find("owned"), std::string::npos);
    gltf.root["asset"]["version"] = bad;
    EXPECT_EQ(refused(gltf).find('\x1b'), std::string::npos);
}

TEST_F(ImportTest, an_obj_comes_with_its_materials) {
    lutlib::io::PngImage image;
    image.width = image.height = 1;
    image.samples = {10, 20, 30};
    lutlib::io::write_file(file("t.png"), lutlib::io::write_png(image));
    lutlib::io::write_file(file("m.mtl"), "newmtl red\nKd .5 .25 0\nNs 98\nnewmtl pic\nKd 1 1 1\n"
                                          "map_Kd t.png\n");
    lutlib::io::write_file(file("m.obj"),
                           "mtllib m.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\n"
                           "vt 1 1\nvt 0 1\nusemtl red\nf 1 2 3 4\nusemtl pic\n"
                           "f 1/1 2/2 3/3 4/4\n");
    const Scene scene = import_scene(file("m.obj")).scene;
    ASSERT_EQ(scene.objects.size(), 2U);
    const Material& red = scene.materials[scene.objects[0].material];
    expect_near(red.albedo, {.5F, .25F, 0}, rounding);
    EXPECT_NEAR(red.roughness, std::pow(.02F, .25F), rounding); // alpha^2 = 2 / (98 + 2)
    const Material& pic = scene.materials[scene.objects[1].material];
    ASSERT_NE(pic.detail.base.texture, TextureUse::none);
    const Mesh& mesh = scene.meshes[scene.objects[1].mesh];
    ASSERT_EQ(mesh.details.size(), mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        EXPECT_NEAR(mesh.details[i].uv[0].y, (1 - mesh.vertices[i].position.y) / 2, rounding);
    }
    lutlib::io::write_file(file("alone.obj"),
                           "mtllib not\x1bthere.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const ImportedScene alone = import_scene(file("alone.obj"));
    ASSERT_EQ(alone.left_out.size(), 1U);
    EXPECT_NE(alone.left_out[0].find("1 material libraries that cannot be read"), std::string::npos)
        << alone.left_out[0];
    EXPECT_NE(alone.left_out[0].find(R"(not\x1bthere.mtl)"), std::string::npos)
        << alone.left_out[0];
    lutlib::io::write_file(file("bad.obj"), "f 1 2 3\n");
    EXPECT_THROW(import_scene(file("bad.obj")), lutlib::Error);
}

} // namespace
} // namespace preview
