// What is converted around looks on a device, against its twin in double.
#include "preview/reference/look_conversion.h"
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

LookConversion before_tonemap(const char* fed, const char* gives, bool is_picture) {
    return {{}, *lutlib::encoding_named(fed), *lutlib::encoding_named(gives), is_picture};
}

LookConversion behind_tonemap(const char* codes, const char* fed, const char* gives) {
    return {*lutlib::encoding_named(codes), *lutlib::encoding_named(fed),
            *lutlib::encoding_named(gives), true};
}

std::string text_of(const LookConversion& conversion) {
    return (conversion.codes ? conversion.codes->name() + " as " : "light as ") +
           conversion.fed.name() + " to " + conversion.gives.name();
}

class LookConversionTest : public FinishTest {
  protected:
    static GpuLook gpu_look_of(const lutlib::Lut& table, const LookConversion& conversion,
                               const char* lookup) {
        LookData data = look_data(table, *gpu_lookup_named(lookup));
        data.conversion = conversion;
        return {device(), data};
    }

    static RgbD wanted(const lutlib::Lut& table, const LookConversion& conversion,
                       const Tonemap& tonemap, const Rgb& texel) {
        return reference::graded(lutlib::to_double(texel), conversion,
                                 lutlib::Transform::of(table, lutlib::Interpolation::trilinear),
                                 tonemap);
    }

    void expect_twin(const std::vector<Rgb>& in, const LookConversion& conversion,
                     FinishSettings settings) {
        const Tonemap& tonemap = *tonemap_named("reinhard");
        settings.tonemap = conversion.is_before() ? &tonemap : nullptr;
        const lutlib::Lut table = bent_cube(17);
        const GpuLook look = gpu_look_of(table, conversion, "trilinear");
        const std::vector<Rgb> got = finished(in, &look, settings);
        double worst = 0;
        Rgb at{};
        for (std::size_t i = 0; i < in.size(); ++i) {
            const RgbD exact = wanted(table, conversion, tonemap, in[i]);
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
        EXPECT_LE(worst, 4e-4) << text_of(conversion) << " of " << at.r << ' ' << at.g << ' '
                               << at.b;
    }
};

// A software rasteriser takes a second to compile each place.
TEST_F(LookConversionTest, before_the_tone_map_equals_its_twin_in_double_in_every_kind_of_place) {
    const std::vector<LookConversion> some{before_tonemap("acescct", "acescct", false)};
    const std::vector<LookConversion> all{some[0],
                                          before_tonemap("logc3", "srgb", true),
                                          before_tonemap("logc3", "rec709", true),
                                          before_tonemap("o3de-log2", "o3de-log2", false),
                                          before_tonemap("linear", "linear", false),
                                          before_tonemap("pq", "pq", false),
                                          before_tonemap("slog3/sgamut3.cine", "gamma24", true),
                                          before_tonemap("applelog", "linear", false)};
    for (const LookConversion& conversion : support::all_or(all, some)) {
        expect_twin(lights(), conversion, {});
    }
}

TEST_F(LookConversionTest, behind_the_tone_map_equals_its_twin_in_double_in_every_kind_of_place) {
    const std::vector<LookConversion> some{behind_tonemap("logc3", "srgb", "gamma24")};
    const std::vector<LookConversion> all{some[0], behind_tonemap("srgb", "logc3", "srgb"),
                                          behind_tonemap("srgb", "srgb", "rec709"),
                                          behind_tonemap("pq", "linear", "linear"),
                                          behind_tonemap("slog3/sgamut3.cine", "acescct", "pq")};
    std::vector<Rgb> codes;
    for (int i = 0; i <= 255; ++i) {
        const float code = static_cast<float>(i) / 255;
        codes.push_back({code, code, code});
        codes.push_back({code, 1 - code, 0});
        codes.push_back({1, code / 3, code});
    }
    for (const LookConversion& conversion : support::all_or(all, some)) {
        expect_twin(codes, conversion, {});
    }
}

TEST_F(LookConversionTest, stands_beside_one_behind_the_tone_map) {
    const lutlib::Lut table = bent_cube(9);
    const LookConversion place = before_tonemap("logc3", "srgb", true);
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
