// The Vulkan objects behind one shape of graph: memory and views of the living transients, and each
// needed pass's pipeline and descriptor set. Internal to the executor.
#pragma once

#include "preview/gpu/memory.h"
#include "preview/gpu/pipeline.h"
#include "preview/graph/plan.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace preview {

/// The stages and accesses of a mask, and the usage that an access asks of its resource.
struct AccessFlags {
    vk::PipelineStageFlags2 stages;
    vk::AccessFlags2 memory;
    vk::ImageUsageFlags image_usage;
    vk::BufferUsageFlags buffer_usage;
};
/// Of an empty mask: all that came before.
AccessFlags flags_of(AccessMask accesses);
vk::ImageLayout vk_layout(Layout layout);

/// Everything of a graph that its Vulkan objects depend on, as bytes to compare.
std::string shape_of(const Graph& graph, const Plan& plan);

/// A buffer of Origin::data, kept from frame to frame.
struct DataBlock {
    gpu::Buffer buffer;
    std::vector<std::byte> bytes; ///< as last uploaded
};
using DataBlocks = std::map<std::string, DataBlock>;

/// What stands in for withheld handles, by Neutral.
struct NeutralResources {
    explicit NeutralResources(const gpu::Device& device);
    std::vector<gpu::Image> images;
    /// Where nothing is written, of numbers and of whole numbers: in place of targets that nobody
    /// reads.
    std::vector<gpu::Image> targets;
    gpu::Buffer buffer;
};

/// Images and buffers that outlive a frame, by name.
struct PersistentObjects {
    std::map<std::string, gpu::Image> images;
    std::map<std::string, gpu::Buffer> buffers;
};

struct RealisedPass {
    const gpu::Pipeline* pipeline = nullptr; ///< null for a fill
    std::optional<vk::raii::DescriptorSet> set;
};

class Realised {
  public:
    Realised(const gpu::Device& device, gpu::Pipelines& pipelines, const NeutralResources& neutral,
             DataBlocks& data, PersistentObjects& persistent, const Graph& graph, const Plan& plan);

    const gpu::Image& image(const Graph& graph, std::uint32_t version) const;
    const gpu::Buffer& buffer(const Graph& graph, std::uint32_t version) const;
    const gpu::Image& image_of_resource(const Graph& graph, std::uint32_t resource) const;
    /// By its place in Plan::needed.
    const RealisedPass& pass(std::size_t needed) const { return passes_[needed]; }
    std::uint64_t pool_bytes() const { return pool_bytes_; }
    std::uint64_t unshared_bytes() const { return unshared_bytes_; }

  private:
    // What passes do with each resource.
    struct Usage {
        std::vector<vk::ImageUsageFlags> image;
        std::vector<vk::BufferUsageFlags> buffer;
    };

    static Usage usage_of(const Graph& graph, const Plan& plan);
    void make_persistent(const Graph& graph, const Plan& plan);
    void make_transients(const Graph& graph, const Plan& plan);
    vk::MemoryRequirements make(const Resource& resource, std::uint32_t id, const Usage& usage);
    void bind(const Plan& plan, std::uint32_t memory_type, std::span<const std::size_t> members,
              std::span<const Extent> extents);
    void make_data_blocks(const Graph& graph);
    void make_descriptor_pool(const std::vector<gpu::PipelineKey>& keys);
    const gpu::Image& bound_image(const Graph& graph, const Use& use,
                                  const std::vector<bool>& version_lives) const;
    void write_set(const Graph& graph, const PassRecord& pass,
                   const std::vector<bool>& version_lives, RealisedPass& step);

    const gpu::Device& device_;
    gpu::Pipelines& pipelines_;
    const NeutralResources& neutral_;
    DataBlocks& data_;
    PersistentObjects& persistent_;
    std::vector<vk::raii::DeviceMemory> memory_;
    std::vector<std::optional<gpu::Image>> images_;   ///< by resource
    std::vector<std::optional<gpu::Buffer>> buffers_; ///< by resource
    vk::raii::DescriptorPool descriptors_ = nullptr;
    std::vector<RealisedPass> passes_;
    std::uint64_t pool_bytes_ = 0;
    std::uint64_t unshared_bytes_ = 0;
};

} // namespace preview
