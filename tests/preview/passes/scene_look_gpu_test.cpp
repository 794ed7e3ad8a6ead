// Looks before the tone map on a device against their twin in double.
#include "preview/reference/scene_look.h"
#include "tests/preview/passes/finish_fixture.h"
#include "tests/support/thorough.h"

namespace preview {
namespace {

using lutlib::Rgb;
using lutlib::RgbD;

/// Mixes channels, and bends.
lutlib::Lut bent_cube(int size) {
    lutlib::Lut look;
    look.cube = lutlib::identity_cube(size);
    for (Rgb& node : look.cube->nodes) {
        node = {0.9F * node.r + 0.08F * node.g * node.b, 0.06F + 0.85F * node.g,
                0.1F * node.r + 0.8F * node.b * node.b + 0.05F};
    }
    return look;
}

std::vector<Rgb> lights() {
    std::vector<Rgb> out{{0, 0, 0}, {65504, 65504, 65504}, {1e-9F, 0, 1e-6F}};
    for (int i = -12 * 16; i <= 12 * 16; ++i) {
        const float light = std::exp2(static_cast<float>(i) / 16);
        out.push_back({light, light, light});
        out.push_back({light, light / 3, 0});
        out.push_back({0, light / 7, light});
    }
    return out;
}

struct Place {
    const char* fed;
    const char* gives;
    bool is_picture;
};

class SceneLookTest : public FinishTest {
  protected:
    static GpuLook gpu_look_of(const lutlib::Lut& table, const Place& place, const char* lookup) {
        LookData data = look_data(table, *gpu_lookup_named(lookup));
        data.scene = {*lutlib::encoding_named(place.fed), *lutlib::encoding_named(place.gives),
                      place.is_picture};
        return {device(), data};
    }

    static RgbD wanted(const lutlib::Lut& table, const Place& place, const Tonemap& tonemap,
                       const Rgb& light) {
        return reference::graded_light(
            lutlib::to_double(light), *lutlib::encoding_named(place.fed),
            *lutlib::encoding_named(place.gives),
            lutlib::Transform::of(table, lutlib::Interpolation::trilinear),
            place.is_picture ? nullptr : &tonemap);
    }
};

TEST_F(SceneLookTest, equals_its_twin_in_double_in_every_kind_of_place) {
    const lutlib::Lut table = bent_cube(17);
    const std::vector<Rgb> in = lights();
    FinishSettings settings;
    settings.tonemap = tonemap_named("reinhard");
    const std::vector<Place> some{{"acescct", "acescct", false}};
    const std::vector<Place> all{some[0],
                                 {"logc3", "srgb", true},
                                 {"logc3", "rec709", true},
                                 {"o3de-log2", "o3de-log2", false},
                                 {"linear", "linear", false},
                                 {"pq", "pq", false},
                                 {"slog3/sgamut3.cine", "gamma24", true},
                                 {"applelog", "linear", false}};
    // A software rasteriser takes a second to compile each.
    for (const Place& place : support::all_or(all, some)) {
        const GpuLook look = gpu_look_of(table, place, "trilinear");
        const std::vector<Rgb> got = finished(in, &look, settings);
        double worst = 0;
        Rgb at{};
        for (std::size_t i = 0; i < in.size(); ++i) {
            const RgbD exact = wanted(table, place, *settings.tonemap, in[i]);
            for (std::size_t c = 0; c < 3; ++c) {
                const double error = std::abs(static_cast<double>(got[i][c]) - exact[c]);
                if (!(error <= worst)) {
                    worst = error;
                    at = in[i];
                }
            }
        }
        // A tenth of an 8-bit code: floats before a slope of 17 (an encoding at black) and a tone
        // map.
        EXPECT_LE(worst, 4e-4) << place.fed << " to " << place.gives << " of " << at.r << ' '
                               << at.g << ' ' << at.b;
    }
}

TEST_F(SceneLookTest, stands_beside_one_behind_the_tone_map) {
    const lutlib::Lut table = bent_cube(9);
    const Place place{"logc3", "srgb", true};
    const GpuLook before = gpu_look_of(table, place, "trilinear");
    const GpuLook after(device(), look_data(table, *gpu_lookup_named("trilinear")));
    const std::vector<Rgb> in(std::size_t{64} * 4, Rgb{3, 0.2F, 0.02F});
    const gpu::Image image = image_of(in, 64);
    FinishSettings settings;
    settings.tonemap = tonemap_named("reinhard");
    settings.compare = &compare_side;
    settings.format = Format::rgba32f;
    Graph graph;
    const ImageHandle source = graph.import("lights", image, image.desc());
    const ImageHandle out = add_finish(graph, {source, {}, &after, &before, settings}).picture;
    graph.present(out);
    const std::vector<Rgb> got = colors_of(run_and_read<float>(graph, out));
    const RgbD early = wanted(table, place, *settings.tonemap, in[0]);
    const RgbD late = lutlib::Transform::of(table, lutlib::Interpolation::trilinear)(
        settings.tonemap->apply(lutlib::to_double(in[0])));
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(static_cast<double>(got[0][c]), late[c], 1e-4);
        EXPECT_NEAR(static_cast<double>(got[64][c]), early[c], 1e-4);
    }
}

} // namespace
} // namespace preview
