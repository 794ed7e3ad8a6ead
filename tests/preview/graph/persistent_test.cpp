// Resources that outlive a frame: when their passes run, when they rest, and what is told of it;
// without a GPU.
#include "preview/graph/fingerprint.h"
#include "preview/graph/plan.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <tuple>

namespace preview {
namespace {

constexpr ImageDesc picture_size{Format::rgba16f, 4, 4};
constexpr const char* reason = "kept from an earlier frame: no light has moved";

/// What a frame's shadow maps are made from, and who reads them.
struct Maps {
    std::string name = "shadow maps";
    std::uint32_t side = 8;
    float lights[2] = {1, 2};
    float casters[4] = {1, 2, 3, 4};
    std::uint32_t triangles = 5;
    float bias = 1;
    std::uint32_t constant = 7;
    bool are_read = true;
};

ImageHandle add_maps(Graph& graph, const Maps& maps) {
    ImageHandle array = graph.persistent_image(maps.name, {Format::d32, maps.side, maps.side, 0, 2},
                                               "no light has moved");
    const BufferHandle casters = graph.data_of("casters", maps.casters);
    for (std::uint32_t layer = 0; layer < 2; ++layer) {
        Pass pass = graph.raster("shadow " + std::to_string(layer), "x.vert", "");
        pass.storage(casters);
        pass.push(maps.lights[layer]);
        pass.constants({maps.constant});
        pass.draws({{maps.triangles * 3, 0, 0, 1, 0}});
        RasterState state;
        state.depth_bias_slope = maps.bias;
        pass.state(state);
        array = layer == 0 ? pass.depth(array, 1, 0) : pass.depth_layer(array, 1, layer);
    }
    return array;
}

/// A picture that reads what it is given, presented.
void show(Graph& graph, ImageHandle read) {
    Pass pass = graph.compute("lit", "x.comp");
    pass.read(read);
    graph.present(pass.write(graph.image("lit", picture_size)));
}

Graph frame_of(const Maps& maps) {
    Graph graph;
    const ImageHandle array = add_maps(graph, maps);
    show(graph, maps.are_read ? array : ImageHandle{});
    return graph;
}

std::string order(const Graph& graph, const Plan& plan) {
    std::string names;
    for (const Step& step : plan.steps) {
        names += graph.passes()[step.pass].name + " ";
    }
    return names;
}

constexpr const char* all_run = "shadow 0 shadow 1 lit ";
constexpr const char* maps_rest = "lit ";

TEST(PersistentTest, the_first_frame_draws_and_the_next_ones_do_not) {
    const Graph graph = frame_of({});
    Plan plan = make_plan(graph);
    EXPECT_EQ(order(graph, plan), all_run);
    EXPECT_EQ(plan.made.size(), 1U);
    for (int frame = 0; frame < 3; ++frame) {
        plan = make_plan(graph, plan.held);
        EXPECT_EQ(order(graph, plan), maps_rest) << frame;
        EXPECT_TRUE(plan.made.empty()) << frame;
        EXPECT_EQ(plan.reasons[0], reason);
        EXPECT_EQ(plan.reasons[1], reason);
    }
}

TEST(PersistentTest, whatever_it_is_made_from_draws_it_again_once) {
    const std::function<void(Maps&)> changes[] = {
        [](Maps& maps) { maps.lights[1] = 3; },
        [](Maps& maps) { maps.casters[3] = 0; },
        [](Maps& maps) { maps.triangles = 6; },
        [](Maps& maps) { maps.bias = 2; },
        [](Maps& maps) { maps.constant = 8; },
        [](Maps& maps) { maps.side = 16; },
        [](Maps& maps) { maps.name = "others"; },
        [](Maps& maps) { std::swap(maps.lights[0], maps.lights[1]); },
    };
    for (std::size_t change = 0; change < std::size(changes); ++change) {
        const HeldResources before = make_plan(frame_of({})).held;
        Maps maps;
        changes[change](maps);
        const Graph graph = frame_of(maps);
        const Plan plan = make_plan(graph, before);
        EXPECT_EQ(order(graph, plan), all_run) << change;
        EXPECT_EQ(order(graph, make_plan(graph, plan.held)), maps_rest) << change;
        EXPECT_EQ(plan.held.size(), 1U) << change;
    }
}

TEST(PersistentTest, what_it_is_not_made_from_leaves_it) {
    const HeldResources before = make_plan(frame_of({})).held;
    Graph graph;
    std::ignore = graph.data_of("view", 3.0F);
    Pass other = graph.compute("other", "y.comp");
    const ImageHandle seen = other.write(graph.image("other", picture_size));
    graph.present(seen);
    show(graph, add_maps(graph, {}));
    EXPECT_EQ(order(graph, make_plan(graph, before)), "other lit ");
}

TEST(PersistentTest, a_frame_that_does_not_need_it_drops_it) {
    const Graph with = frame_of({});
    const HeldResources before = make_plan(with).held;
    Graph without;
    show(without, {});
    Maps unread;
    unread.are_read = false;
    for (const Graph& graph : {without, frame_of(unread)}) {
        const Plan plan = make_plan(graph, before);
        EXPECT_EQ(order(graph, plan), maps_rest);
        EXPECT_TRUE(plan.held.empty());
        EXPECT_EQ(order(with, make_plan(with, plan.held)), all_run);
    }
    const Graph graph = frame_of(unread);
    EXPECT_EQ(make_plan(graph, before).reasons[0], "nothing that is shown reads 'shadow maps'");
}

TEST(PersistentTest, the_objects_of_a_frame_are_the_same_whether_a_pass_runs_or_rests) {
    const Graph graph = frame_of({});
    const Plan first = make_plan(graph);
    const Plan second = make_plan(graph, first.held);
    EXPECT_EQ(first.needed, second.needed);
    EXPECT_EQ(first.version_lives, second.version_lives);
    ASSERT_EQ(first.lifetimes.size(), second.lifetimes.size());
    for (std::size_t i = 0; i < first.lifetimes.size(); ++i) {
        EXPECT_EQ(first.lifetimes[i].first, second.lifetimes[i].first);
        EXPECT_EQ(first.lifetimes[i].last, second.lifetimes[i].last);
    }
    EXPECT_EQ(second.steps[0].needed, 2U);
}

TEST(PersistentTest, it_shares_no_memory) {
    const Graph graph = frame_of({});
    for (const Lifetime& lifetime : make_plan(graph).lifetimes) {
        EXPECT_EQ(graph.resources()[lifetime.resource].origin, Origin::transient);
    }
}

/// The barrier of a resource before a step; none: the default.
Barrier barrier_of(const Graph& graph, const Step& step, const std::string& name) {
    for (const Barrier& barrier : step.barriers) {
        if (graph.resources()[barrier.resource].name == name) {
            return barrier;
        }
    }
    return {};
}

TEST(PersistentTest, reading_it_again_in_the_same_way_needs_no_barrier) {
    const Graph graph = frame_of({});
    const Plan first = make_plan(graph);
    EXPECT_EQ(barrier_of(graph, first.steps[2], "shadow maps"),
              (Barrier{0, mask(Access::depth_write), mask(Access::compute_sample), Layout::depth,
                       Layout::read_only}));
    const Plan second = make_plan(graph, first.held);
    EXPECT_EQ(barrier_of(graph, second.steps[0], "shadow maps"), Barrier{});
}

TEST(PersistentTest, drawing_it_again_waits_for_the_readers_of_the_frame_before) {
    const Plan first = make_plan(frame_of({}));
    Maps moved;
    moved.lights[0] = 9;
    const Graph graph = frame_of(moved);
    const Plan second = make_plan(graph, first.held);
    EXPECT_TRUE(second.made.empty()); // the same memory
    EXPECT_EQ(barrier_of(graph, second.steps[0], "shadow maps"),
              (Barrier{0, mask(Access::depth_write) | mask(Access::compute_sample),
                       mask(Access::depth_write), Layout::undefined, Layout::depth}));
}

TEST(PersistentTest, a_presented_one_is_read_again_from_where_it_stood) {
    Graph graph;
    const ImageHandle maps = add_maps(graph, {});
    show(graph, maps);
    graph.present(maps);
    const Plan first = make_plan(graph);
    EXPECT_EQ(first.held.at("shadow maps").state.layout, Layout::transfer_src);
    const Plan second = make_plan(graph, first.held);
    EXPECT_EQ(order(graph, second), maps_rest);
    const Barrier back = barrier_of(graph, second.steps[0], "shadow maps");
    EXPECT_EQ(back.old_layout, Layout::transfer_src);
    EXPECT_EQ(back.new_layout, Layout::read_only);
}

TEST(PersistentTest, a_frame_that_presents_it_finds_what_one_that_only_reads_it_has_made) {
    const HeldResources before = make_plan(frame_of({})).held;
    Graph graph;
    const ImageHandle maps = add_maps(graph, {});
    show(graph, maps);
    graph.present(maps);
    const Plan plan = make_plan(graph, before);
    EXPECT_TRUE(plan.made.empty());
    EXPECT_EQ(order(graph, plan), maps_rest);
}

TEST(PersistentTest, an_access_that_it_was_not_made_for_makes_it_anew) {
    const HeldResources before = make_plan(frame_of({})).held;
    Graph graph;
    const ImageHandle maps = add_maps(graph, {});
    Pass pass = graph.raster("lit", "x.vert", "x.frag");
    pass.read(maps);
    graph.present(pass.color(graph.image("lit", picture_size), {}));
    const Plan plan = make_plan(graph, before);
    EXPECT_EQ(plan.made.size(), 1U);
    EXPECT_EQ(order(graph, plan), all_run);
    // The one with more serves those that ask for less.
    const Graph less = frame_of({});
    EXPECT_EQ(order(less, make_plan(less, plan.held)), maps_rest);
}

TEST(PersistentTest, passes_that_only_lead_to_it_rest_with_it) {
    Graph graph;
    const BufferHandle zeros = graph.fill("clear", graph.buffer("counters", 16), 0);
    Pass sort = graph.compute("sort", "x.comp");
    sort.storage(zeros);
    const BufferHandle sorted =
        sort.write(graph.persistent_buffer("sorted", 64, "the points are the same"));
    Pass draw = graph.compute("draw", "x.comp");
    draw.storage(sorted);
    graph.present(draw.write(graph.image("picture", picture_size)));
    const Plan first = make_plan(graph);
    EXPECT_EQ(order(graph, first), "clear sort draw ");
    const Plan second = make_plan(graph, first.held);
    EXPECT_EQ(order(graph, second), "draw ");
    EXPECT_EQ(second.reasons[0], "what reads 'counters' is kept from an earlier frame");
    EXPECT_EQ(second.reasons[1], "kept from an earlier frame: the points are the same");

    Graph changed;
    const BufferHandle ones = changed.fill("clear", changed.buffer("counters", 16), 1);
    Pass again = changed.compute("sort", "x.comp");
    again.storage(ones);
    changed.present(
        again.write(changed.persistent_buffer("sorted", 64, "the points are the same")));
    EXPECT_EQ(order(changed, make_plan(changed, first.held)), "clear sort ");
}

TEST(PersistentTest, a_pass_that_runs_for_another_result_takes_all_writers_with_it) {
    Graph graph;
    const auto declare = [&](bool counts) {
        graph = {};
        ImageHandle maps =
            graph.persistent_image("maps", {Format::r32ui, 4, 4}, "nothing has changed");
        Pass first = graph.compute("first", "x.comp");
        maps = first.write(maps);
        Pass second = graph.compute("second", "x.comp");
        maps = second.modify(maps);
        const BufferHandle counted = second.write(graph.buffer("counted", 16));
        if (counts) {
            graph.present(counted);
        }
        show(graph, maps);
    };
    declare(true);
    Plan plan = make_plan(graph);
    plan = make_plan(graph, plan.held);
    EXPECT_EQ(order(graph, plan), "first second lit ");
    declare(false);
    plan = make_plan(graph, plan.held);
    EXPECT_EQ(order(graph, plan), "lit ");
}

TEST(PersistentTest, a_target_that_is_written_and_not_read_is_right_for_nothing) {
    const auto declare = [](bool reads_depth) {
        Graph graph;
        Pass pass = graph.raster("g-buffer", "x.vert", "x.frag");
        const ImageHandle color = pass.color(graph.image("color", picture_size), {});
        const ImageHandle depth = pass.depth(
            graph.persistent_image("depth", {Format::d32, 4, 4}, "nothing has moved"), 1);
        graph.present(color);
        if (reads_depth) {
            show(graph, depth);
        }
        return graph;
    };
    const Plan unread = make_plan(declare(false));
    EXPECT_EQ(unread.held.at("depth").fingerprint, "");
    const Graph reads = declare(true);
    EXPECT_EQ(order(reads, make_plan(reads, unread.held)), "g-buffer lit ");
}

TEST(PersistentTest, what_no_pass_of_the_frame_writes_cannot_be_read) {
    Graph graph;
    const BufferHandle empty = graph.persistent_buffer("history", 16, "it is never right");
    Pass pass = graph.compute("reader", "x.comp");
    EXPECT_THROW(pass.storage(empty), std::logic_error);
    EXPECT_THROW(graph.present(empty), std::logic_error);
}

TEST(PersistentTest, two_of_one_name_are_an_error) {
    Graph graph;
    std::ignore = graph.persistent_buffer("sorted", 16, "");
    EXPECT_THROW(std::ignore = graph.persistent_image("sorted", picture_size, ""),
                 std::logic_error);
}

TEST(PersistentTest, overwriting_what_was_read_is_an_error_that_names_all_three) {
    Graph graph;
    Pass first = graph.compute("first", "x.comp");
    const BufferHandle one = first.write(graph.persistent_buffer("sorted", 16, ""));
    Pass reader = graph.compute("reader", "x.comp");
    reader.storage(one);
    Pass second = graph.compute("second", "x.comp");
    try {
        std::ignore = second.modify(one);
        FAIL();
    } catch (const std::logic_error& error) {
        const std::string text = error.what();
        for (const char* name : {"'second'", "'sorted'", "'reader'"}) {
            EXPECT_NE(text.find(name), std::string::npos) << text;
        }
    }
}

TEST(PersistentTest, the_explanation_gives_the_reason) {
    const Graph graph = frame_of({});
    const std::string text = explain(graph, make_plan(graph, make_plan(graph).held));
    EXPECT_NE(text.find("left out  shadow 0  " + std::string(reason) + "\n"), std::string::npos)
        << text;
    EXPECT_NE(text.find("kept      lit       writes lit 4x4\n"), std::string::npos) << text;
}

TEST(FingerprintTest, names_do_not_count_and_the_bytes_of_inputs_do) {
    const auto print = [](const char* pass_name, const char* block, float value) {
        Graph graph;
        Pass pass = graph.compute(pass_name, "x.comp");
        pass.uniform(graph.data_of(block, value));
        return fingerprint_of(graph, pass.write(graph.buffer("out", 16)).version);
    };
    EXPECT_EQ(print("a", "b", 1), print("c", "d", 1));
    EXPECT_NE(print("a", "b", 1), print("a", "b", 2));
    EXPECT_NE(print("a", "b", 0.0F), "");
}

TEST(FingerprintTest, the_same_input_twice_is_not_two_equal_inputs) {
    const auto print = [](bool is_same) {
        Graph graph;
        const auto node = [&](std::initializer_list<ImageHandle> inputs) {
            Pass pass = graph.compute("node", "x.comp");
            for (const ImageHandle input : inputs) {
                pass.read(input);
            }
            return pass.write(graph.image("image", picture_size));
        };
        const ImageHandle one = node({});
        const ImageHandle two = node({});
        const ImageHandle left = node({one, two});
        return fingerprint_of(graph, node({left, is_same ? one : two}).version);
    };
    EXPECT_NE(print(true), print(false));
}

} // namespace
} // namespace preview
