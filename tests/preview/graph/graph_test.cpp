// Every rule of the graph and of its plan, without a GPU.
#include "preview/graph/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <tuple>

namespace preview {
namespace {

constexpr ImageDesc small{Format::rgba16f, 4, 4};

/// A pass that reads the given handles and writes a new image of its own name.
ImageHandle node(Graph& graph, const std::string& name, std::initializer_list<ImageHandle> inputs) {
    Pass pass = graph.compute(name, "x.comp");
    for (const ImageHandle input : inputs) {
        pass.read(input);
    }
    return pass.write(graph.image(name, small));
}

std::string order(const Graph& graph, const Plan& plan) {
    std::string names;
    for (const Step& step : plan.steps) {
        names += graph.passes()[step.pass].name + " ";
    }
    return names;
}

const Lifetime& life(const Graph& graph, const Plan& plan, const std::string& name) {
    const auto found =
        std::find_if(plan.lifetimes.begin(), plan.lifetimes.end(), [&](const Lifetime& lifetime) {
            return graph.resources()[lifetime.resource].name == name;
        });
    if (found == plan.lifetimes.end()) {
        throw std::runtime_error(name + " has no lifetime");
    }
    return *found;
}

TEST(GraphTest, keeps_what_the_presented_handle_needs_and_drops_the_rest) {
    Graph graph;
    const ImageHandle a = node(graph, "a", {});
    const ImageHandle b = node(graph, "b", {a});
    std::ignore = node(graph, "unwanted", {b});
    const ImageHandle c = node(graph, "c", {a});
    graph.present(c);
    const Plan plan = make_plan(graph);
    EXPECT_EQ(order(graph, plan), "a c ");
    EXPECT_EQ(plan.reasons[1], "nothing that is shown reads 'b'");
    EXPECT_EQ(plan.reasons[2], "nothing that is shown reads 'unwanted'");
    EXPECT_EQ(plan.reasons[0], "");
}

TEST(GraphTest, without_anything_presented_nothing_runs) {
    Graph graph;
    std::ignore = node(graph, "a", {});
    const Plan plan = make_plan(graph);
    EXPECT_TRUE(plan.steps.empty());
    EXPECT_TRUE(plan.lifetimes.empty());
}

TEST(GraphTest, a_pass_lives_for_any_one_of_its_outputs) {
    Graph graph;
    Pass pass = graph.compute("two", "x.comp");
    std::ignore = pass.write(graph.image("first", small));
    const ImageHandle second = pass.write(graph.image("second", small));
    graph.present(second);
    EXPECT_EQ(order(graph, make_plan(graph)), "two ");
}

TEST(GraphTest, a_color_target_that_nobody_reads_gets_no_memory) {
    Graph graph;
    Pass pass = graph.raster("g-buffer", "x.vert", "x.frag");
    const ImageHandle albedo = pass.color(graph.image("albedo", small), {});
    std::ignore = pass.color(graph.image("normal", small), {});
    std::ignore = pass.depth(graph.image("depth", {Format::d32, 4, 4}), 1);
    graph.present(albedo);
    const Plan plan = make_plan(graph);
    EXPECT_NO_THROW(life(graph, plan, "albedo"));
    EXPECT_NO_THROW(life(graph, plan, "depth")); // needed by the depth test
    EXPECT_THROW(life(graph, plan, "normal"), std::runtime_error);
    EXPECT_EQ(plan.steps[0].barriers.size(), 2U);
}

TEST(GraphTest, an_image_that_is_written_only_if_it_is_read_gets_no_memory_and_the_shader_is_told) {
    Graph graph;
    Pass pass = graph.compute("g-buffer", "x.comp");
    std::ignore = pass.write_if_read(graph.image("normal", small));
    const ImageHandle albedo = pass.write_if_read(graph.image("albedo", small));
    std::ignore = pass.write(graph.image("depth", small));
    const ImageHandle emission = pass.write_if_read(graph.image("emission", small));
    const ImageHandle lit = node(graph, "lit", {albedo});
    graph.present(lit);
    const Plan plan = make_plan(graph);
    EXPECT_NO_THROW(life(graph, plan, "albedo"));
    EXPECT_NO_THROW(life(graph, plan, "depth")); // its pass writes it in any case
    EXPECT_THROW(life(graph, plan, "normal"), std::runtime_error);
    EXPECT_THROW(life(graph, plan, "emission"), std::runtime_error);
    EXPECT_EQ(plan.steps[0].barriers.size(), 2U);
    EXPECT_EQ(read_targets(graph.passes()[0], plan.version_lives), 2U);
    EXPECT_EQ(read_targets(graph.passes()[1], plan.version_lives), std::nullopt);
    graph.present(emission);
    const Plan more = make_plan(graph);
    EXPECT_NO_THROW(life(graph, more, "emission"));
    EXPECT_EQ(read_targets(graph.passes()[0], more.version_lives), 6U);
}

TEST(GraphTest, reading_a_retired_version_is_an_error_that_names_both) {
    Graph graph;
    const ImageHandle first = node(graph, "picture", {});
    Pass pass = graph.compute("over", "x.comp");
    std::ignore = pass.write(first);
    Pass late = graph.compute("late", "x.comp");
    try {
        late.read(first);
        FAIL();
    } catch (const std::logic_error& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("late"), std::string::npos) << text;
        EXPECT_NE(text.find("picture"), std::string::npos) << text;
    }
}

TEST(GraphTest, writing_a_retired_version_is_an_error) {
    Graph graph;
    const ImageHandle first = node(graph, "picture", {});
    Pass pass = graph.compute("over", "x.comp");
    std::ignore = pass.write(first);
    Pass again = graph.compute("again", "x.comp");
    EXPECT_THROW(std::ignore = again.write(first), std::logic_error);
}

TEST(GraphTest, presenting_a_retired_version_is_an_error) {
    Graph graph;
    const ImageHandle first = node(graph, "picture", {});
    Pass pass = graph.compute("over", "x.comp");
    std::ignore = pass.write(first);
    EXPECT_THROW(graph.present(first), std::logic_error);
}

TEST(GraphTest, reading_or_presenting_what_no_pass_wrote_is_an_error) {
    Graph graph;
    const ImageHandle empty = graph.image("empty", small);
    Pass pass = graph.compute("reader", "x.comp");
    EXPECT_THROW(pass.read(empty), std::logic_error);
    EXPECT_THROW(graph.present(empty), std::logic_error);
    EXPECT_THROW(std::ignore = pass.modify(graph.buffer("counters", 16)), std::logic_error);
}

TEST(GraphTest, a_pass_cannot_read_and_write_the_same_resource) {
    Graph graph;
    const ImageHandle a = node(graph, "a", {});
    Pass pass = graph.compute("feedback", "x.comp");
    pass.read(a);
    EXPECT_THROW(std::ignore = pass.write(a), std::logic_error);
}

TEST(GraphTest, imported_and_data_resources_cannot_be_written) {
    Graph graph;
    const BufferHandle data = graph.data_of("numbers", 1.0F);
    Pass pass = graph.compute("writer", "x.comp");
    EXPECT_THROW(std::ignore = pass.write(data), std::logic_error);
}

TEST(GraphTest, data_blocks_of_one_name_have_one_content) {
    Graph graph;
    std::ignore = graph.data_of("numbers", 1.0F);
    EXPECT_NO_THROW(std::ignore = graph.data_of("numbers", 1.0F));
    EXPECT_THROW(std::ignore = graph.data_of("numbers", 2.0F), std::logic_error);
}

template <class T>
concept binds_as_image = requires(Pass pass, T handle) {
    pass.read(handle);
}
|| requires(Pass pass, T handle) {
    pass.color(handle, {});
};
template <class T>
concept binds_as_buffer = requires(Pass pass, T handle) {
    pass.storage(handle);
}
|| requires(Pass pass, T handle) {
    pass.index_buffer(handle);
};
static_assert(binds_as_image<ImageHandle> && !binds_as_image<BufferHandle>);
static_assert(binds_as_buffer<BufferHandle> && !binds_as_buffer<ImageHandle>);

TEST(GraphTest, writing_a_buffer_makes_a_buffer_and_writing_an_image_an_image) {
    Graph graph;
    Pass pass = graph.compute("both", "x.comp");
    const ImageHandle image = pass.write(graph.image("picture", small));
    const BufferHandle buffer = pass.write(graph.buffer("counters", 16));
    EXPECT_EQ(graph.image_desc(image), small);
    EXPECT_EQ(graph.buffer_bytes(buffer), 16U);
    EXPECT_EQ(graph.passes()[0].uses[0].binding, BindingType::storage_image);
    EXPECT_EQ(graph.passes()[0].uses[1].binding, BindingType::storage_buffer);
}

TEST(GraphTest, a_withheld_handle_binds_its_stand_in_and_keeps_its_binding_number) {
    Graph graph;
    Pass pass = graph.compute("lighting", "x.comp");
    pass.sample({}, Sampler::linear_clamp, Neutral::white);
    pass.storage({});
    const ImageHandle out = pass.write(graph.image("lit", small));
    graph.present(out);
    const PassRecord& record = graph.passes()[0];
    ASSERT_EQ(record.uses.size(), 3U);
    EXPECT_EQ(record.uses[0].version, Version::none);
    EXPECT_EQ(record.uses[0].neutral, Neutral::white);
    EXPECT_EQ(record.uses[0].binding, BindingType::sampled_image);
    EXPECT_EQ(record.uses[1].neutral, Neutral::no_buffer);
    const Plan plan = make_plan(graph);
    EXPECT_EQ(plan.steps[0].barriers.size(), 1U);
}

TEST(GraphTest, overwriting_does_not_keep_the_earlier_writer_but_modifying_does) {
    Graph graph;
    const BufferHandle buffer = graph.fill("clear", graph.buffer("counters", 16), 0);
    Pass add = graph.compute("add", "x.comp");
    const BufferHandle added = add.modify(buffer);
    graph.present(added);
    EXPECT_EQ(order(graph, make_plan(graph)), "clear add ");

    Graph other;
    const ImageHandle first = node(other, "a", {});
    Pass over = other.compute("over", "x.comp");
    other.present(over.write(first));
    EXPECT_EQ(order(other, make_plan(other)), "over ");
}

TEST(GraphTest, layers_written_one_by_one_keep_each_other_alive) {
    Graph graph;
    ImageHandle maps = graph.image("shadow maps", {Format::d32, 8, 8, 0, 3});
    for (std::uint32_t layer = 0; layer < 3; ++layer) {
        Pass pass = graph.raster("shadow " + std::to_string(layer), "x.vert", "");
        maps = layer == 0 ? pass.depth(maps, 1, 0) : pass.depth_layer(maps, 1, layer);
    }
    graph.present(node(graph, "lit", {maps}));
    EXPECT_EQ(order(graph, make_plan(graph)), "shadow 0 shadow 1 shadow 2 lit ");
}

TEST(GraphTest, first_use_drops_old_contents_and_reading_waits_for_the_writer) {
    Graph graph;
    const ImageHandle a = node(graph, "a", {});
    graph.present(node(graph, "b", {a}));
    const Plan plan = make_plan(graph);
    ASSERT_EQ(plan.steps[0].barriers.size(), 1U);
    EXPECT_EQ(plan.steps[0].barriers[0],
              (Barrier{0, 0, mask(Access::compute_write), Layout::undefined, Layout::general}));
    ASSERT_EQ(plan.steps[1].barriers.size(), 2U);
    EXPECT_EQ(plan.steps[1].barriers[0],
              (Barrier{0, mask(Access::compute_write), mask(Access::compute_sample),
                       Layout::general, Layout::read_only}));
}

TEST(GraphTest, reading_again_in_the_same_way_needs_no_barrier) {
    Graph graph;
    const ImageHandle a = node(graph, "a", {});
    const ImageHandle b = node(graph, "b", {a});
    graph.present(node(graph, "c", {a, b}));
    const Plan plan = make_plan(graph);
    for (const Barrier& barrier : plan.steps[2].barriers) {
        EXPECT_NE(barrier.resource, 0U);
    }
}

TEST(GraphTest, overwriting_waits_for_the_readers_and_drops_the_contents) {
    Graph graph;
    const ImageHandle a = node(graph, "a", {});
    const ImageHandle b = node(graph, "b", {a});
    Pass over = graph.compute("over", "x.comp");
    over.read(b);
    const ImageHandle again = over.write(a);
    graph.present(again);
    const Plan plan = make_plan(graph);
    const auto& barriers = plan.steps[2].barriers;
    const auto found = std::find_if(barriers.begin(), barriers.end(),
                                    [](const Barrier& barrier) { return barrier.resource == 0; });
    ASSERT_NE(found, barriers.end());
    EXPECT_EQ(found->from, mask(Access::compute_write) | mask(Access::compute_sample));
    EXPECT_EQ(found->to, mask(Access::compute_write));
    EXPECT_EQ(found->old_layout, Layout::undefined);
    EXPECT_EQ(found->new_layout, Layout::general);
}

TEST(GraphTest, a_reader_at_another_stage_waits_too) {
    Graph graph;
    Pass writer = graph.compute("writer", "x.comp");
    const BufferHandle buffer = writer.write(graph.buffer("lights", 64));
    Pass first = graph.compute("first", "x.comp");
    first.storage(buffer);
    const ImageHandle one = first.write(graph.image("one", small));
    Pass second = graph.raster("second", "x.vert", "x.frag");
    second.storage(buffer);
    const ImageHandle two = second.color(graph.image("two", small), {});
    graph.present(one);
    graph.present(two);
    const Plan plan = make_plan(graph);
    const Barrier& barrier = plan.steps[2].barriers[0];
    EXPECT_EQ(barrier.resource, 0U);
    EXPECT_EQ(barrier.to, mask(Access::graphics_read));
    EXPECT_NE(barrier.from & mask(Access::compute_write), 0U);
}

TEST(GraphTest, one_resource_bound_twice_in_a_pass_has_one_barrier) {
    Graph graph;
    const ImageHandle a = node(graph, "a", {});
    graph.present(node(graph, "b", {a, a}));
    EXPECT_EQ(make_plan(graph).steps[1].barriers.size(), 2U);
}

TEST(GraphTest, modifying_a_layer_keeps_its_layout) {
    Graph graph;
    Pass first = graph.raster("first", "x.vert", "");
    const ImageHandle one = first.depth(graph.image("maps", {Format::d32, 8, 8, 0, 2}), 1, 0);
    Pass second = graph.raster("second", "x.vert", "");
    const ImageHandle two = second.depth_layer(one, 1, 1);
    graph.present(node(graph, "lit", {two}));
    const Plan plan = make_plan(graph);
    EXPECT_EQ(plan.steps[1].barriers[0].old_layout, Layout::depth);
    EXPECT_EQ(plan.steps[1].barriers[0].new_layout, Layout::depth);
}

TEST(GraphTest, what_is_presented_ends_readable_and_outlives_the_last_step) {
    Graph graph;
    const ImageHandle a = node(graph, "a", {});
    const ImageHandle b = node(graph, "b", {a});
    graph.present(a);
    graph.present(b);
    graph.present(b);
    const Plan plan = make_plan(graph);
    ASSERT_EQ(plan.presented.size(), 2U);
    EXPECT_EQ(plan.presented[1].barrier.new_layout, Layout::transfer_src);
    EXPECT_EQ(life(graph, plan, "a").last, 2U);
    EXPECT_EQ(life(graph, plan, "b").last, 2U);
}

TEST(GraphTest, lifetimes_run_from_the_first_writer_to_the_last_living_reader) {
    Graph graph;
    const ImageHandle a = node(graph, "a", {});
    const ImageHandle b = node(graph, "b", {a});
    const ImageHandle c = node(graph, "c", {b});
    std::ignore = node(graph, "dead", {a});
    graph.present(node(graph, "d", {c}));
    const Plan plan = make_plan(graph);
    EXPECT_EQ(life(graph, plan, "a").first, 0U);
    EXPECT_EQ(life(graph, plan, "a").last, 1U);
    EXPECT_EQ(life(graph, plan, "c").last, 3U);
}

TEST(ExplainTest, says_of_each_pass_whether_it_runs_and_why_not) {
    Graph graph;
    graph.withhold("shadow of lamp", "no caster in the light's frustum");
    const ImageHandle a = node(graph, "scene", {});
    std::ignore = node(graph, "sky", {});
    graph.present(node(graph, "tone map", {a}));
    const std::string text = explain(graph, make_plan(graph));
    EXPECT_NE(text.find("kept      scene           writes scene 4x4\n"), std::string::npos) << text;
    EXPECT_NE(text.find("left out  sky             nothing that is shown reads 'sky'\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("left out  shadow of lamp  no caster in the light's frustum\n"),
              std::string::npos)
        << text;
}

TEST(ConventionsTest, the_tables_follow_their_enumerations) {
    for (std::size_t index = 0; index < std::size(formats); ++index) {
        EXPECT_EQ(static_cast<std::size_t>(formats[index].format), index);
    }
    EXPECT_EQ((ImageDesc{Format::rgba16f, 3, 5}).bytes(), 120U);
    EXPECT_EQ((ImageDesc{Format::d32, 2, 2, 0, 3}).bytes(), 48U);
    EXPECT_EQ((ImageDesc{Format::rgba8, 2, 2, 2}).bytes(), 32U);
}

} // namespace
} // namespace preview
