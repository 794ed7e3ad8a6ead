// One more pass in the middle of a frame, without a GPU.
#include "preview/graph/interpose.h"
#include "preview/graph/plan.h"
#include "preview/passes/plant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace preview {
namespace {

constexpr ImageDesc desc{Format::rgba16f, 8, 4};

ImageHandle filter(Graph& graph, std::string_view name, ImageHandle source) {
    Pass pass = graph.compute(name, "copy.comp");
    if (source) {
        pass.read(source);
    }
    const ImageHandle out = pass.write(graph.image(name, desc));
    pass.dispatch_over(desc.width, desc.height);
    return out;
}

std::vector<std::string> steps_of(const Graph& graph) {
    std::vector<std::string> out;
    for (const Step& step : make_plan(graph).steps) {
        out.push_back(graph.passes()[step.pass].name);
    }
    return out;
}

/// What the pass of that name samples.
std::vector<std::string> read_by(const Graph& graph, std::string_view name) {
    std::vector<std::string> out;
    for (const PassRecord& pass : graph.passes()) {
        for (const Use& use : pass.uses) {
            if (pass.name == name && !use.writes) {
                out.push_back(graph.resource_of(use.version).name);
            }
        }
    }
    return out;
}

Graph with_plant(const Graph& graph, ImageHandle image) {
    return interposed(graph, image, [](Graph& copy, ImageHandle source) {
        return add_plant(copy, source, {1, 2, 3});
    });
}

TEST(Interposed, stands_behind_the_writer_and_in_front_of_every_reader) {
    Graph graph;
    const ImageHandle a = filter(graph, "a", {}), b = filter(graph, "b", a);
    Pass last = graph.compute("last", "mix.comp");
    last.read(a);
    last.read(b);
    const ImageHandle out = last.write(graph.image("last", desc));
    graph.present(out);

    const Graph changed = with_plant(graph, a);
    EXPECT_EQ(steps_of(graph), (std::vector<std::string>{"a", "b", "last"}));
    EXPECT_EQ(steps_of(changed), (std::vector<std::string>{"a", "plant", "b", "last"}));
    EXPECT_EQ(read_by(changed, "plant"), std::vector<std::string>{"a"});
    EXPECT_EQ(read_by(changed, "b"), std::vector<std::string>{"planted"});
    EXPECT_EQ(read_by(changed, "last"), (std::vector<std::string>{"planted", "b"}));
    for (std::uint32_t version = 0; version < changed.versions().size(); ++version) {
        const std::uint32_t producer = changed.versions()[version].producer;
        if (producer == Version::none) {
            continue;
        }
        const PassRecord& pass = changed.passes()[producer];
        EXPECT_TRUE(std::any_of(pass.uses.begin(), pass.uses.end(), [&](const Use& use) {
            return use.writes && use.version == version;
        })) << pass.name;
    }
}

TEST(Interposed, leaves_those_alone_that_draw_over_the_image) {
    Graph graph;
    const ImageHandle lit = filter(graph, "lit", {});
    const ImageHandle early = filter(graph, "early", lit);
    Pass over = graph.raster("over", "x.vert", "x.frag");
    const ImageHandle blended = over.color_over(lit);
    const ImageHandle late = filter(graph, "late", blended);
    graph.present(early);
    graph.present(late);

    // `lit` is retired by now; who read it before it was drawn over reads what was planted.
    const Graph changed = with_plant(graph, lit);
    EXPECT_EQ(read_by(changed, "early"), std::vector<std::string>{"planted"});
    EXPECT_EQ(read_by(changed, "late"), std::vector<std::string>{"lit"});
    EXPECT_TRUE(changed.versions()[lit.version].retired);
    EXPECT_EQ(steps_of(changed),
              (std::vector<std::string>{"lit", "plant", "early", "over", "late"}));
}

TEST(Interposed, is_one_pass_for_an_image_that_somebody_samples) {
    Graph graph;
    const ImageHandle a = filter(graph, "a", {}), b = filter(graph, "b", a);
    graph.present(b);
    EXPECT_TRUE(is_sampled(graph, a));
    EXPECT_FALSE(is_sampled(graph, b));
    EXPECT_THROW(interposed(graph, a, [](Graph&, ImageHandle image) { return image; }),
                 std::logic_error);
}

TEST(Planted, are_plain_images_of_floats) {
    EXPECT_TRUE(can_be_planted({Format::rgba16f, 4, 4}));
    EXPECT_TRUE(can_be_planted({Format::d32, 4, 4}));
    EXPECT_FALSE(can_be_planted({Format::d32, 4, 4, 0, 2})) << "a shadow map";
    EXPECT_FALSE(can_be_planted({Format::rgba8, 4, 4}));
    EXPECT_FALSE(can_be_planted({Format::r32ui, 4, 4}));
}

} // namespace
} // namespace preview
