// The passes that finish texels and keep no picture: the probe against the finishing pass, and the
// counts along curve axes against their twin.
#include "lutlib/color/difference.h"
#include "preview/look/look_bake.h"
#include "preview/passes/axes.h"
#include "preview/passes/probe.h"
#include "preview/reference/axes.h"
#include "tests/preview/passes/finish_fixture.h"
#include "tests/support/names.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <numeric>

namespace preview {
namespace {

using lutlib::Rgb;
using lutlib::RgbD;

lutlib::Lut bent_look() {
    lutlib::Lut look;
    look.cube = lutlib::identity_cube(16);
    for (Rgb& node : look.cube->nodes) {
        node = {0.9F * node.r + 0.05F * node.b, node.g * node.g, 0.1F + 0.8F * node.b};
    }
    return look;
}

/// What the HDR resolve lets through.
std::vector<Rgb> finite_colors() {
    std::vector<Rgb> colors = test_colors(2);
    for (Rgb& color : colors) {
        for (std::size_t c = 0; c < 3; ++c) {
            color[c] = color[c] > 0 ? std::min(color[c], 65504.0F) : 0;
        }
    }
    return colors;
}

class ProbeTest : public FinishTest {
  protected:
    /// Of some places of an image of these colours, of each the texel's index and the probe.
    static std::vector<std::pair<std::size_t, Probe>>
    probed(const std::vector<Rgb>& colors, const GpuLook* b, const FinishSettings& settings) {
        const gpu::Image image = image_of(colors);
        std::vector<std::pair<std::size_t, Probe>> out;
        Executor executor(device());
        for (const std::size_t at : {std::size_t{0}, std::size_t{77}, std::size_t{300},
                                     colors.size() / 2, colors.size() - 1}) {
            const ProbePlace place{static_cast<int>(at % colors_a_row),
                                   static_cast<int>(at / colors_a_row)};
            Graph graph;
            const ImageHandle source = graph.import("colours", image, image.desc());
            const BufferHandle told = add_probe(graph, {source, {}, nullptr, b, settings}, place);
            graph.present(told);
            executor.render(graph);
            out.emplace_back(at, probe_from(executor.read_buffer(told)).value());
        }
        return out;
    }
};

TEST_F(ProbeTest, tells_the_tone_mapped_color_before_the_looks) {
    const std::vector<Rgb> colors = finite_colors();
    FinishSettings settings;
    settings.tonemap = tonemap_named("agx");
    const std::vector<Rgb> wanted = finished(colors, nullptr, settings);
    for (const auto& [at, probe] : probed(colors, nullptr, settings)) {
        for (std::size_t c = 0; c < 3; ++c) {
            // Two compilations of the same arithmetic.
            EXPECT_NEAR(probe.before[c], static_cast<double>(wanted[at][c]), 2e-6) << at;
            EXPECT_EQ(probe.a[c], probe.before[c]) << at;
            EXPECT_EQ(probe.b[c], probe.before[c]) << at;
        }
    }
}

TEST_F(ProbeTest, tells_the_exposed_light_before_the_tone_map_and_none_without_one) {
    const std::vector<Rgb> colors = finite_colors();
    FinishSettings settings;
    settings.exposure = -1;
    for (const auto& [at, probe] : probed(colors, nullptr, settings)) {
        EXPECT_EQ(probe.light, (RgbD{0, 0, 0})) << at;
    }
    settings.tonemap = tonemap_named("agx");
    for (const auto& [at, probe] : probed(colors, nullptr, settings)) {
        for (std::size_t c = 0; c < 3; ++c) {
            // Half of it is exact; what half floats cannot hold is cut off.
            const auto light = static_cast<double>(colors[at][c]) / 2;
            EXPECT_EQ(probe.light[c], std::clamp(light, 0.0, 65504.0)) << at;
        }
    }
}

class EveryLookupProbed : public ProbeTest, public testing::WithParamInterface<const GpuLookup*> {};

TEST_P(EveryLookupProbed, tells_what_the_finishing_pass_makes_of_the_texel) {
    const GpuLookup& lookup = *GetParam();
    const std::vector<Rgb> colors = finite_colors();
    const GpuLook look(
        device(), lookup.source == GpuLookup::Source::none
                      ? no_look()
                      : look_for(std::make_shared<const lutlib::Lut>(bent_look()), lookup).data);
    const std::vector<Rgb> wanted = finished(colors, &look, {});
    for (const auto& [at, probe] : probed(colors, &look, {})) {
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(probe.b[c], static_cast<double>(wanted[at][c]), 4e-6) << at;
        }
    }
}

std::vector<const GpuLookup*> lookup_rows() {
    std::vector<const GpuLookup*> rows;
    for (const GpuLookup& row : gpu_lookups()) {
        rows.push_back(&row);
    }
    return rows;
}

INSTANTIATE_TEST_SUITE_P(Table, EveryLookupProbed, testing::ValuesIn(lookup_rows()),
                         [](const auto& row) { return support::test_name(row.param->name); });

TEST(ProbedTest, print_codes_values_and_differences_in_words_and_as_json) {
    const Probe probe{{0.5, 0.25, 1}, {0.5, 0.25, 1}, {0.6, -0.1, NAN}, {}};
    EXPECT_EQ(probe, Probe(probe));
    const ProbeDifferences differences = differences_of(probe);
    EXPECT_EQ(differences.before_a, 0);
    EXPECT_DOUBLE_EQ(differences.a_b, lutlib::delta_e_2000(RgbD{0.5, 0.25, 1}, RgbD{0.6, 0, 0}));
    const std::string text = probe_table(probe, {3, 4});
    EXPECT_NE(text.find("before   128  64 255"), std::string::npos) << text;
    EXPECT_NE(text.find("B        153   0   0"), std::string::npos) << text;
    const auto json = nlohmann::json::parse(probe_json(probe, {3, 4}));
    EXPECT_EQ(json["b"]["codes"], (std::vector<int>{153, 0, 0}));
    EXPECT_EQ(json["x"], 3);
}

class EveryEncodingCounted : public FinishTest,
                             public testing::WithParamInterface<const lutlib::Encoding*> {
  protected:
    static std::vector<std::uint32_t> run(const std::vector<Rgb>& colors, std::uint32_t width) {
        const gpu::Image image = image_of(colors, width);
        Graph graph;
        const ImageHandle source = graph.import("colours", image, image.desc());
        const BufferHandle out = add_axes(graph, {source, {}, nullptr, nullptr, {}}, *GetParam());
        graph.present(out);
        Executor executor(device());
        executor.render(graph);
        return as<std::uint32_t>(executor.read_buffer(out));
    }
};

TEST_P(EveryEncodingCounted, counts_what_its_twin_in_double_counts_but_for_values_at_a_bins_edge) {
    for (const std::uint32_t width : {7U, 200U}) {
        std::vector<Rgb> colors = test_colors(8);
        colors.resize(colors.size() / width * width);
        std::vector<RgbD> doubles;
        for (const Rgb& color : colors) {
            doubles.push_back(lutlib::to_double(color));
        }
        const auto wanted = reference::axis_counts(doubles, *GetParam());
        const auto got = run(colors, width);
        ASSERT_EQ(got.size(), wanted.size());
        for (std::size_t axis = 0; axis < counted_axes.size(); ++axis) {
            std::uint64_t total = 0, apart = 0;
            for (std::size_t bin = axis * axis_bins; bin < (axis + 1) * axis_bins; ++bin) {
                total += wanted[bin];
                apart += got[bin] > wanted[bin] ? got[bin] - wanted[bin] : wanted[bin] - got[bin];
            }
            // Lattice nodes lie on the edges of bins; each that falls aside counts twice.
            EXPECT_LE(apart, total / 50) << counted_axes[axis].label << axis;
            const bool is_code = axis >= 3;
            if (is_code) {
                EXPECT_EQ(std::accumulate(got.begin() + static_cast<long>(axis * axis_bins),
                                          got.begin() + static_cast<long>((axis + 1) * axis_bins),
                                          std::uint64_t{0}),
                          colors.size());
            }
        }
    }
}

TEST_P(EveryEncodingCounted, neutrals_have_no_hue_and_no_saturation) {
    std::vector<Rgb> greys;
    for (int i = 0; i < 256; ++i) {
        const float grey = static_cast<float>(i) / 255;
        greys.push_back({grey, grey, grey});
    }
    const auto got = run(greys, 256);
    const std::size_t saturation = 1 * axis_bins, hue = 2 * axis_bins;
    EXPECT_EQ(got[saturation], greys.size());
    EXPECT_EQ(std::accumulate(got.begin() + hue, got.begin() + hue + axis_bins, 0U), 0U);
}

std::string test_name(const lutlib::Encoding& encoding) {
    std::string out = encoding.name();
    std::replace(out.begin(), out.end(), '-', '_');
    return out;
}

std::vector<const lutlib::Encoding*> encoding_rows() {
    std::vector<const lutlib::Encoding*> rows;
    for (const lutlib::Encoding& row : lutlib::encodings()) {
        rows.push_back(&row);
    }
    return rows;
}

INSTANTIATE_TEST_SUITE_P(Table, EveryEncodingCounted, testing::ValuesIn(encoding_rows()),
                         [](const auto& row) { return test_name(*row.param); });

TEST(AxisForTest, every_curve_of_every_operator_has_an_axis_that_is_counted) {
    for (const lutlib::Op* op : lutlib::ops()) {
        for (const lutlib::Parameter& parameter : op->parameters) {
            if (parameter.kind == lutlib::ParameterKind::curve) {
                EXPECT_NE(axis_for(parameter), nullptr) << op->name << ' ' << parameter.name;
            }
        }
    }
}

} // namespace
} // namespace preview
