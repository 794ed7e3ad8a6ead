// The GPU's grade against lutlib's, for every row of the table of lookups.
#include "lutlib/error.h"
#include "preview/look/look_bake.h"
#include "tests/preview/passes/finish_fixture.h"
#include "tests/support/names.h"
#include "tests/support/thorough.h"

#include <string>

namespace preview {
namespace {

using lutlib::Lut;
using lutlib::Rgb;
using lutlib::RgbD;

// A look with everything that shows a wrong fetch: channels that mix, slopes up to 3, and ends that
// are not 0 and 1.
RgbD strong_look(RgbD c) {
    const double grey = 0.3 * c.r + 0.5 * c.g + 0.2 * c.b;
    return {0.04 + 0.9 * std::pow(c.r, 0.6) * (1 - 0.3 * c.b),
            0.98 * (0.5 - 0.5 * std::cos(3.0 * c.g)) * (0.7 + 0.3 * grey),
            0.1 + 0.8 * (0.6 * c.b * c.b + 0.4 * grey) * (1 - 0.2 * c.r)};
}

lutlib::Lut3D cube_of(int size, lutlib::Domain domain) {
    lutlib::Lut3D cube = lutlib::identity_cube(size, domain);
    for (Rgb& node : cube.nodes) {
        RgbD unit;
        for (std::size_t c = 0; c < 3; ++c) {
            unit[c] =
                static_cast<double>((node[c] - domain.min[c]) / (domain.max[c] - domain.min[c]));
        }
        node = lutlib::to_float(strong_look(unit));
    }
    return cube;
}

lutlib::Lut1D shaper_of(int size, lutlib::Domain domain) {
    lutlib::Lut1D shaper{domain, {}};
    for (int i = 0; i < size; ++i) {
        const float x = static_cast<float>(i) / static_cast<float>(size - 1);
        shaper.entries.push_back({std::sqrt(x), x * x, 1.2F * x - 0.1F});
    }
    return shaper;
}

std::vector<std::pair<std::string, Lut>> table_looks() {
    const lutlib::Domain wide{{-0.5F, -0.25F, 0}, {4, 2, 1.5F}}, log{{0, 0, 0}, {16, 16, 16}};
    std::vector<std::pair<std::string, Lut>> looks(6);
    looks[0].first = "cube";
    looks[0].second.cube = cube_of(17, {});
    looks[1].first = "two nodes";
    looks[1].second.cube = cube_of(2, {});
    looks[2].first = "domain";
    looks[2].second.cube = cube_of(33, wide);
    looks[3].first = "shaper and cube";
    looks[3].second.shaper = shaper_of(1024, log);
    looks[3].second.cube = cube_of(9, {});
    looks[4].first = "long shaper";
    looks[4].second.shaper = shaper_of(10000, {});
    looks[5].first = "identity";
    looks[5].second.cube = lutlib::identity_cube(16);
    return looks;
}

constexpr double float_bound = 2e-6;

void expect_near(const std::vector<Rgb>& got, const std::vector<Rgb>& wanted,
                 const std::vector<Rgb>& inputs, double bound) {
    ASSERT_EQ(got.size(), wanted.size());
    double worst = -1;
    std::size_t at = 0;
    for (std::size_t i = 0; i < got.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double error = std::abs(static_cast<double>(got[i][c] - wanted[i][c]));
            if (!(error <= worst)) {
                worst = error;
                at = i;
            }
        }
    }
    EXPECT_LE(worst, bound) << "of (" << inputs[at].r << ' ' << inputs[at].g << ' ' << inputs[at].b
                            << "): got " << got[at].r << ' ' << got[at].g << ' ' << got[at].b
                            << ", wanted " << wanted[at].r << ' ' << wanted[at].g << ' '
                            << wanted[at].b;
}

// Texture units place a sample between texels with 8 fraction bits: half a step of 1/256 of a
// cell's change in each of three axes. Between two nodes a cell's change is the whole range.
int filter_codes(int size) {
    return static_cast<int>(std::ceil(3.0 / 512 * 255 / (size - 1)));
}

void expect_codes_near(const std::vector<std::uint8_t>& got, const std::vector<Rgb>& wanted,
                       int bound) {
    int worst = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float clamped = std::clamp(wanted[i][c], 0.0F, 1.0F);
            const int code = static_cast<int>(std::lround(clamped * 255));
            worst = std::max(worst, std::abs(code - int{got[4 * i + c]}));
        }
    }
    EXPECT_LE(worst, bound);
}

class EveryLookup : public FinishTest, public testing::WithParamInterface<const GpuLookup*> {
  protected:
    // A GPU may divide with an error of 2.5 units in the last place (Vulkan, "Precision and
    // Operation of SPIR-V Instructions"). A texture coordinate across a strip of size^2 texels
    // makes that a share of a texel, and neighbouring texels may differ by the whole range. Mesa's
    // lavapipe divides exactly.
    double bound_for(int size) {
        const bool divides_exactly = device().name().find("llvmpipe") != std::string::npos;
        const bool has_coordinates = !std::string_view(GetParam()->layout).empty();
        return divides_exactly || !has_coordinates
                   ? float_bound
                   : std::max(float_bound, 2.5 * 0x1p-24 * size * size);
    }

    static FinishSettings display_encoded() {
        FinishSettings settings;
        settings.tonemap = nullptr;
        return settings;
    }

    // The GPU and `oracle` over the test colours, in floats and in codes.
    template <class Oracle>
    void compare(const LookData& data, int size, Oracle oracle, const std::string& what) {
        SCOPED_TRACE(what);
        const std::vector<Rgb> inputs = test_colors(size);
        std::vector<Rgb> wanted;
        for (const Rgb& in : inputs) {
            wanted.push_back(oracle(in));
        }
        GpuLook look(device(), data);
        if (!GetParam()->filtered) {
            expect_near(finished(inputs, &look, display_encoded()), wanted, inputs,
                        bound_for(size));
        }
        expect_codes_near(finished_codes(inputs, &look, display_encoded()), wanted,
                          GetParam()->filtered ? std::max(1, filter_codes(size)) : 1);
        if (!GetParam()->shared() || !device().has_half()) {
            return;
        }
        look.half_arithmetic = !look.half_arithmetic;
        expect_codes_near(finished_codes(inputs, &look, display_encoded()), wanted, 1);
    }

    void compare_table(const Lut& look, const std::string& what) {
        const GpuLookup& row = *GetParam();
        const int size = look.cube ? look.cube->size : 16;
        compare(
            look_data(look, row), size,
            [&](Rgb in) { return lutlib::evaluate(look, in, row.interpolation); }, what);
    }

    void compare_picture(const lutlib::Engine& engine, int size, int bits) {
        const GpuLookup& row = *GetParam();
        const lutlib::CodeImage codes =
            lutlib::bake(lutlib::Transform::each(strong_look), engine, size, bits).picture;
        const lutlib::Picture decoded = lutlib::decoded(codes);
        const lutlib::Lut3D cube =
            lutlib::from_picture(decoded, *lutlib::layout_named(row.layout), size);
        compare(
            look_data(codes, size, row), size,
            [&](Rgb in) {
                return row.engine ? row.engine->lookup(decoded, size, in)
                                  : lutlib::evaluate(cube, in, row.interpolation);
            },
            std::to_string(size) + " nodes, " + std::to_string(bits) + " bits");
    }
};

TEST_P(EveryLookup, gives_what_lutlib_gives) {
    const GpuLookup& row = *GetParam();
    switch (row.source) {
    case GpuLookup::Source::none:
        break;
    case GpuLookup::Source::table:
        for (const auto& [name, look] : table_looks()) {
            if (!row.filtered || (look.cube && look.cube->domain.is_unit() && !look.shaper)) {
                compare_table(look, name);
            }
        }
        break;
    case GpuLookup::Source::picture: {
        const lutlib::Engine& engine = row.engine ? *row.engine : *lutlib::engine_named("piccolo");
        compare_picture(engine, row.shared() ? 16 : engine.default_size, 8);
        if (row.engine) {
            // Of a whole range of sizes its ends and some between.
            const std::size_t step =
                support::is_thorough() ? 1 : std::max<std::size_t>(1, engine.sizes.size() / 4);
            for (std::size_t i = 0; i < engine.sizes.size(); i += step) {
                compare_picture(engine, engine.sizes[i], engine.default_bits);
            }
            if (!engine.sizes.empty()) {
                compare_picture(engine, engine.sizes.back(), engine.default_bits);
            }
            for (const int bits : engine.bits) {
                compare_picture(engine, engine.default_size, bits);
            }
        }
        break;
    }
    }
}

TEST_P(EveryLookup, of_a_lattice_whose_channels_do_not_mix_is_one_of_curves) {
    const GpuLookup& row = *GetParam();
    if (row.source != GpuLookup::Source::table || row.filtered) {
        GTEST_SKIP() << "reads no table in floats";
    }
    Lut look;
    look.cube = lutlib::identity_cube(17);
    look.cube->domain = {{-0.25F, 0, 0}, {1, 1.5F, 1}};
    for (Rgb& node : look.cube->nodes) {
        node = {std::sqrt(node.r), 0.1F + 0.7F * node.g * node.g, 1 - node.b};
    }
    const bool is_nearest = row.interpolation == lutlib::Interpolation::nearest;
    const LookData data = look_for(look, row).data;
    EXPECT_EQ(data.block.size, is_nearest ? 17 : 0);
    compare(
        data, 17, [&](Rgb in) { return lutlib::evaluate(look, in, row.interpolation); }, "curves");
    for (Rgb& node : look.cube->nodes) {
        node.r += 1e-4F * node.b;
    }
    EXPECT_EQ(look_for(look, row).data.block.size, 17);
}

INSTANTIATE_TEST_SUITE_P(Table, EveryLookup, testing::ValuesIn([] {
                             std::vector<const GpuLookup*> rows;
                             for (const GpuLookup& row : gpu_lookups()) {
                                 rows.push_back(&row);
                             }
                             return rows;
                         }()),
                         [](const auto& row) { return support::test_name(row.param->name); });

using SharedLookupTest = FinishTest;

// finish_shared.comp cuts a picture into runs of tiles; finish.comp does not.
TEST_F(SharedLookupTest, every_texel_of_any_size_is_finished_as_by_the_plain_pass) {
    const lutlib::CodeImage codes =
        lutlib::bake(lutlib::Transform::each(strong_look), *lutlib::engine_named("piccolo"), 16, 8)
            .picture;
    const GpuLook plain(device(), look_data(codes, 16, *gpu_lookup_named("strip")));
    const GpuLook fast(device(), look_data(codes, 16, *gpu_lookup_named("shared-trilinear")));
    for (const auto& [width, height] : {std::pair{1, 1}, {63, 31}, {65, 33}, {135, 67}}) {
        SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
        reference::Image picture(width, height);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                picture.at(x, y) = {x * 0.02, y * 0.03, (x ^ y) * 0.01};
            }
        }
        const gpu::Image image = image_of(picture);
        const auto run = [&](const GpuLook& look) {
            FinishSettings settings;
            settings.tonemap = tonemap_named("agx");
            settings.compare = &compare_side;
            settings.format = Format::rgba32f;
            Graph graph;
            const ImageHandle source = graph.import("picture", image, image.desc());
            const BloomPlan plan =
                bloom_plan(*bloom_named("dual-kawase"), {picture.width, picture.height}, {});
            const ImageHandle out = add_finish(graph, {source, add_bloom(graph, source, plan),
                                                       &look, nullptr, settings})
                                        .picture;
            graph.present(out);
            return colors_of(run_and_read<float>(graph, out));
        };
        const std::vector<Rgb> wanted = run(plain);
        expect_near(run(fast), wanted, wanted, float_bound);
    }
}

TEST_F(SharedLookupTest, of_two_looks_the_one_beyond_shared_memory_is_read_alike) {
    const auto codes_of_look = [](double power) {
        return lutlib::bake(lutlib::Transform::each([=](RgbD c) {
                                return strong_look({std::pow(c.r, power), c.g, c.b});
                            }),
                            *lutlib::engine_named("piccolo"), 16, 8)
            .picture;
    };
    const std::vector<Rgb> inputs = test_colors(16);
    const gpu::Image image = image_of(inputs);
    for (const char* name : {"shared-trilinear", "shared-tetrahedral"}) {
        SCOPED_TRACE(name);
        const GpuLookup& row = *gpu_lookup_named(name);
        const GpuLook first(device(), look_data(codes_of_look(1), 16, row));
        const GpuLook second(device(), look_data(codes_of_look(2), 16, row));
        const auto run = [&](const GpuLook* a, const GpuLook* b, const char* compare) {
            FinishSettings settings;
            settings.compare = compare_named(compare);
            settings.format = Format::rgba32f;
            Graph graph;
            const ImageHandle out =
                add_finish(graph,
                           {graph.import("colours", image, image.desc()), {}, a, b, settings})
                    .picture;
            graph.present(out);
            return colors_of(run_and_read<float>(graph, out));
        };
        const std::vector<Rgb> both = run(&first, &second, "side");
        const std::vector<Rgb> alone[] = {run(&first, nullptr, "a"), run(nullptr, &second, "b")};
        std::vector<Rgb> got, wanted;
        for (std::size_t i = 0; i < both.size(); ++i) {
            const std::size_t x = i % (2 * colors_a_row), y = i / (2 * colors_a_row);
            got.push_back(both[i]);
            wanted.push_back(alone[x / colors_a_row][y * colors_a_row + x % colors_a_row]);
        }
        expect_near(got, wanted, wanted, float_bound);
    }
}

TEST(Lookups, have_a_row_for_every_engine) {
    for (const lutlib::Engine& engine : lutlib::engines()) {
        const GpuLookup* row = gpu_lookup_named(engine.name);
        ASSERT_NE(row, nullptr) << "shaders/common/lookup.glsl lacks " << engine.name;
        EXPECT_EQ(row->engine, &engine);
    }
}

TEST(Lookups, refuse_what_they_cannot_read) {
    lutlib::CodeImage picture;
    EXPECT_THROW(look_data(picture, 32, *gpu_lookup_named("shared-trilinear")), lutlib::Error);
    EXPECT_THROW(look_data(picture, 16, *gpu_lookup_named("tetrahedral")), lutlib::Error);
    EXPECT_THROW(look_data(Lut{}, *gpu_lookup_named("volume")), lutlib::Error);
    EXPECT_THROW(look_data(Lut{}, *gpu_lookup_named("piccolo")), lutlib::Error);
}

} // namespace
} // namespace preview
