// A model's way to the screen.
#include "preview/cli/headless.h"
#include "preview/frame/shown.h"
#include "tests/preview/graph/gpu_test.h"
#include "tests/preview/scene/gltf_writer.h"

namespace preview {
namespace {

class ModelFrameTest : public GpuTest {};

TEST_F(ModelFrameTest, a_model_is_rendered_like_a_built_in_scene) {
    char name[] = "/tmp/lutpreview_import_XXXXXX";
    const std::filesystem::path folder = mkdtemp(name);
    GltfWriter gltf;
    gltf.add("materials", {{"pbrMetallicRoughness",
                            {{"baseColorFactor", {0.8, 0.1, 0.1, 1}}, {"metallicFactor", 0}}}});
    gltf.add_node({{"mesh", gltf.add_mesh(square_corners())}});
    gltf.write(folder / "model.gltf");
    const auto shown =
        std::make_shared<const Shown>(load_shown((folder / "model.gltf").string(), 0));
    std::filesystem::remove_all(folder);
    const GpuShown on_gpu(device(), shown);
    FrameSettings settings;
    settings.output = {160, 90};
    settings.orbit = shown->scene->orbit;
    settings.tonemap = tonemap_named("none");
    Executor executor(device());
    const Rendered rendered = render_frame(executor, on_gpu.inputs(), settings);
    const auto pixel = [&](std::size_t x, std::size_t y) {
        const std::size_t at = 4 * (y * 160 + x);
        return glm::vec3(rendered.rgba[at], rendered.rgba[at + 1], rendered.rgba[at + 2]);
    };
    const glm::vec3 middle = pixel(80, 45);
    EXPECT_GT(middle.r, 100);
    EXPECT_GT(middle.r, 2 * middle.g);
    const glm::vec3 corner = pixel(2, 2);
    EXPECT_LT(corner.r, 1.5F * corner.g);
}

} // namespace
} // namespace preview
