// Runs graphs with Vulkan: gives the living transients memory, pipelines and descriptors, and
// records one command buffer a frame.
//
// All of that is made when a graph differs in shape from the one before (other passes, sizes,
// shaders or inputs) and kept while it does not: a steady frame allocates and uploads nothing, and
// only push constants, group counts, draws and changed data() blocks move. The executor owns the
// persistent resources too: what one frame made, the next finds.
#pragma once

#include "preview/gpu/device.h"
#include "preview/gpu/memory.h"
#include "preview/graph/plan.h"

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace preview {

struct StepTime {
    std::string name;
    double milliseconds = 0;
};

/// What a frame waits for and signals beyond itself, and commands at its end (to a swapchain).
struct FrameEnd {
    std::vector<vk::SemaphoreSubmitInfo> waits;
    std::vector<vk::SemaphoreSubmitInfo> signals;
    /// Presented images stand in eTransferSrcOptimal when this is called.
    std::function<void(const vk::raii::CommandBuffer&)> record;
};

class Realised;

class Executor {
  public:
    explicit Executor(const gpu::Device& device, std::uint32_t frames_in_flight = 2);
    Executor(const Executor&) = delete;
    Executor& operator=(const Executor&) = delete;
    ~Executor();

    /// Plans, records and submits the graph. Waits only for the frame whose slot it takes over.
    /// Imported resources must live until wait() or until frames_in_flight later frames.
    void render(const Graph& graph, const FrameEnd& end = {});
    /// Ends one more frame with what the last one presented; computes nothing, and timings() and
    /// buffers stay the last one's. Waits for that to be finished.
    void repeat(const FrameEnd& end);
    void wait();

    /// The image behind a presented handle of the last graph, in eTransferSrcOptimal.
    const gpu::Image& image(ImageHandle presented) const;
    /// The texels of a presented image of the last graph. Waits.
    std::vector<std::byte> read_image(ImageHandle presented);
    /// The contents of a presented buffer, of the last graph. Waits.
    std::vector<std::byte> read_buffer(BufferHandle presented);
    /// The contents of the presented buffer of that name in the newest frame that has finished;
    /// empty when there is none. Does not wait.
    std::vector<std::byte> finished_buffer(const std::string& name) const;
    /// The last frame's GPU time for each step. Waits. Empty where the device has no timestamps.
    std::vector<StepTime> timings();

    const Plan& plan() const { return plan_; }
    /// How often a graph's shape changed; a steady frame leaves it.
    std::uint64_t rebuilds() const { return rebuilds_; }
    /// How many data() blocks have been uploaded.
    std::uint64_t uploads() const { return uploads_; }
    /// Bytes of the transients' pool, and what they would take without sharing.
    std::uint64_t pool_bytes() const;
    std::uint64_t unshared_bytes() const;
    /// How many images and buffers are kept for later frames.
    std::size_t persistent_count() const;

  private:
    struct Slot;
    struct Shared; ///< stand-ins, data blocks, persistent objects: outlive every shape
    struct PresentedResource {
        std::string name;
        const gpu::Image* image = nullptr;
    };

    void record(const Graph& graph, Slot& slot, const FrameEnd& end);
    void upload_changed(const Graph& graph, const vk::raii::CommandBuffer& commands);
    void record_barriers(const Graph& graph, std::span<const Barrier> barriers,
                         const vk::raii::CommandBuffer& commands);
    void record_step(const Graph& graph, std::size_t index,
                     const vk::raii::CommandBuffer& commands);
    void record_raster(const Graph& graph, const PassRecord& pass,
                       const vk::raii::CommandBuffer& commands);
    void record_presented(const Graph& graph, Slot& slot, const vk::raii::CommandBuffer& commands);

    const gpu::Device& device_;
    std::unique_ptr<Shared> shared_;
    std::vector<Slot> slots_;
    std::unique_ptr<Slot> repeated_;
    std::unique_ptr<Realised> realised_;
    Plan plan_;
    HeldResources held_; ///< what the last submitted frame left
    std::string shape_;
    std::map<std::uint32_t, PresentedResource> presented_; ///< by version, of the last graph
    std::size_t slot_ = 0;                                 ///< of the last frame
    std::uint64_t rebuilds_ = 0;
    std::uint64_t uploads_ = 0;

    // Kept for their capacity from frame to frame.
    std::vector<vk::ImageMemoryBarrier2> image_barriers_;
    std::vector<vk::MemoryBarrier2> memory_barriers_;
    std::vector<vk::RenderingAttachmentInfo> colors_;
    std::vector<Barrier> end_barriers_;
};

} // namespace preview
