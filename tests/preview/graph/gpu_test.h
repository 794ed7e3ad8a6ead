// Base of the tests that run on a Vulkan device: lavapipe, with the validation layers and
// synchronisation validation on. Any message of theirs fails the test. The environment variable
// LUT_TEST_DEVICE names another device.
#pragma once

#include "preview/graph/execute.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace preview {

class GpuTest : public testing::Test {
  protected:
    /// One device a program: making one takes longer than most tests.
    static const gpu::Device& device() {
        static const gpu::Device made({wanted_device(), true, {}, {}});
        return made;
    }

    /// Part of a device's name.
    static std::string wanted_device() {
        const char* const wanted = std::getenv("LUT_TEST_DEVICE");
        return wanted != nullptr ? wanted : "llvmpipe";
    }

    void SetUp() override { messages_before_ = device().validation_messages().size(); }
    void TearDown() override {
        const auto messages = device().validation_messages();
        for (std::size_t index = messages_before_; index < messages.size(); ++index) {
            ADD_FAILURE() << messages[index];
        }
    }

    /// A sampled image from values of its texel type.
    template <class T>
    static gpu::Image upload(const ImageDesc& desc, const std::vector<T>& texels) {
        return gpu::make_image(device(), desc, std::as_bytes(std::span(texels)));
    }

    /// Runs the graph once and reads a presented image back as texels of type T.
    template <class T>
    static std::vector<T> run_and_read(const Graph& graph, ImageHandle presented) {
        Executor executor(device());
        executor.render(graph);
        return as<T>(executor.read_image(presented));
    }

    template <class T>
    static std::vector<T> as(const std::vector<std::byte>& bytes) {
        std::vector<T> values(bytes.size() / sizeof(T));
        std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
        return values;
    }

  private:
    std::size_t messages_before_ = 0;
};

} // namespace preview
