#include "lutlib/error.h"
#include "preview/gpu/pipeline.h"
#include "preview/passes/copy.h"
#include "tests/preview/graph/gpu_test.h"

#include <cstring>
#include <memory>

namespace preview {
namespace {

using ExecuteTest = GpuTest;

std::vector<float> ramp(std::uint32_t width, std::uint32_t height) {
    std::vector<float> texels(std::size_t{4} * width * height);
    for (std::size_t index = 0; index < texels.size(); ++index) {
        texels[index] = static_cast<float>(index) / 7;
    }
    return texels;
}

TEST_F(ExecuteTest, copies_an_image_of_odd_size_bit_for_bit) {
    const ImageDesc desc{Format::rgba32f, 135, 67};
    const auto texels = ramp(desc.width, desc.height);
    const gpu::Image image = upload(desc, texels);
    Graph graph;
    const ImageHandle copy = add_copy(graph, graph.import("source", image, desc), Format::rgba32f);
    graph.present(copy);
    EXPECT_EQ(run_and_read<float>(graph, copy), texels);
}

TEST_F(ExecuteTest, a_steady_frame_allocates_and_rebuilds_nothing) {
    const ImageDesc desc{Format::rgba32f, 64, 32};
    const gpu::Image image = upload(desc, ramp(desc.width, desc.height));
    const auto declare = [&](Format format) {
        Graph graph;
        const ImageHandle first = add_copy(graph, graph.import("source", image, desc), format);
        graph.present(add_copy(graph, first, format));
        return graph;
    };
    Executor executor(device());
    for (int frame = 0; frame < 3; ++frame) {
        executor.render(declare(Format::rgba32f));
    }
    const std::uint64_t allocations = device().allocation_count();
    for (int frame = 0; frame < 5; ++frame) {
        executor.render(declare(Format::rgba32f));
    }
    EXPECT_EQ(device().allocation_count(), allocations);
    EXPECT_EQ(executor.rebuilds(), 1U);
    executor.render(declare(Format::rgba16f));
    EXPECT_EQ(executor.rebuilds(), 2U);
}

TEST_F(ExecuteTest, a_chain_of_copies_shares_memory_and_keeps_its_values) {
    const ImageDesc desc{Format::rgba32f, 64, 64};
    const auto texels = ramp(desc.width, desc.height);
    const gpu::Image image = upload(desc, texels);
    Graph graph;
    ImageHandle last = graph.import("source", image, desc);
    for (int copy = 0; copy < 6; ++copy) {
        last = add_copy(graph, last, Format::rgba32f);
    }
    graph.present(last);
    Executor executor(device());
    executor.render(graph);
    EXPECT_EQ(as<float>(executor.read_image(last)), texels);
    EXPECT_LE(executor.pool_bytes() * 5, executor.unshared_bytes() * 2);
}

TEST_F(ExecuteTest, a_withheld_image_reads_as_its_stand_in) {
    Graph graph;
    Pass pass = graph.compute("copy of nothing", "copy.comp");
    pass.read({}, Neutral::white);
    const ImageHandle out = pass.write(graph.image("out", {Format::rgba8, 1, 1}));
    pass.dispatch(1);
    graph.present(out);
    EXPECT_EQ(run_and_read<std::uint8_t>(graph, out), (std::vector<std::uint8_t>(4, 255)));
}

TEST_F(ExecuteTest, a_filled_buffer_comes_back_and_is_known_by_name_once_finished) {
    Graph graph;
    const BufferHandle filled = graph.fill("clear", graph.buffer("counters", 16), 0x01020304);
    graph.present(filled);
    Executor executor(device());
    EXPECT_TRUE(executor.finished_buffer("counters").empty());
    executor.render(graph);
    EXPECT_EQ(as<std::uint32_t>(executor.read_buffer(filled)),
              (std::vector<std::uint32_t>(4, 0x01020304)));
    EXPECT_EQ(executor.finished_buffer("counters").size(), 16U);
}

TEST_F(ExecuteTest, a_repeated_frame_presents_again_and_computes_nothing) {
    const ImageDesc desc{Format::rgba32f, 64, 32};
    const auto texels = ramp(desc.width, desc.height);
    const gpu::Image image = upload(desc, texels);
    Graph graph;
    const ImageHandle copy = add_copy(graph, graph.import("source", image, desc), Format::rgba32f);
    graph.present(copy);
    Executor executor(device());
    EXPECT_THROW(executor.repeat({}), std::logic_error);
    executor.render(graph);
    const auto times = executor.timings();
    const gpu::Buffer seen(device(), desc.bytes(), vk::BufferUsageFlagBits::eTransferDst,
                           gpu::BufferMemory::readback);
    FrameEnd end;
    end.record = [&](const vk::raii::CommandBuffer& commands) {
        commands.copyImageToBuffer(
            executor.image(copy).vk(), vk::ImageLayout::eTransferSrcOptimal, seen.vk(),
            vk::BufferImageCopy(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {},
                                {desc.width, desc.height, 1}));
    };
    for (int frame = 0; frame < 3; ++frame) {
        executor.repeat(end);
    }
    ASSERT_EQ(executor.timings().size(), times.size());
    EXPECT_EQ(executor.timings()[0].milliseconds, times[0].milliseconds);
    EXPECT_EQ(as<float>({seen.mapped().begin(), seen.mapped().end()}), texels);
    EXPECT_EQ(as<float>(executor.read_image(copy)), texels);
    executor.render(graph);
    EXPECT_EQ(as<float>(executor.read_image(copy)), texels);
}

TEST_F(ExecuteTest, makes_no_pipeline_that_another_has_made_and_outlives_it) {
    const ImageDesc desc{Format::rgba32f, 16, 9};
    const auto texels = ramp(desc.width, desc.height);
    const gpu::Image image = upload(desc, texels);
    Graph graph;
    const ImageHandle copy = add_copy(graph, graph.import("source", image, desc), Format::rgba32f);
    graph.present(copy);
    auto first = std::make_unique<Executor>(device());
    first->render(graph);
    const std::size_t made = device().pipelines().size();
    EXPECT_GE(made, 1U);
    Executor second(device(), 1);
    second.render(graph);
    EXPECT_EQ(device().pipelines().size(), made);
    first.reset();
    second.render(graph);
    const std::vector<std::byte> bytes = second.read_image(copy);
    ASSERT_EQ(bytes.size(), texels.size() * sizeof(float));
    EXPECT_EQ(std::memcmp(bytes.data(), texels.data(), bytes.size()), 0);
}

TEST_F(ExecuteTest, persistent_resources_are_made_once_and_survive_frames_and_other_shapes) {
    const ImageDesc desc{Format::rgba32f, 64, 32};
    const auto texels = ramp(desc.width, desc.height);
    const gpu::Image image = upload(desc, texels);
    Executor executor(device());
    // The words of a persistent buffer and, of a persistent image, a copy in that format.
    const auto render = [&](std::uint32_t word, Format format) {
        Graph graph;
        Pass pass = graph.compute("copy once", "copy.comp");
        pass.read(graph.import("source", image, desc));
        const ImageHandle once =
            pass.write(graph.persistent_image("once", desc, "the source is the same"));
        pass.dispatch_over(desc.width, desc.height);
        const ImageHandle copy = add_copy(graph, once, format);
        const BufferHandle words =
            graph.fill("fill", graph.persistent_buffer("words", 16, "the word is the same"), word);
        graph.present(copy);
        graph.present(words);
        executor.render(graph);
        EXPECT_EQ(as<std::uint32_t>(executor.read_buffer(words)),
                  (std::vector<std::uint32_t>(4, word)));
        if (format == Format::rgba32f) {
            EXPECT_EQ(as<float>(executor.read_image(copy)), texels);
        }
        return executor.plan().steps.size();
    };
    EXPECT_EQ(render(1, Format::rgba32f), 3U);
    EXPECT_EQ(render(1, Format::rgba32f), 1U); // the copy
    EXPECT_EQ(render(2, Format::rgba32f), 2U);
    EXPECT_EQ(render(2, Format::rgba32f), 1U);
    EXPECT_EQ(executor.rebuilds(), 1U);
    EXPECT_EQ(render(2, Format::rgba16f), 1U); // other transients
    EXPECT_EQ(executor.rebuilds(), 2U);
    EXPECT_EQ(render(2, Format::rgba32f), 1U);
}

TEST_F(ExecuteTest, a_persistent_resource_that_frames_do_not_need_is_given_back) {
    const ImageDesc desc{Format::rgba32f, 64, 32};
    const gpu::Image image = upload(desc, ramp(desc.width, desc.height));
    Executor executor(device());
    const auto render = [&](bool is_needed) {
        Graph graph;
        const ImageHandle source = graph.import("source", image, desc);
        Pass pass = graph.compute("copy once", "copy.comp");
        pass.read(source);
        const ImageHandle once =
            pass.write(graph.persistent_image("once", desc, "the source is the same"));
        pass.dispatch_over(desc.width, desc.height);
        graph.present(add_copy(graph, is_needed ? once : source, Format::rgba32f));
        executor.render(graph);
    };
    render(true);
    EXPECT_EQ(executor.plan().held.size(), 1U);
    EXPECT_EQ(executor.persistent_count(), 1U);
    render(false);
    EXPECT_EQ(executor.persistent_count(), 0U);
    render(true);
    EXPECT_EQ(executor.plan().steps.size(), 2U);
    EXPECT_EQ(executor.persistent_count(), 1U);
}

TEST_F(ExecuteTest, every_step_is_timed_by_name) {
    const ImageDesc desc{Format::rgba32f, 64, 32};
    const gpu::Image image = upload(desc, ramp(desc.width, desc.height));
    Graph graph;
    graph.present(add_copy(graph, graph.import("source", image, desc), Format::rgba8));
    Executor executor(device());
    executor.render(graph);
    const auto times = executor.timings();
    ASSERT_EQ(times.size(), 1U);
    EXPECT_EQ(times[0].name, "copy");
    EXPECT_GT(times[0].milliseconds, 0);
}

TEST(DeviceTest, an_unknown_device_is_an_error_that_names_those_there_are) {
    try {
        const gpu::Device device({"no such thing", false, {}, {}});
        FAIL();
    } catch (const lutlib::Error& error) {
        for (const gpu::DeviceInfo& known : gpu::list_devices()) {
            EXPECT_NE(std::string(error.what()).find(known.name), std::string::npos)
                << error.what();
        }
    }
}

} // namespace
} // namespace preview
