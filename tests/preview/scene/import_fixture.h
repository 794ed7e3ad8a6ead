// What the tests of imports share: a folder, and small files in it.
#pragma once

#include "lutlib/error.h"
#include "preview/scene/import.h"
#include "tests/preview/scene/gltf_writer.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace preview {

class ImportTest : public testing::Test {
  protected:
    void SetUp() override {
        char name[] = "/tmp/lutpreview_import_XXXXXX";
        folder_ = mkdtemp(name);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }
    ImportedScene import(const GltfWriter& gltf) const {
        gltf.write(file("model.gltf"));
        return import_scene(file("model.gltf"));
    }
    /// The error's text.
    std::string refused(const GltfWriter& gltf) const {
        gltf.write(file("model.gltf"));
        return refused();
    }
    std::string refused() const {
        try {
            import_scene(file("model.gltf"));
        } catch (const lutlib::Error& error) {
            EXPECT_NE(std::string(error.what()).find("model.gltf"), std::string::npos)
                << error.what();
            return error.what();
        }
        return "it was not refused";
    }

    std::filesystem::path folder_;
};

inline GltfWriter one_square() {
    GltfWriter gltf;
    gltf.add_node({{"mesh", gltf.add_mesh(square_corners())}});
    return gltf;
}

inline bool tells(const ImportedScene& imported, const std::string& what) {
    for (const std::string& line : imported.left_out) {
        if (line.find(what) != std::string::npos) {
            return true;
        }
    }
    return false;
}

inline void expect_near(glm::vec3 got, glm::vec3 want, float bound) {
    EXPECT_LT(glm::length(got - want), bound) << got.x << " " << got.y << " " << got.z << ", not "
                                              << want.x << " " << want.y << " " << want.z;
}

// Float arithmetic on numbers of about 1.
inline constexpr float rounding = 1e-4F;

} // namespace preview
