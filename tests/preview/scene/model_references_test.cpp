// Files that a model names: buffers, pictures, materials.
#include "lutlib/io/file.h"
#include "lutlib/io/references.h"
#include "preview/scene/scene.h"
#include "tests/preview/scene/import_fixture.h"

#include <sys/stat.h>

namespace preview {
namespace {

class ModelReferences : public ImportTest {
  protected:
    void TearDown() override {
        lutlib::io::allow_references_outside(false);
        ImportTest::TearDown();
    }
};

TEST_F(ModelReferences, a_picture_may_be_no_pipe_no_other_format_and_no_bomb) {
    std::string png = "\x89PNG\r\n\x1a\n";
    png += std::string("\0\0\0\rIHDR\0\0\x70\0\0\0\x70\0\x08\x02\0\0\0", 21);
    lutlib::io::write_file(file("bomb.png"), png);
    lutlib::io::write_file(file("other.png"), "FOR4    CIMG");
    lutlib::io::write_file(file("cut.jpg"), "\xff\xd8\xff\xe0");
    ASSERT_EQ(mkfifo(file("pipe.png").c_str(), 0600), 0);
    for (const auto& [name, reason] :
         {std::pair{"bomb.png", "28672 x 28672"}, std::pair{"other.png", "neither a PNG nor"},
          std::pair{"cut.jpg", "neither a PNG nor"}, std::pair{"pipe.png", "must be a file"},
          std::pair{"data:image/png;base64,Rk9SNAAA", "neither a PNG nor"}}) {
        GltfWriter gltf = one_square();
        gltf.add("images", {{"uri", name}});
        gltf.add("textures", {{"source", 0}});
        gltf.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
        gltf.root["meshes"][0]["primitives"][0]["material"] = 0;
        const ImportedScene imported = import(gltf);
        EXPECT_TRUE(tells(imported, reason)) << name;
        EXPECT_FALSE(imported.scene.has_detail());
    }
    GltfWriter gltf = one_square();
    gltf.root["buffers"] = {{{"uri", "pipe.png"}, {"byteLength", gltf.bytes.size()}}};
    lutlib::io::write_file(file("model.gltf"), gltf.root.dump());
    EXPECT_THROW(import_scene(file("model.gltf")), lutlib::Error);
}

TEST_F(ModelReferences, what_a_model_names_lies_in_its_own_folder) {
    const std::filesystem::path inner = folder_ / "inner";
    std::filesystem::create_directory(inner);
    lutlib::io::write_file(file("secret.mtl"), "newmtl red\nKd .5 .25 0\n");
    lutlib::io::write_file(file("secret.png"), "nobody may look at it");
    const std::string outside = "--allow-outside";
    GltfWriter gltf = one_square();
    gltf.add("images", {{"uri", "%2e%2e/secret.png"}});
    gltf.add("textures", {{"source", 0}});
    gltf.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    gltf.root["meshes"][0]["primitives"][0]["material"] = 0;
    gltf.write(inner / "model.gltf");
    EXPECT_TRUE(tells(import_scene(inner / "model.gltf"), outside));
    gltf.root["buffers"] = {{{"uri", "../secret.png"}, {"byteLength", gltf.bytes.size()}}};
    lutlib::io::write_file(inner / "model.gltf", gltf.root.dump());
    try {
        import_scene(inner / "model.gltf");
        FAIL() << "it was not refused";
    } catch (const lutlib::Error& error) {
        EXPECT_NE(std::string(error.what()).find(outside), std::string::npos) << error.what();
    }
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";
    lutlib::io::write_file(inner / "m.obj", "mtllib ../secret.mtl\n" + triangle);
    EXPECT_TRUE(tells(import_scene(inner / "m.obj"), outside));
    lutlib::io::write_file(inner / "m.mtl", "newmtl red\nKd .5 .25 0\nmap_Kd ../secret.png\n");
    lutlib::io::write_file(inner / "m.obj", "mtllib m.mtl\n" + triangle);
    EXPECT_TRUE(tells(import_scene(inner / "m.obj"), outside));
    lutlib::io::allow_references_outside(true);
    EXPECT_TRUE(tells(import_scene(inner / "m.obj"), "neither a PNG nor")) << "it was not read";
}

TEST_F(ModelReferences, are_told_that_a_model_may_lead_to_there_or_not) {
    GltfWriter gltf = one_square();
    gltf.add("images", {{"uri", "to%20come.png"}});
    gltf.add("images", {{"uri", "../outside.png"}});
    gltf.add("textures", {{"source", 0}});
    gltf.add("textures", {{"source", 1}});
    gltf.add("materials", {{"pbrMetallicRoughness",
                            {{"baseColorTexture", {{"index", 0}}},
                             {"metallicRoughnessTexture", {{"index", 1}}}}}});
    gltf.root["meshes"][0]["primitives"][0]["material"] = 0;
    const std::vector<std::string> within{file("model.gltf"), file("to come.png"),
                                          file("model.bin")};
    EXPECT_EQ(import(gltf).files, within);
    lutlib::io::write_file(file("m.mtl"), "newmtl red\nmap_Kd t.png\n");
    lutlib::io::write_file(file("m.obj"),
                           "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
    EXPECT_EQ(import_scene(file("m.obj")).files,
              (std::vector<std::string>{file("m.obj"), file("m.mtl"), file("t.png")}));
}

TEST_F(ModelReferences, an_obj_names_no_pipes) {
    ASSERT_EQ(mkfifo(file("m.mtl").c_str(), 0600), 0);
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";
    lutlib::io::write_file(file("m.obj"), "mtllib m.mtl\n" + triangle);
    EXPECT_TRUE(tells(import_scene(file("m.obj")), "must be a file"));
    ASSERT_EQ(mkfifo(file("t.png").c_str(), 0600), 0);
    lutlib::io::write_file(file("n.mtl"), "newmtl red\nmap_Kd t.png\n");
    lutlib::io::write_file(file("m.obj"), "mtllib n.mtl\n" + triangle);
    EXPECT_TRUE(tells(import_scene(file("m.obj")), "must be a file"));
}

} // namespace
} // namespace preview
