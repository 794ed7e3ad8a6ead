#include "preview/graph/realise.h"

#include "preview/graph/shape.h"

#include <algorithm>
#include <cstring>

namespace preview {

namespace {

using Stage = vk::PipelineStageFlagBits2;
using Memory = vk::AccessFlagBits2;
using ImageUsage = vk::ImageUsageFlagBits;
using BufferUsage = vk::BufferUsageFlagBits;

/// In the order of the enumeration Access.
const AccessFlags access_flags[] = {
    {Stage::eComputeShader, Memory::eShaderSampledRead, ImageUsage::eSampled, {}},
    {Stage::eVertexShader | Stage::eFragmentShader,
     Memory::eShaderSampledRead,
     ImageUsage::eSampled,
     {}},
    {Stage::eComputeShader,
     Memory::eShaderStorageRead | Memory::eUniformRead,
     {},
     BufferUsage::eStorageBuffer | BufferUsage::eUniformBuffer},
    {Stage::eVertexShader | Stage::eFragmentShader,
     Memory::eShaderStorageRead | Memory::eUniformRead,
     {},
     BufferUsage::eStorageBuffer | BufferUsage::eUniformBuffer},
    {Stage::eIndexInput, Memory::eIndexRead, {}, BufferUsage::eIndexBuffer},
    {Stage::eDrawIndirect, Memory::eIndirectCommandRead, {}, BufferUsage::eIndirectBuffer},
    {Stage::eComputeShader, Memory::eShaderStorageRead | Memory::eShaderStorageWrite,
     ImageUsage::eStorage, BufferUsage::eStorageBuffer},
    {Stage::eColorAttachmentOutput,
     Memory::eColorAttachmentRead | Memory::eColorAttachmentWrite,
     ImageUsage::eColorAttachment,
     {}},
    {Stage::eEarlyFragmentTests | Stage::eLateFragmentTests,
     Memory::eDepthStencilAttachmentRead | Memory::eDepthStencilAttachmentWrite,
     ImageUsage::eDepthStencilAttachment,
     {}},
    {Stage::eAllTransfer, Memory::eTransferRead, ImageUsage::eTransferSrc,
     BufferUsage::eTransferSrc},
    {Stage::eAllTransfer, Memory::eTransferWrite, ImageUsage::eTransferDst,
     BufferUsage::eTransferDst},
};
static_assert(std::size(access_flags) == access_count);

/// In the order of the enumeration Layout.
constexpr vk::ImageLayout layouts[] = {
    vk::ImageLayout::eUndefined,
    vk::ImageLayout::eGeneral,
    vk::ImageLayout::eReadOnlyOptimal,
    vk::ImageLayout::eColorAttachmentOptimal,
    vk::ImageLayout::eDepthAttachmentOptimal,
    vk::ImageLayout::eTransferSrcOptimal,
    vk::ImageLayout::eTransferDstOptimal,
};

void add_place(ByteText& shape, const Resource& resource) {
    shape.add(resource.origin);
    add_resource(shape, resource);
    if (resource.origin == Origin::data || resource.origin == Origin::persistent) {
        shape.add_text(resource.name);
    }
}

gpu::PipelineKey key_of(const Graph& graph, const Plan& plan, const PassRecord& pass) {
    gpu::PipelineKey key;
    key.shader = pass.shader;
    key.fragment_shader = pass.fragment_shader;
    key.raster = pass.kind == PassKind::raster;
    key.constants = pass.constants;
    key.push_bytes = pass.push_bytes;
    key.state = pass.raster;
    if (const std::optional<std::uint32_t> bits = read_targets(pass, plan.version_lives)) {
        key.constants.push_back(*bits);
    }
    for (const Use& use : pass.uses) {
        if (use.binding != BindingType::none) {
            key.bindings.push_back(use.binding);
        }
        if (use.access == Access::color_write) {
            key.colors.push_back(plan.version_lives[use.version]
                                     ? std::optional(graph.resource_of(use.version).image.format)
                                     : std::nullopt);
        }
        if (use.access == Access::depth_write) {
            key.depth = graph.resource_of(use.version).image.format;
        }
    }
    return key;
}

std::vector<std::byte> bytes_of(float value) {
    std::vector<std::byte> bytes(sizeof value);
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

} // namespace

AccessFlags flags_of(AccessMask accesses) {
    if (accesses == 0) {
        return {Stage::eAllCommands, Memory::eMemoryRead | Memory::eMemoryWrite, {}, {}};
    }
    AccessFlags all;
    for (unsigned bit = 0; bit < access_count; ++bit) {
        if ((accesses >> bit & 1U) == 0) {
            continue;
        }
        all.stages |= access_flags[bit].stages;
        all.memory |= access_flags[bit].memory;
        all.image_usage |= access_flags[bit].image_usage;
        all.buffer_usage |= access_flags[bit].buffer_usage;
    }
    return all;
}

vk::ImageLayout vk_layout(Layout layout) {
    return layouts[static_cast<std::size_t>(layout)];
}

std::string shape_of(const Graph& graph, const Plan& plan) {
    ByteText shape;
    for (const std::uint32_t needed : plan.needed) {
        const PassRecord& pass = graph.passes()[needed];
        shape.add(pass.kind);
        shape.add_text(pass.shader);
        shape.add_text(pass.fragment_shader);
        shape.add(pass.push_bytes);
        for (const std::uint32_t word : pass.constants) {
            shape.add(word);
        }
        add_raster_state(shape, pass.raster);
        for (const Use& use : pass.uses) {
            add_binding(shape, use);
            if (use.version == Version::none) {
                continue;
            }
            shape.add(bool{plan.version_lives[use.version]});
            const std::uint32_t resource = graph.versions()[use.version].resource;
            shape.add(resource);
            add_place(shape, graph.resources()[resource]);
        }
    }
    for (const std::uint32_t version : graph.presented()) {
        shape.add(version);
    }
    return shape.take();
}

NeutralResources::NeutralResources(const gpu::Device& device)
    : buffer(gpu::make_buffer(device, std::vector<std::byte>(256))) {
    const std::vector<std::byte> zeros(4);
    const std::vector<std::byte> ones(4, std::byte{0xff});
    // In the order of the enumeration Neutral.
    images.push_back(gpu::make_image(device, {Format::rgba8, 1, 1}, zeros));
    images.push_back(gpu::make_image(device, {Format::rgba8, 1, 1}, ones));
    images.push_back(gpu::make_image(device, {Format::rgba8, 1, 1, 1}, zeros));
    images.push_back(gpu::make_image(device, {Format::d32, 1, 1, 0, 1}, bytes_of(1)));
    images.push_back(gpu::make_image(device, {Format::r32ui, 1, 1}, zeros));
    for (const Format format : {Format::rgba8, Format::r32ui}) {
        targets.push_back(gpu::make_target(device, {format, 1, 1}));
    }
}

Realised::Realised(const gpu::Device& device, gpu::Pipelines& pipelines,
                   const NeutralResources& neutral, DataBlocks& data, PersistentObjects& persistent,
                   const Graph& graph, const Plan& plan)
    : device_(device), pipelines_(pipelines), neutral_(neutral), data_(data),
      persistent_(persistent) {
    make_persistent(graph, plan);
    make_transients(graph, plan);
    make_data_blocks(graph);
    std::vector<gpu::PipelineKey> keys;
    for (const std::uint32_t needed : plan.needed) {
        keys.push_back(key_of(graph, plan, graph.passes()[needed]));
    }
    make_descriptor_pool(keys);
    passes_.resize(plan.needed.size());
    for (std::size_t index = 0; index < plan.needed.size(); ++index) {
        const PassRecord& pass = graph.passes()[plan.needed[index]];
        if (pass.kind == PassKind::fill) {
            continue;
        }
        passes_[index].pipeline = &pipelines_.get(keys[index]);
        if (!keys[index].bindings.empty()) {
            write_set(graph, pass, plan.version_lives, passes_[index]);
        }
    }
}

const gpu::Image& Realised::image(const Graph& graph, std::uint32_t version) const {
    return image_of_resource(graph, graph.versions()[version].resource);
}

const gpu::Image& Realised::image_of_resource(const Graph& graph, std::uint32_t id) const {
    const Resource& resource = graph.resources()[id];
    if (resource.origin == Origin::persistent) {
        return persistent_.images.at(resource.name);
    }
    return resource.imported_image != nullptr ? *resource.imported_image : images_[id].value();
}

const gpu::Buffer& Realised::buffer(const Graph& graph, std::uint32_t version) const {
    const std::uint32_t id = graph.versions()[version].resource;
    const Resource& resource = graph.resources()[id];
    if (resource.origin == Origin::data) {
        return data_.at(resource.name).buffer;
    }
    if (resource.origin == Origin::persistent) {
        return persistent_.buffers.at(resource.name);
    }
    return resource.imported_buffer != nullptr ? *resource.imported_buffer : buffers_[id].value();
}

void Realised::make_persistent(const Graph& graph, const Plan& plan) {
    const auto is_dropped = [&](const auto& object) { return !plan.held.contains(object.first); };
    std::erase_if(persistent_.images, is_dropped);
    std::erase_if(persistent_.buffers, is_dropped);
    for (const std::uint32_t id : plan.made) {
        const Resource& resource = graph.resources()[id];
        const AccessFlags flags = flags_of(plan.held.at(resource.name).accesses);
        persistent_.images.erase(resource.name);
        persistent_.buffers.erase(resource.name);
        if (resource.kind == ResourceKind::image) {
            persistent_.images.emplace(resource.name,
                                       gpu::Image(device_, resource.image, flags.image_usage));
        } else {
            persistent_.buffers.emplace(resource.name,
                                        gpu::Buffer(device_, (resource.bytes + 3) / 4 * 4,
                                                    flags.buffer_usage, gpu::BufferMemory::device));
        }
    }
}

Realised::Usage Realised::usage_of(const Graph& graph, const Plan& plan) {
    const std::size_t count = graph.resources().size();
    Usage out{std::vector<vk::ImageUsageFlags>(count), std::vector<vk::BufferUsageFlags>(count)};
    const auto add = [&](std::uint32_t version, Access access) {
        const std::uint32_t resource = graph.versions()[version].resource;
        out.image[resource] |= flags_of(mask(access)).image_usage;
        out.buffer[resource] |= flags_of(mask(access)).buffer_usage;
    };
    for (const std::uint32_t needed : plan.needed) {
        for (const Use& use : graph.passes()[needed].uses) {
            if (use.version != Version::none) {
                add(use.version, use.access);
            }
        }
    }
    for (const Presented& end : plan.presented) {
        add(end.version, Access::transfer_read);
    }
    return out;
}

vk::MemoryRequirements Realised::make(const Resource& resource, std::uint32_t id,
                                      const Usage& usage) {
    if (resource.kind == ResourceKind::image) {
        images_[id] = gpu::Image::unbound(device_, resource.image, usage.image[id]);
        return images_[id]->requirements();
    }
    buffers_[id] = gpu::Buffer::unbound(device_, (resource.bytes + 3) / 4 * 4, usage.buffer[id]);
    return buffers_[id]->requirements();
}

// One pool for those of one type of memory.
void Realised::bind(const Plan& plan, std::uint32_t memory_type,
                    std::span<const std::size_t> members, std::span<const Extent> extents) {
    std::vector<Lifetime> lifetimes;
    std::vector<Extent> sizes;
    for (const std::size_t member : members) {
        lifetimes.push_back(plan.lifetimes[member]);
        sizes.push_back(extents[member]);
    }
    const Placement placement = place(lifetimes, sizes);
    pool_bytes_ += placement.bytes;
    memory_.push_back(device_.allocate({placement.bytes, memory_type}));
    for (std::size_t index = 0; index < lifetimes.size(); ++index) {
        const std::uint32_t id = lifetimes[index].resource;
        if (images_[id]) {
            images_[id]->bind(memory_.back(), placement.offsets[index]);
        } else {
            buffers_[id]->bind(memory_.back(), placement.offsets[index]);
        }
    }
}

void Realised::make_transients(const Graph& graph, const Plan& plan) {
    images_.resize(graph.resources().size());
    buffers_.resize(graph.resources().size());
    const Usage usage = usage_of(graph, plan);
    // Nearly always all ask for one type.
    std::map<std::uint32_t, std::vector<std::size_t>> by_type;
    std::vector<Extent> extents;
    for (std::size_t index = 0; index < plan.lifetimes.size(); ++index) {
        const std::uint32_t id = plan.lifetimes[index].resource;
        const vk::MemoryRequirements needs = make(graph.resources()[id], id, usage);
        extents.push_back(
            {needs.size, std::max(needs.alignment, device_.limits().bufferImageGranularity)});
        unshared_bytes_ += needs.size;
        by_type[device_.memory_type(needs.memoryTypeBits, vk::MemoryPropertyFlagBits::eDeviceLocal)]
            .push_back(index);
    }
    for (const auto& [type, members] : by_type) {
        bind(plan, type, members, extents);
    }
}

void Realised::make_data_blocks(const Graph& graph) {
    for (const Resource& resource : graph.resources()) {
        if (resource.origin != Origin::data) {
            continue;
        }
        const auto known = data_.find(resource.name);
        if (known != data_.end() && known->second.bytes.size() == resource.data.size()) {
            continue;
        }
        if (known != data_.end()) {
            data_.erase(known);
        }
        using Bits = vk::BufferUsageFlagBits;
        gpu::Buffer buffer(device_, resource.data.size(),
                           Bits::eStorageBuffer | Bits::eUniformBuffer | Bits::eIndexBuffer |
                               Bits::eIndirectBuffer | Bits::eTransferDst,
                           gpu::BufferMemory::device);
        data_.emplace(resource.name, DataBlock{std::move(buffer), {}});
    }
}

void Realised::make_descriptor_pool(const std::vector<gpu::PipelineKey>& keys) {
    const auto count_of = [&](BindingType type) {
        std::size_t count = 0;
        for (const gpu::PipelineKey& key : keys) {
            count += static_cast<std::size_t>(
                std::count(key.bindings.begin(), key.bindings.end(), type));
        }
        return static_cast<std::uint32_t>(count);
    };
    std::vector<vk::DescriptorPoolSize> sizes;
    for (const BindingType type : {BindingType::sampled_image, BindingType::storage_image,
                                   BindingType::storage_buffer, BindingType::uniform_buffer}) {
        if (const std::uint32_t count = count_of(type); count > 0) {
            sizes.emplace_back(gpu::descriptor_type(type), count);
        }
    }
    if (!sizes.empty()) {
        descriptors_ = {device_.vk(), vk::DescriptorPoolCreateInfo(
                                          vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                                          static_cast<std::uint32_t>(keys.size()), sizes)};
    }
}

const gpu::Image& Realised::bound_image(const Graph& graph, const Use& use,
                                        const std::vector<bool>& version_lives) const {
    if (use.version == Version::none) {
        return neutral_.images[static_cast<std::size_t>(use.neutral)];
    }
    if (use.only_if_read && !version_lives[use.version]) {
        return neutral_.targets[is_integer(graph.resource_of(use.version).image.format) ? 1 : 0];
    }
    return image(graph, use.version);
}

void Realised::write_set(const Graph& graph, const PassRecord& pass,
                         const std::vector<bool>& version_lives, RealisedPass& step) {
    vk::raii::DescriptorSets sets(device_.vk(), {*descriptors_, *step.pipeline->set_layout});
    step.set = std::move(sets.front());
    std::vector<vk::DescriptorImageInfo> images(pass.uses.size());
    std::vector<vk::DescriptorBufferInfo> buffers(pass.uses.size());
    std::vector<vk::WriteDescriptorSet> writes;
    for (std::size_t index = 0; index < pass.uses.size(); ++index) {
        const Use& use = pass.uses[index];
        if (use.binding == BindingType::none) {
            continue;
        }
        const bool given = use.version != Version::none;
        vk::WriteDescriptorSet write(**step.set, static_cast<std::uint32_t>(writes.size()), 0, 1,
                                     gpu::descriptor_type(use.binding));
        if (use.binding == BindingType::sampled_image ||
            use.binding == BindingType::storage_image) {
            const gpu::Image& bound = bound_image(graph, use, version_lives);
            images[index] = vk::DescriptorImageInfo(pipelines_.sampler(use.sampler), bound.view(),
                                                    vk_layout(layout_of(use.access)));
            write.pImageInfo = &images[index];
        } else {
            const gpu::Buffer& bound = given ? buffer(graph, use.version) : neutral_.buffer;
            buffers[index] = vk::DescriptorBufferInfo(bound.vk(), 0, VK_WHOLE_SIZE);
            write.pBufferInfo = &buffers[index];
        }
        writes.push_back(write);
    }
    device_.vk().updateDescriptorSets(writes, {});
}

} // namespace preview
