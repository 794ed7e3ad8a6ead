// A few whole pictures at 320x180 against those that were looked at and found right
// (tests/golden/). Drivers may round differently: halves are stored truncated or rounded, edges are
// covered a texel more or less; so a picture may differ by 2 codes anywhere, and by more in 1 % of
// its texels (silhouettes, shadow edges). On failure the picture and the difference, eight times
// enlarged, lie in the build's golden folder.
#include "lutlib/io/file.h"
#include "lutlib/io/png.h"
#include "preview/cli/headless.h"
#include "preview/look/look_bake.h"
#include "tests/preview/graph/gpu_test.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace preview {
namespace {

struct Golden {
    const char* name;
    const char* scene;
    const char* compare;
    const char* tonemap;
    const char* bloom;
};

constexpr Golden goldens[] = {
    {"sample_split", "sample", "split", "agx", "glare"},
    {"materials", "materials", "a", "khronos-neutral", "none"},
    {"chart_difference", "chart", "diff", "none", "none"},
};

/// Warmer, and more saturated.
lutlib::Lut warm_look() {
    lutlib::Lut look;
    look.cube = lutlib::identity_cube(16);
    for (lutlib::Rgb& node : look.cube->nodes) {
        const float luma = 0.2126F * node.r + 0.7152F * node.g + 0.0722F * node.b;
        for (std::size_t c = 0; c < 3; ++c)
            node[c] = std::clamp(luma + 1.4F * (node[c] - luma) + (c == 0 ? 0.04F : 0) -
                                     (c == 2 ? 0.06F : 0),
                                 0.0F, 1.0F);
    }
    return look;
}

lutlib::io::PngImage code_image(const Rendered& rendered) {
    lutlib::io::PngImage image;
    image.width = static_cast<int>(rendered.size.width);
    image.height = static_cast<int>(rendered.size.height);
    image.srgb_tag = true;
    for (std::size_t at = 0; at < rendered.rgba.size(); at += 4)
        image.samples.insert(image.samples.end(), rendered.rgba.begin() + static_cast<long>(at),
                             rendered.rgba.begin() + static_cast<long>(at) + 3);
    return image;
}

using GoldenTest = GpuTest;

TEST_F(GoldenTest, pictures_look_as_they_did_when_they_were_found_right) {
    const std::filesystem::path expected_folder = LUT_GOLDEN_FOLDER;
    const std::filesystem::path failed_folder = LUT_GOLDEN_FAILED_FOLDER;
    std::filesystem::create_directories(failed_folder);
    const GpuLook look(device(), look_for(warm_look(), *gpu_lookup_named("piccolo")).data);
    Executor executor(device());
    for (const Golden& golden : goldens) {
        const Scene scene = scene_at(*scene_named(golden.scene), 0);
        const GpuScene gpu_scene(device(), scene);
        FrameInputs inputs;
        inputs.scene = &scene;
        inputs.gpu_scene = &gpu_scene;
        inputs.look_b = &look;
        FrameSettings settings;
        settings.output = {320, 180};
        settings.orbit = scene.orbit;
        settings.compare = compare_named(golden.compare);
        settings.tonemap = tonemap_named(golden.tonemap);
        settings.bloom = bloom_named(golden.bloom);
        const auto found = code_image(render_frame(executor, inputs, settings));

        const std::string file = std::string(golden.name) + ".png";
        const std::string found_path = (failed_folder / file).string();
        lutlib::io::write_file(found_path, lutlib::io::write_png(found));
        const std::string path = (expected_folder / file).string();
        if (!std::filesystem::exists(path)) {
            ADD_FAILURE() << path << " is missing; look at " << found_path;
            continue;
        }
        const auto expected = lutlib::io::read_png(lutlib::io::read_file(path), path);
        ASSERT_EQ(found.samples.size(), expected.samples.size()) << golden.name;

        auto difference = found;
        std::size_t off = 0;
        for (std::size_t at = 0; at < found.samples.size(); ++at) {
            const int distance = std::abs(int{found.samples[at]} - int{expected.samples[at]});
            off += distance > 2 ? 1 : 0;
            difference.samples[at] = static_cast<std::uint16_t>(std::min(8 * distance, 255));
        }
        const double share = static_cast<double>(off) / static_cast<double>(found.samples.size());
        if (share <= 0.01) {
            std::filesystem::remove(found_path);
            continue;
        }
        const std::string difference_path =
            (failed_folder / (std::string(golden.name) + "_difference.png")).string();
        lutlib::io::write_file(difference_path, lutlib::io::write_png(difference));
        ADD_FAILURE() << golden.name << ": " << share * 100 << " % of the codes are off by more "
                      << "than 2; see " << found_path << " and " << difference_path;
    }
}

} // namespace
} // namespace preview
