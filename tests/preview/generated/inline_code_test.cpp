// The code that `lutconv shader --inline` writes, on a device, against what the CPU makes of the
// same form of the look.
#include "lutlib/fit/inline_fit.h"
#include "lutlib/io/look.h"
#include "preview/gpu/shaders.h"
#include "tests/preview/graph/gpu_test.h"

#include <cmath>
#include <limits>
#include <random>

namespace preview {
namespace {

constexpr std::size_t colors_tried = 100'000;
// As the code was made with, in CMakeLists.txt.
constexpr double max_delta_e = 2;

using Colors = std::vector<std::array<float, 4>>;

// Of the domain and a little beyond, its ends, and what is no number.
Colors colors_of(const lutlib::Domain& domain) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    infinite = std::numeric_limits<float>::infinity();
    const lutlib::Rgb low = domain.min, high = domain.max;
    Colors out{{low.r, low.g, low.b, 1},
               {high.r, high.g, high.b, 1},
               {nan, .5F, .25F, 1},
               {infinite, .5F, .1F, 1},
               {.2F, -infinite, .9F, 1}};
    std::mt19937 random(11);
    std::uniform_real_distribution<float> share(-0.05F, 1.05F);
    while (out.size() < colors_tried) {
        std::array<float, 4> color{0, 0, 0, 1};
        for (std::size_t c = 0; c < 3; ++c) {
            color[c] = std::lerp(low[c], high[c], share(random));
        }
        out.push_back(color);
    }
    return out;
}

class InlineCode : public GpuTest {
  protected:
    static std::vector<float> run(const std::string& shader, const Colors& in) {
        const std::uint64_t bytes = in.size() * sizeof(in.front());
        const gpu::Buffer given = gpu::make_buffer(device(), std::as_bytes(std::span(in)));
        Graph graph;
        Pass pass = graph.compute("lookup", shader);
        pass.storage(graph.import("colours", given, bytes));
        const BufferHandle results = pass.write(graph.buffer("results", bytes));
        pass.dispatch(static_cast<std::uint32_t>((in.size() + 63) / 64));
        graph.present(results);
        Executor executor(device());
        executor.render(graph);
        return as<float>(executor.read_buffer(results));
    }
};

// What stands in for a look, as lutconv finds it.
lutlib::InlineLook form_of(const lutlib::io::Look& look) {
    const auto table = look.is_table() ? look.table().lut : nullptr;
    const bool is_shaped = table && table->shaper && table->cube;
    const lutlib::InlineSearch search =
        fit_inline(look.exact(), look.domain(), look.breaks(), look.encodings(),
                   lutlib::Viewing(look.encodings().output.value_or(lutlib::srgb())), max_delta_e,
                   is_shaped ? std::optional(lutlib::ShapedTable{*table, look.interpolation()})
                             : std::nullopt);
    EXPECT_TRUE(search.found);
    return search.closest.look;
}

TEST_F(InlineCode, of_every_form_gives_what_the_cpu_does) {
    struct Case {
        std::string file;
        std::size_t form; ///< which of InlineLook it becomes
    };
    std::size_t forms = 0;
    for (const Case& one : {Case{"curves.cube", 1}, Case{"mixing.json", 1}, Case{"lattice.cube", 0},
                            Case{"shaped.cube", 2}}) {
        const auto look = lutlib::io::Look::open(std::string(INLINE_LOOKS "/") + one.file);
        const lutlib::InlineLook form = form_of(look);
        EXPECT_EQ(form.index(), one.form) << one.file;
        forms |= std::size_t{1} << form.index();
        const lutlib::Transform exact = transform_of(form);
        const Colors in = colors_of(look.domain());
        const std::string name = "inline_" + one.file.substr(0, one.file.find('.'));
        for (const char* const suffix : {".comp", ".comp.hlsl"}) {
            const std::vector<float> out = run(name + suffix, in);
            double worst = 0;
            for (std::size_t i = 0; i < in.size(); ++i) {
                const lutlib::RgbD got{out[4 * i], out[4 * i + 1], out[4 * i + 2]};
                const lutlib::RgbD right = exact({in[i][0], in[i][1], in[i][2]});
                worst = std::max(worst, largest_magnitude(got - right));
            }
            // Far below a code of 8 bits: places among nodes are good to 4e-6 in floats, times a
            // step of up to 1.
            EXPECT_LT(worst, 2e-5) << name << suffix;
        }
    }
    EXPECT_EQ(forms, (std::size_t{1} << std::variant_size_v<lutlib::InlineLook>)-1);
}

} // namespace
} // namespace preview
