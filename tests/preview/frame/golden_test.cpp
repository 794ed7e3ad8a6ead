// A few whole pictures at 320x180 against those that were looked at and found right
// (tests/golden/). Drivers may round differently: halves are stored truncated or rounded, edges are
// covered a texel more or less; so a picture may differ by 2 codes anywhere, and by more in 1 % of
// its texels (silhouettes, shadow edges). On failure the picture and the difference, eight times
// enlarged, lie in the build's golden folder.
#include "lutlib/io/file.h"
#include "lutlib/io/png.h"
#include "preview/cli/headless.h"
#include "preview/cli/look_options.h"
#include "preview/cli/picture_file.h"
#include "preview/effects/effect.h"
#include "preview/look/gpu_look.h"
#include "preview/look/look_bake.h"
#include "preview/scene/gpu_scene.h"
#include "tests/preview/graph/gpu_test.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

namespace preview {
namespace {

struct Golden {
    const char* name;
    const char* scene;
    const char* compare;
    const char* tonemap;
    const char* bloom;
    /// No code may be off by more: about what a surface differs from what lies behind it.
    int largest = 64;
    const char* look = nullptr; ///< of side B, among the sample looks; null: a warm one
};

constexpr Golden goldens[] = {
    {"studio_split", "studio", "split", "agx", "glare"},
    {"materials", "materials", "a", "khronos-neutral", "none"},
    {"chart_difference", "chart", "diff", "none", "none"},
    {"sample_a", "sample", "a", "agx", "none", 96}, // white linen on black glass
    {"night_b", "night", "b", "agx", "glare"},
    {"exterior_a", "exterior", "a", "agx", "none"},
    // Looks that stand before the tone map, fed what they expect.
    {"log_to_display", "sample", "split", "agx", "none", 96, "log_to_display.json"},
    {"hdr_domain4", "sample", "split", "agx", "none", 96, "hdr_domain4.json"},
};

/// What drivers may make of edges: so many codes may be off by more than 2.
constexpr double most_off = 0.01;

/// Warmer, and more saturated.
lutlib::Lut warm_look() {
    lutlib::Lut look;
    look.cube = lutlib::identity_cube(16);
    for (lutlib::Rgb& node : look.cube->nodes) {
        const float luma = 0.2126F * node.r + 0.7152F * node.g + 0.0722F * node.b;
        for (std::size_t c = 0; c < 3; ++c) {
            node[c] = std::clamp(luma + 1.4F * (node[c] - luma) + (c == 0 ? 0.04F : 0) -
                                     (c == 2 ? 0.06F : 0),
                                 0.0F, 1.0F);
        }
    }
    return look;
}

LookData look_of(const Golden& golden) {
    if (golden.look == nullptr) {
        return look_for(warm_look(), *gpu_lookup_named("piccolo")).data;
    }
    Options options;
    options.look_b = std::string(LUT_LOOKS_FOLDER "/") + golden.look;
    return load_look(options.look_b, use_b(options, true)).data;
}

lutlib::io::PngImage rendered(const gpu::Device& device, const Golden& golden) {
    const GpuLook look(device, look_of(golden));
    const Scene scene = scene_at(*scene_named(golden.scene), 0);
    const GpuScene gpu_scene(device, scene);
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
    settings.bloom_settings = {-1, 1.25F, 0.25F, 1};
    settings.heat_scale = 8;
    set_usual(settings.effects, true);
    Executor executor(device);
    return code_image(render_frame(executor, inputs, settings));
}

/// How far a picture is from another of its size.
struct Distance {
    double share = 0;              ///< of the codes, those that differ by more than 2
    int largest = 0;               ///< of codes
    lutlib::io::PngImage enlarged; ///< eight times
};

Distance distance_between(const lutlib::io::PngImage& a, const lutlib::io::PngImage& b) {
    Distance out{0, 0, a};
    std::size_t off = 0;
    for (std::size_t at = 0; at < a.samples.size(); ++at) {
        const int distance = std::abs(int{a.samples[at]} - int{b.samples[at]});
        off += distance > 2 ? 1 : 0;
        out.largest = std::max(out.largest, distance);
        out.enlarged.samples[at] = static_cast<std::uint16_t>(std::min(8 * distance, 255));
    }
    out.share = static_cast<double>(off) / static_cast<double>(a.samples.size());
    return out;
}

/// Compares a picture with the golden one of that name; no code may be off by more than `largest`.
void expect_golden(const std::string& name, const lutlib::io::PngImage& found, int largest) {
    const std::filesystem::path failed_folder = LUT_GOLDEN_FAILED_FOLDER;
    std::filesystem::create_directories(failed_folder);
    const std::string found_path = (failed_folder / (name + ".png")).string();
    lutlib::io::write_file(found_path, lutlib::io::write_png(found));
    const std::string path = (std::filesystem::path(LUT_GOLDEN_FOLDER) / (name + ".png")).string();
    ASSERT_TRUE(std::filesystem::exists(path)) << path << " is missing; look at " << found_path;
    const auto expected = lutlib::io::read_png(lutlib::io::read_file(path), path);
    ASSERT_EQ(found.samples.size(), expected.samples.size());

    const Distance distance = distance_between(found, expected);
    testing::Test::RecordProperty("largest", distance.largest);
    EXPECT_LE(distance.share, most_off);
    EXPECT_LE(distance.largest, largest);
    if (!testing::Test::HasFailure()) {
        std::filesystem::remove(found_path);
        return;
    }
    const std::string difference_path = (failed_folder / (name + "_difference.png")).string();
    lutlib::io::write_file(difference_path, lutlib::io::write_png(distance.enlarged));
    ADD_FAILURE() << "see " << found_path << " and " << difference_path;
}

/// Every effect alone, some stronger than usual so that small pictures show them.
lutlib::io::PngImage sheet_of_effects(const gpu::Device& device) {
    constexpr Size tile{160, 90};
    constexpr std::size_t columns = 4;
    const std::map<std::string_view, const char*> stronger{
        {"depth-of-field", "depth-of-field:aperture=0.5,sensor=100,largest=80"},
        {"chromatic-aberration", "chromatic-aberration:corner=40"},
        {"film-grain", "film-grain:size=15"},
        {"pointillism", "pointillism:size=40"},
        {"paintbrush", "paintbrush:size=40"}};
    const Scene scene = scene_at(*scene_named("studio"), 0);
    const GpuScene gpu_scene(device, scene);
    FrameInputs inputs;
    inputs.scene = &scene;
    inputs.gpu_scene = &gpu_scene;
    FrameSettings settings;
    settings.output = tile;
    settings.orbit = scene.orbit;
    settings.bloom = bloom_named("none");
    settings.seconds = 0.5;
    Executor executor(device);
    lutlib::io::PngImage sheet;
    for (std::size_t i = 0; i < post_effects().size(); ++i) {
        const PostEffect& effect = *post_effects()[i];
        const auto found = stronger.find(effect.name);
        settings.effects = {found != stronger.end() ? parse_use(found->second) : usual_use(effect)};
        const lutlib::io::PngImage picture = code_image(render_frame(executor, inputs, settings));
        if (i == 0) {
            sheet = picture;
            const std::size_t rows = (post_effects().size() + columns - 1) / columns;
            sheet.width = static_cast<int>(columns * tile.width);
            sheet.height = static_cast<int>(rows * tile.height);
            sheet.samples.assign(picture.samples.size() * columns * rows, 0);
        }
        const std::size_t row_values = picture.samples.size() / tile.height;
        for (std::size_t y = 0; y < tile.height; ++y) {
            std::copy_n(
                picture.samples.begin() + static_cast<std::ptrdiff_t>(y * row_values), row_values,
                sheet.samples.begin() +
                    static_cast<std::ptrdiff_t>(
                        ((i / columns * tile.height + y) * columns + i % columns) * row_values));
        }
    }
    return sheet;
}

class EveryGolden : public GpuTest, public testing::WithParamInterface<Golden> {};

TEST_P(EveryGolden, looks_as_it_did_when_it_was_found_right) {
    expect_golden(GetParam().name, rendered(device(), GetParam()), GetParam().largest);
}

using GoldenEffects = GpuTest;

TEST_F(GoldenEffects, look_as_they_did_when_they_were_found_right) {
    expect_golden("effects", sheet_of_effects(device()), 64);
}

INSTANTIATE_TEST_SUITE_P(Table, EveryGolden, testing::ValuesIn(goldens),
                         [](const auto& row) { return std::string(row.param.name); });

} // namespace
} // namespace preview
