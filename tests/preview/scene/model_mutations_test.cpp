// Damaged models: a scene, or one sentence that names the file, and the program goes on.
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/terminal.h"
#include "preview/scene/import.h"
#include "tests/preview/scene/import_fixture.h"
#include "tests/support/mutations.h"

#include <chrono>

namespace preview {
namespace {

const std::string triangles = "mtllib m.mtl\nv -1 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0\nv 0 1 1\n"
                              "vt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\no part\ng a b\nusemtl red\n"
                              "f 1/1/1 2/2/1 3/3/1\nf 1 2 3 4\nl 1 2\np 1\ns 1\nf -1 -2 -3\n";

struct Model {
    const char* file;
    std::string bytes;
};

std::vector<Model> models() {
    std::vector<Model> out{{"m.obj", triangles}};
    for (const char* const name : {"skin.glb", "texture.gltf"}) {
        const auto path = std::filesystem::path(FUZZ_MODELS) / name;
        out.push_back({name, lutlib::io::read_file(path.string())});
    }
    return out;
}

TEST_F(ImportTest, mutations_of_models_are_shown_or_refused) {
    lutlib::io::write_file(file("m.mtl"), "newmtl red\nKd 1 0 0\nNs 30\nd 0.5\nmap_Kd m.png\n");
    for (const Model& model : models()) {
        for (std::size_t number = 0; number < support::mutations_to_try(); ++number) {
            const support::Mutated mutated = support::mutated(model.bytes, number);
            SCOPED_TRACE(std::string(model.file) + ", mutation " + std::to_string(number) + ": " +
                         mutated.names);
            lutlib::io::write_file(file(model.file), mutated.bytes);
            std::string said;
            const auto start = std::chrono::steady_clock::now();
            try {
                const ImportedScene imported = import_scene(file(model.file));
                EXPECT_FALSE(imported.scene.objects.empty());
                for (const std::string& line : imported.left_out) {
                    EXPECT_EQ(support::problem_of(line), "") << line;
                }
            } catch (const lutlib::Error& error) {
                said = error.what();
                EXPECT_NE(said.find(model.file), std::string::npos) << said;
                EXPECT_EQ(support::problem_of(lutlib::io::shown_text(said)), "") << said;
            }
            const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
            EXPECT_LT(took.count(), 60);
            if (HasFailure()) {
                return;
            }
        }
    }
}

TEST_F(ImportTest, mutations_of_material_libraries_are_shown_or_refused) {
    lutlib::io::write_file(file("m.obj"), triangles);
    const std::string library = "newmtl red\nKd 1 0 0\nKe 0 0 1\nNs 30\nd 0.5\nTr 0.2\n"
                                "map_Kd -s 1 1 1 m.png\nmap_Bump b.png\nnewmtl blue\nKd 0 0 1\n";
    for (std::size_t number = 0; number < support::mutations_to_try() / 4; ++number) {
        const support::Mutated mutated = support::mutated(library, number);
        SCOPED_TRACE("mutation " + std::to_string(number) + ": " + mutated.names);
        lutlib::io::write_file(file("m.mtl"), mutated.bytes);
        try {
            EXPECT_FALSE(import_scene(file("m.obj")).scene.objects.empty());
        } catch (const lutlib::Error& error) {
            EXPECT_NE(std::string(error.what()).find("m.obj"), std::string::npos) << error.what();
        }
    }
}

} // namespace
} // namespace preview
