// The parts of import_scene().
#pragma once

#include "preview/scene/import.h"
#include "preview/scene/printable.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace preview {

/// A coordinate beyond it is as good as infinite: its place is nowhere, and squares of areas must
/// be floats.
inline constexpr float most_coordinate = 1e9F;

/// What is left out, counted.
class LeftOut {
  public:
    void add(const std::string& what, std::size_t count = 1) {
        if (count > 0) {
            counts_[what] += count;
        }
    }
    std::vector<std::string> lines() const;

  private:
    std::map<std::string, std::size_t> counts_;
};

/// A mesh as files have it: an attribute is empty or as long as `positions`.
struct GivenMesh {
    std::string name;
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> uv[2];
    std::vector<glm::vec4> colors, tangents;
    std::vector<std::uint32_t> indices; ///< three a triangle; may point anywhere
    bool is_double_sided = false;
    bool needs_tangents = false;  ///< made from `tangent_uv` where they are not given
    std::uint32_t tangent_uv = 0; ///< 0 or 1
};

/// Triangles without an area, or with a vertex that is no place, are left out; normals that are
/// missing or no direction become the triangle's own. Double-sided ones get a back.
Mesh mesh_of(const GivenMesh& given, LeftOut& left_out);

/// Throws lutlib::Error for what is no PNG or JPEG within import_limits. `file` is for messages.
Picture picture_of(std::string_view bytes, const std::string& file);

/// In the file's world; it looks along its -z.
struct FileCamera {
    std::string name;
    glm::mat4 place{1};
    float vertical_field = 0; ///< of view, radians; 0: orthographic
    float half_height = 1;    ///< of an orthographic view
};

struct FileLight {
    enum class Kind : std::uint8_t { point, spot, sun };
    std::string name;
    Kind kind = Kind::point;
    glm::mat4 place{1};     ///< it shines along its -z
    glm::vec3 intensity{1}; ///< candela, or lux of a sun; taken as radiance times m^2 and radiance
    float inner_angle = 0, outer_angle = 0; ///< half angles of a spot's cone, radians
    float range = 0;                        ///< where it ends, in the file's metres; 0: nowhere
};

/// A file's scene in its own world.
struct FileScene {
    Scene scene;
    std::vector<FileCamera> cameras;
    std::vector<FileLight> lights;
};

/// Carries it to where the built-in scene stands, with camera, lights, surroundings and exposure.
/// Throws lutlib::Error when there is nothing to show; `path` is for messages.
Scene settled(FileScene file, const std::string& path, LeftOut& left_out);

/// An OBJ file, whose bytes these are.
FileScene obj_scene(const std::string& bytes, const std::string& path, const ReadFile& read,
                    LeftOut& left_out);

} // namespace preview
