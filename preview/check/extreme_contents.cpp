// The rows of extreme pictures, geometry and materials.
#include "preview/check/extreme_contents.h"

#include <algorithm>
#include <limits>

namespace preview {

namespace {

constexpr float largest_half = 65504, smallest_half = 0x1p-24F;

// ---- pictures

/// Every texel of a lattice that meets borders, corners and the middle.
void plant(ShownPicture& picture, float value) {
    const std::uint32_t steps_x = std::min(picture.size.width, 5U),
                        steps_y = std::min(picture.size.height, 5U);
    for (std::uint32_t j = 0; j < steps_y; ++j) {
        for (std::uint32_t i = 0; i < steps_x; ++i) {
            const std::size_t x = i * (picture.size.width - 1) / std::max(steps_x - 1, 1U),
                              y = j * (picture.size.height - 1) / std::max(steps_y - 1, 1U);
            std::fill_n(picture.rgba.begin() +
                            static_cast<std::ptrdiff_t>(4 * (y * picture.size.width + x)),
                        3, value);
        }
    }
}

struct PictureRow {
    std::string_view name, help;
    float value;
    bool fills; ///< all of the picture, not 25 texels
};
constexpr PictureRow picture_rows[] = {
    {"picture of NaN", "25 texels", std::numeric_limits<float>::quiet_NaN(), false},
    {"picture of +infinity", "25 texels", std::numeric_limits<float>::infinity(), false},
    {"picture of -infinity", "25 texels", -std::numeric_limits<float>::infinity(), false},
    {"picture of 65504", "sources of one texel", largest_half, false},
    {"picture of 1e38", "near the largest float", 1e38F, false},
    {"picture of denormals", "of half floats", smallest_half, true},
    {"picture of 1e-42", "denormals of floats", 1e-42F, true},
    {"picture of negative light", "-1 everywhere", -1, true},
    {"picture of 65504 everywhere", "as bright as halves go", largest_half, true},
    {"picture of black", "0 everywhere", 0, true},
};

} // namespace

void add_pictures(std::vector<Extreme>& rows) {
    for (const PictureRow& row : picture_rows) {
        rows.push_back({.name = std::string(row.name),
                        .help = std::string(row.help),
                        .change_picture =
                            [row](ShownPicture& picture) {
                                if (!row.fills) {
                                    plant(picture, row.value);
                                    return;
                                }
                                for (std::size_t at = 0; at < picture.rgba.size(); ++at) {
                                    picture.rgba[at] = at % 4 == 3 ? 1 : row.value;
                                }
                            },
                        .is_not_finite = true});
    }
}

namespace {

// ---- geometry, materials

template <class Change>
void for_each_vertex(Scene& scene, Change change) {
    for (Mesh& mesh : scene.meshes) {
        for (Vertex& vertex : mesh.vertices) {
            change(vertex);
        }
    }
}

template <class Change>
void for_each_material(Scene& scene, Change change) {
    for (Material& material : scene.materials) {
        change(material);
    }
}

/// Triangles whose corners are one point, or stand in a line.
void add_empty_triangles(Scene& scene) {
    for (Mesh& mesh : scene.meshes) {
        const std::size_t count = mesh.indices.size();
        for (std::size_t at = 0; at + 2 < count; at += 3) {
            const std::uint32_t a = mesh.indices[at], b = mesh.indices[at + 1];
            mesh.indices.insert(mesh.indices.end(), {a, a, a, a, b, a});
        }
    }
}

/// Every object twice at one place, so that each pixel has two surfaces of one depth.
void double_objects(Scene& scene) {
    scene.objects.insert(scene.objects.end(), scene.objects.begin(), scene.objects.end());
}

void flatten(Scene& scene) {
    for (Object& object : scene.objects) {
        object.transform[1] = glm::vec4(0);
    }
}

struct SceneRow {
    std::string_view name, help;
    void (*change)(Scene& scene);
};
constexpr SceneRow scene_rows[] = {
    {"roughness 0", "of every material",
     [](Scene& s) { for_each_material(s, [](Material& m) { m.roughness = 0; }); }},
    {"mirrors", "roughness 0, metal, white",
     [](Scene& s) {
         for_each_material(s, [](Material& m) {
             m.roughness = 0;
             m.metalness = 1;
             m.albedo = glm::vec3(1);
         });
     }},
    {"black surfaces", "albedo 0, roughness 1",
     [](Scene& s) {
         for_each_material(s, [](Material& m) {
             m.roughness = 1;
             m.albedo = m.emission = glm::vec3(0);
         });
     }},
    {"emission of 65504", "of every material",
     [](Scene& s) {
         for_each_material(s, [](Material& m) { m.emission = glm::vec3(largest_half); });
     }},
    {"emission of 1e30", "more than half floats hold",
     [](Scene& s) { for_each_material(s, [](Material& m) { m.emission = glm::vec3(1e30F); }); }},
    {"zero normals", "of every vertex",
     [](Scene& s) { for_each_vertex(s, [](Vertex& v) { v.normal = glm::vec3(0); }); }},
    {"NaN normals", "of every vertex",
     [](Scene& s) {
         for_each_vertex(
             s, [](Vertex& v) { v.normal = glm::vec3(std::numeric_limits<float>::quiet_NaN()); });
     }},
    {"normals turned inwards", "of every vertex",
     [](Scene& s) { for_each_vertex(s, [](Vertex& v) { v.normal = -v.normal; }); }},
    {"zero tangents", "of every vertex that has one",
     [](Scene& s) {
         for (Mesh& mesh : s.meshes) {
             for (VertexDetail& detail : mesh.details) {
                 detail.tangent = glm::vec4(0);
             }
         }
     }},
    {"triangles without area", "two more for each triangle", add_empty_triangles},
    {"coincident surfaces", "every object twice at one place", double_objects},
    {"flat objects", "scaled by 0 along their height", flatten},
    {"no object", "nothing but the surroundings", [](Scene& s) { s.objects.clear(); }},
    {"objects of a micrometre", "scaled by 1e-6",
     [](Scene& s) {
         for (Object& object : s.objects) {
             for (int column = 0; column < 3; ++column) {
                 object.transform[column] *= 1e-6F;
             }
         }
     }},
    {"objects of a megametre", "scaled by 1e6",
     [](Scene& s) {
         for (Object& object : s.objects) {
             for (int column = 0; column < 3; ++column) {
                 object.transform[column] *= 1e6F;
             }
         }
     }},
};

} // namespace

void add_scenes(std::vector<Extreme>& rows) {
    for (const SceneRow& row : scene_rows) {
        rows.push_back({.name = std::string(row.name),
                        .help = std::string(row.help),
                        .change_scene = row.change});
    }
}

} // namespace preview
