// The finishing passes on a device against their oracles in double.
#include "lutlib/color/difference.h"
#include "lutlib/color/transfer.h"
#include "preview/reference/bloom.h"
#include "tests/preview/passes/finish_fixture.h"
#include "tests/support/names.h"

#include <string>

namespace preview {
namespace {

using lutlib::Rgb;
using lutlib::RgbD;
using reference::Image;

template <class Row>
std::vector<const Row*> rows_of(std::span<const Row> table) {
    std::vector<const Row*> rows;
    for (const Row& row : table) {
        rows.push_back(&row);
    }
    return rows;
}

class EveryTonemapOnGpu : public FinishTest, public testing::WithParamInterface<const Tonemap*> {};

TEST_P(EveryTonemapOnGpu, equals_its_twin_in_double) {
    std::vector<Rgb> lights = test_colors(8);
    for (int i = -300; i <= 320; ++i) {
        const float light = std::exp2(static_cast<float>(i) / 20);
        lights.push_back({light, light, light});
        lights.push_back({light, 0, light / 3});
    }
    FinishSettings settings;
    settings.tonemap = GetParam();
    for (const float exposure : {0.0F, -2.5F}) {
        settings.exposure = exposure;
        const std::vector<Rgb> got = finished(lights, nullptr, settings);
        double worst = 0;
        std::size_t at = 0;
        for (std::size_t i = 0; i < lights.size(); ++i) {
            // The picture is sanitised before exposure is applied.
            const RgbD light = lutlib::to_double(lights[i]) * std::exp2(exposure);
            const RgbD wanted = GetParam()->apply(light);
            for (std::size_t c = 0; c < 3; ++c) {
                const double error = std::abs(static_cast<double>(got[i][c]) - wanted[c]);
                if (!(error <= worst)) {
                    worst = error;
                    at = i;
                }
            }
        }
        // The slope of the encoding at black, 12.92, times the rounding of sums of float products,
        // and the shader's pow and log2: a fiftieth of an 8-bit code.
        EXPECT_LE(worst, 8e-5) << lights[at].r << ' ' << lights[at].g << ' ' << lights[at].b;
    }
}

INSTANTIATE_TEST_SUITE_P(Table, EveryTonemapOnGpu, testing::ValuesIn(rows_of(tonemaps())),
                         [](const auto& row) { return support::test_name(row.param->name); });

// Lights of all sizes on a dim ramp, in half floats so that the device starts from the same values.
Image night(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            image.at(x, y) = {x / 256.0, y / 256.0, 0.125};
        }
    }
    image.at(width / 2, height / 2) = {60000, 30000, 8000};
    image.at(width / 5, height / 3) = {4, 9, 2};
    for (int y = height / 2; y < height / 2 + 4 && y < height; ++y) {
        for (int x = 3 * width / 4; x < 3 * width / 4 + 9 && x < width; ++x) {
            image.at(x, y) = {2.5, 1.5, 6};
        }
    }
    return image;
}

class EveryBloomOnGpu : public FinishTest, public testing::WithParamInterface<const Bloom*> {
  protected:
    // The light after bloom: the finishing pass without a tone map knows only display-encoded
    // pictures, so what `none` encodes is decoded again.
    static std::vector<RgbD> run(const Image& picture, const BloomPlan& plan, float exposure,
                                 bool fuses = true) {
        const gpu::Image image = image_of(picture);
        FinishSettings settings;
        settings.tonemap = tonemap_named("none");
        settings.exposure = exposure;
        settings.format = Format::rgba32f;
        Graph graph;
        const ImageHandle source = graph.import("night", image, image.desc());
        const Bloomed bloomed = add_bloom(graph, source, plan, {.fuses = fuses});
        const ImageHandle out =
            add_finish(graph, {source, bloomed, nullptr, nullptr, settings}).picture;
        graph.present(out);
        std::vector<RgbD> light;
        for (const Rgb& c : colors_of(run_and_read<float>(graph, out))) {
            const double scale = std::exp2(-static_cast<double>(exposure));
            light.push_back({scale * lutlib::srgb_decode(static_cast<double>(c.r)),
                             scale * lutlib::srgb_decode(static_cast<double>(c.g)),
                             scale * lutlib::srgb_decode(static_cast<double>(c.b))});
        }
        return light;
    }
};

struct BloomRun {
    int width, height;
    bool fuses;
};

TEST_P(EveryBloomOnGpu, equals_its_twin_in_double) {
    for (const auto& [width, height, fuses] : {BloomRun{135, 67, false},
                                               {320, 180, false},
                                               {135, 67, true},
                                               {320, 180, true},
                                               {3, 2, true}}) {
        SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
        const Image picture = night(width, height);
        const BloomPlan plan = bloom_plan(*GetParam(), {width, height}, {});
        const Image wanted = reference::with_bloom(plan, picture);
        // 2^-16 brings 65504 into the 0..1 that the encoding keeps.
        const std::vector<RgbD> got = run(picture, plan, -16, fuses);
        double error = 0, total = 0, worst = 0;
        for (std::size_t i = 0; i < got.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                const double off = got[i][c] - wanted.pixels[i][c];
                error += off * off;
                total += wanted.pixels[i][c] * wanted.pixels[i][c];
                worst = std::max(worst, std::abs(off) / (wanted.pixels[i][c] + 1));
            }
        }
        EXPECT_LT(std::sqrt(error / total), 5e-4);
        // Every stored level rounds to a half float, 2^-11 of a value; at most a dozen levels.
        EXPECT_LT(worst, 12.0 / 2048);
    }
}

// Many steps in a dispatch round as often as each by itself does; what they add up in another order
// may round to the next half float, once a step at most.
TEST_P(EveryBloomOnGpu, makes_of_many_steps_in_a_dispatch_what_each_makes_by_itself) {
    for (const auto& [width, height] :
         {std::pair{640, 360}, {320, 180}, {131, 67}, {700, 5}, {3, 2}, {1, 1}}) {
        SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
        const gpu::Image image = image_of(night(width, height));
        for (const float threshold : {0.0F, 1.0F}) {
            const BloomPlan plan =
                bloom_plan(*GetParam(), {width, height}, {-1, threshold, threshold / 2, 1});
            if (plan.empty()) {
                return;
            }
            std::vector<std::vector<std::uint16_t>> glows;
            for (const bool fuses : {false, true}) {
                Graph graph;
                const ImageHandle source = graph.import("night", image, image.desc());
                const Bloomed bloomed = add_bloom(graph, source, plan, {.fuses = fuses});
                graph.present(bloomed.glow);
                glows.push_back(run_and_read<std::uint16_t>(graph, bloomed.glow));
            }
            ASSERT_EQ(glows[0].size(), glows[1].size());
            for (std::size_t i = 0; i < glows[0].size(); ++i) {
                // Non-negative half floats stand in the order of their bits.
                ASSERT_LE(std::abs(glows[0][i] - glows[1][i]), 3) << i;
            }
        }
    }
}

TEST_P(EveryBloomOnGpu, conserves_energy_in_half_floats_where_it_says_so) {
    if (!GetParam()->conserves_energy) {
        GTEST_SKIP() << "does not claim to";
    }
    Image picture(512, 512);
    picture.at(255, 256) = {30000, 20000, 10000};
    for (int i = 0; i < 12; ++i) {
        picture.at(250 + i, 240) = {3, 2, 5};
    }
    const BloomPlan plan = bloom_plan(*GetParam(), {512, 512}, {0.5F, 1, 0.5F, 0.35F});
    const std::vector<RgbD> got = run(picture, plan, -15);
    RgbD before, after;
    for (std::size_t i = 0; i < got.size(); ++i) {
        before = before + picture.pixels[i];
        after = after + got[i];
    }
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(after[c] / before[c], 1, 1e-3);
    }
}

TEST_P(EveryBloomOnGpu, changes_no_bit_where_nothing_is_bright) {
    Image dim(135, 67);
    for (std::size_t i = 0; i < dim.pixels.size(); ++i) {
        dim.pixels[i] = {1, static_cast<double>(i % 32) / 64, 0.25};
    }
    const BloomPlan plan = bloom_plan(*GetParam(), {135, 67}, {-1, 1.25F, 0.25F, 1});
    EXPECT_EQ(run(dim, plan, 0), run(dim, {}, 0));
}

INSTANTIATE_TEST_SUITE_P(Table, EveryBloomOnGpu, testing::ValuesIn(rows_of(blooms())),
                         [](const auto& row) { return support::test_name(row.param->name); });

using PassTest = FinishTest;

TEST_F(PassTest, differences_are_ciede2000_and_their_figures_those_of_the_picture) {
    lutlib::Lut look;
    look.cube = lutlib::identity_cube(9);
    for (Rgb& node : look.cube->nodes) {
        node = {0.9F * node.r + 0.05F * node.b, node.g * node.g, 0.1F + 0.8F * node.b};
    }
    const std::vector<Rgb> colors = lutlib::sample_colors(8, {256, 4000, true});
    const gpu::Image image = image_of(colors);
    const GpuLook gpu_look(device(), look_data(look, *gpu_lookup_named("tetrahedral")));
    FinishSettings settings;
    settings.compare = &compare_difference;
    Graph graph;
    const ImageHandle source = graph.import("colours", image, image.desc());
    const Finished out = add_finish(graph, {source, {}, nullptr, &gpu_look, settings});
    graph.present(out.picture);
    graph.present(out.figures);
    Executor executor(device());
    executor.render(graph);
    const std::uint64_t texels = std::uint64_t{image.desc().width} * image.desc().height;
    const DifferenceFigures got =
        difference_figures(as<std::uint32_t>(executor.read_buffer(out.figures)), texels);

    std::vector<double> wanted(texels, lutlib::delta_e_2000(RgbD{0, 0, 0}, RgbD{0, 0, 0.1}));
    double sum = 0;
    for (std::size_t i = 0; i < texels; ++i) {
        const Rgb in = i < colors.size() ? colors[i] : Rgb{0, 0, 0};
        wanted[i] = lutlib::delta_e_2000(lutlib::to_double(in),
                                         lutlib::to_double(lutlib::evaluate(look, in)));
        sum += wanted[i];
    }
    std::sort(wanted.begin(), wanted.end());
    // Bins are 1/40 wide; the shader's Lab is in float.
    EXPECT_NEAR(got.max, wanted.back(), 0.01);
    EXPECT_NEAR(got.mean, sum / static_cast<double>(texels), 0.02);
    EXPECT_NEAR(got.p95, wanted[texels * 95 / 100], 0.05);
    EXPECT_NEAR(got.p99, wanted[texels * 99 / 100], 0.1);
}

TEST_F(PassTest, a_wipe_gives_each_texel_to_the_side_that_its_twin_does) {
    constexpr Size size{64, 36};
    const gpu::Image image = image_of(
        std::vector<Rgb>(std::size_t{size.width} * size.height, Rgb{0.25F, 0.5F, 0.75F}), 64);
    lutlib::Lut black;
    black.cube = lutlib::identity_cube(2);
    for (Rgb& node : black.cube->nodes) {
        node = {0, 0, 0};
    }
    const GpuLook look(device(), look_data(black, *gpu_lookup_named("tetrahedral")));
    for (const Compare* const compare : {&compare_split, &compare_box}) {
        for (const float angle : {0.0F, 90.0F, 180.0F, 270.0F, 33.0F, 140.0F}) {
            FinishSettings settings;
            settings.compare = compare;
            settings.split = 0.4F;
            settings.split_angle = angle;
            settings.box_width = angle / 400;
            settings.format = Format::rgba32f;
            settings.has_marks = false;
            Graph graph;
            const ImageHandle source = graph.import("colours", image, image.desc());
            const ImageHandle out =
                add_finish(graph, {source, {}, nullptr, &look, settings}).picture;
            graph.present(out);
            const std::vector<Rgb> got = colors_of(run_and_read<float>(graph, out));
            const WipeShape shape = wipe_shape(settings, *compare, size);
            int wrong = 0;
            for (std::uint32_t y = 0; y < size.height; ++y) {
                for (std::uint32_t x = 0; x < size.width; ++x) {
                    const bool is_a = got[y * size.width + x].g > 0;
                    wrong += is_a != shows_a(shape, *compare, x + 0.5, y + 0.5) ? 1 : 0;
                }
            }
            // A line in float may pass the middle of a texel on the other side.
            EXPECT_LE(wrong, std::fmod(angle, 90.0F) == 0 ? 0 : 1) << compare->name << angle;
        }
    }
}

TEST_F(PassTest, sides_and_halves_show_the_look_they_are_named_for) {
    std::vector<Rgb> colors(std::size_t{64} * 36, Rgb{0.25F, 0.5F, 0.75F});
    const gpu::Image image = image_of(colors, 64);
    lutlib::Lut black;
    black.cube = lutlib::identity_cube(2);
    for (Rgb& node : black.cube->nodes) {
        node = {0, 0, 0};
    }
    const GpuLook look(device(), look_data(black, *gpu_lookup_named("tetrahedral")));
    for (const Compare& compare : compares) {
        FinishSettings settings;
        settings.compare = &compare;
        settings.split = 0.25F;
        settings.format = Format::rgba32f;
        Graph graph;
        const ImageHandle source = graph.import("colours", image, image.desc());
        const ImageHandle out = add_finish(graph, {source, {}, nullptr, &look, settings}).picture;
        graph.present(out);
        const std::uint32_t width = graph.image_desc(out).width;
        EXPECT_EQ(width, &compare == &compare_side ? 128U : 64U);
        EXPECT_EQ(picture_size({width, 36}, compare), (Size{64, 36}));
        const std::vector<Rgb> got = colors_of(run_and_read<float>(graph, out));
        const auto at = [&](std::uint32_t x) { return got[x + std::size_t{width} * 20]; };
        const Rgb original = colors[0], none{0, 0, 0};
        const std::string name(compare.name);
        SCOPED_TRACE(name);
        if (name == "a") {
            EXPECT_EQ(at(0), original);
            EXPECT_EQ(at(63), original);
        } else if (name == "b") {
            EXPECT_EQ(at(0), none);
            EXPECT_EQ(at(63), none);
        } else if (name == "split") {
            EXPECT_EQ(at(14), original);
            EXPECT_EQ(at(18), none);
            EXPECT_EQ(at(16), (Rgb{1, 1, 1}));
        } else if (name == "box") {
            EXPECT_EQ(at(5), none);
            EXPECT_EQ(at(30), original);
            EXPECT_EQ(at(60), none);
        } else if (name == "side") {
            EXPECT_EQ(at(63), original);
            EXPECT_EQ(at(64), none);
        }
    }
}

} // namespace
} // namespace preview
