#include "preview/graph/execute.h"

#include "preview/gpu/commands.h"
#include "preview/gpu/timers.h"
#include "preview/graph/realise.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>

namespace preview {

namespace {

gpu::Scope scope_of(AccessMask accesses) {
    const AccessFlags flags = flags_of(accesses);
    return {flags.stages, flags.memory};
}

vk::ImageMemoryBarrier2 image_barrier(const gpu::Image& image, const Barrier& barrier) {
    return gpu::image_barrier(image.vk(), image.aspect(), scope_of(barrier.from),
                              scope_of(barrier.to), vk_layout(barrier.old_layout),
                              vk_layout(barrier.new_layout));
}

vk::MemoryBarrier2 memory_barrier(AccessMask from, AccessMask to) {
    return gpu::memory_barrier(scope_of(from), scope_of(to));
}

} // namespace

struct Executor::Slot {
    explicit Slot(const gpu::Device& device) : commands(device) {}
    gpu::Commands commands;
    std::optional<gpu::Timers> timers;
    std::vector<std::string> step_names;
    std::map<std::string, gpu::Buffer> copies; ///< of presented buffers
    std::uint64_t frame = 0;                   ///< 0: never used
};

struct Executor::Shared {
    explicit Shared(const gpu::Device& device) : neutral(device) {}
    NeutralResources neutral;
    DataBlocks data;
    PersistentObjects persistent;
};

Executor::Executor(const gpu::Device& device, std::uint32_t frames_in_flight)
    : device_(device), shared_(std::make_unique<Shared>(device)),
      repeated_(std::make_unique<Slot>(device)) {
    for (std::uint32_t slot = 0; slot < frames_in_flight; ++slot) {
        slots_.emplace_back(device);
    }
}

Executor::~Executor() {
    try {
        wait();
    } catch (const std::exception&) {
        // A lost device has nothing to wait for.
    }
}

void Executor::wait() {
    for (const Slot& slot : slots_) {
        slot.commands.wait();
    }
    repeated_->commands.wait();
}

void Executor::render(const Graph& graph, const FrameEnd& end) {
    plan_ = make_plan(graph, held_);
    std::string shape = shape_of(graph, plan_);
    if (!realised_ || shape != shape_ || !plan_.made.empty()) {
        wait();
        realised_.reset();
        held_.clear(); // in case that making the new objects fails
        realised_ = std::make_unique<Realised>(device_, device_.pipelines(), shared_->neutral,
                                               shared_->data, shared_->persistent, graph, plan_);
        shape_ = std::move(shape);
        ++rebuilds_;
    }
    presented_.clear();
    for (const std::uint32_t version : graph.presented()) {
        const Resource& resource = graph.resource_of(version);
        presented_[version] = {resource.name, resource.kind == ResourceKind::image
                                                  ? &realised_->image(graph, version)
                                                  : nullptr};
    }
    const std::uint64_t frame = slots_[slot_].frame + 1;
    slot_ = (slot_ + 1) % slots_.size();
    Slot& slot = slots_[slot_];
    // So that no more than frames_in_flight hold the caller's semaphores.
    repeated_->commands.wait();
    slot.frame = frame;
    record(graph, slot, end);
    slot.commands.submit(end.waits, end.signals);
    held_ = plan_.held;
}

void Executor::repeat(const FrameEnd& end) {
    if (!realised_) {
        throw std::logic_error("there is no frame to repeat");
    }
    wait();
    const vk::raii::CommandBuffer& commands = repeated_->commands.begin();
    if (end.record) {
        end.record(commands);
    }
    repeated_->commands.submit(end.waits, end.signals);
}

void Executor::record(const Graph& graph, Slot& slot, const FrameEnd& end) {
    const vk::raii::CommandBuffer& commands = slot.commands.begin();
    const auto stamps = static_cast<std::uint32_t>(plan_.steps.size() + 1);
    if (!slot.timers || slot.timers->capacity() < stamps) {
        slot.timers.emplace(device_, std::max(stamps, 64U));
    }
    slot.step_names.clear();
    slot.timers->reset(commands);
    upload_changed(graph, commands);
    slot.timers->stamp(commands);
    for (std::size_t step = 0; step < plan_.steps.size(); ++step) {
        record_step(graph, step, commands);
        slot.timers->stamp(commands);
        slot.step_names.push_back(graph.passes()[plan_.steps[step].pass].name);
    }
    record_presented(graph, slot, commands);
    if (end.record) {
        end.record(commands);
    }
}

void Executor::upload_changed(const Graph& graph, const vk::raii::CommandBuffer& commands) {
    constexpr std::size_t chunk = 65536; // the most that vkCmdUpdateBuffer takes
    bool first = true;
    for (const Resource& resource : graph.resources()) {
        if (resource.origin != Origin::data) {
            continue;
        }
        const auto found = shared_->data.find(resource.name);
        if (found == shared_->data.end() || found->second.bytes == resource.data) {
            continue;
        }
        if (first) {
            gpu::record(commands, memory_barrier(0, mask(Access::transfer_write)));
        }
        first = false;
        for (std::size_t at = 0; at < resource.data.size(); at += chunk) {
            const std::size_t bytes = std::min(chunk, resource.data.size() - at);
            commands.updateBuffer<std::byte>(
                found->second.buffer.vk(), at,
                vk::ArrayProxy<const std::byte>(static_cast<std::uint32_t>(bytes),
                                                resource.data.data() + at));
        }
        found->second.bytes = resource.data;
        ++uploads_;
    }
    if (!first) {
        gpu::record(commands,
                    memory_barrier(mask(Access::transfer_write),
                                   mask(Access::compute_read) | mask(Access::graphics_read) |
                                       mask(Access::index_read) | mask(Access::indirect_read)));
    }
}

void Executor::record_barriers(const Graph& graph, std::span<const Barrier> barriers,
                               const vk::raii::CommandBuffer& commands) {
    image_barriers_.clear();
    memory_barriers_.clear();
    for (const Barrier& barrier : barriers) {
        if (graph.resources()[barrier.resource].kind == ResourceKind::image) {
            image_barriers_.push_back(
                image_barrier(realised_->image_of_resource(graph, barrier.resource), barrier));
        } else {
            memory_barriers_.push_back(memory_barrier(barrier.from, barrier.to));
        }
    }
    if (!image_barriers_.empty() || !memory_barriers_.empty()) {
        commands.pipelineBarrier2(vk::DependencyInfo({}, memory_barriers_, {}, image_barriers_));
    }
}

void Executor::record_step(const Graph& graph, std::size_t index,
                           const vk::raii::CommandBuffer& commands) {
    const Step& step = plan_.steps[index];
    const PassRecord& pass = graph.passes()[step.pass];
    record_barriers(graph, step.barriers, commands);
    if (pass.kind == PassKind::fill) {
        commands.fillBuffer(realised_->buffer(graph, pass.uses.front().version).vk(), 0,
                            VK_WHOLE_SIZE, pass.fill_value);
        return;
    }
    const RealisedPass& objects = realised_->pass(step.needed);
    const auto point = pass.kind == PassKind::compute ? vk::PipelineBindPoint::eCompute
                                                      : vk::PipelineBindPoint::eGraphics;
    commands.bindPipeline(point, *objects.pipeline->pipeline);
    if (objects.set) {
        commands.bindDescriptorSets(point, *objects.pipeline->layout, 0, **objects.set, {});
    }
    if (pass.push_bytes > 0) {
        commands.pushConstants<std::byte>(
            *objects.pipeline->layout, objects.pipeline->stages, 0,
            vk::ArrayProxy<const std::byte>(pass.push_bytes, pass.push.data()));
    }
    if (pass.kind == PassKind::raster) {
        record_raster(graph, pass, commands);
    } else if (pass.indirect_use != Version::none) {
        commands.dispatchIndirect(
            realised_->buffer(graph, pass.uses[pass.indirect_use].version).vk(), 0);
    } else {
        commands.dispatch(pass.groups[0], pass.groups[1], pass.groups[2]);
    }
}

void Executor::record_raster(const Graph& graph, const PassRecord& pass,
                             const vk::raii::CommandBuffer& commands) {
    colors_.clear();
    vk::RenderingAttachmentInfo depth;
    vk::Extent2D extent;
    const gpu::Buffer* indices = nullptr;
    for (const Use& use : pass.uses) {
        if (use.access == Access::index_read) {
            indices = &realised_->buffer(graph, use.version);
        }
        if (use.access != Access::color_write && use.access != Access::depth_write) {
            continue;
        }
        const ImageDesc& desc = graph.resource_of(use.version).image;
        extent = vk::Extent2D(desc.width, desc.height);
        vk::RenderingAttachmentInfo attachment;
        attachment.loadOp = use.clears ? vk::AttachmentLoadOp::eClear : vk::AttachmentLoadOp::eLoad;
        attachment.storeOp = plan_.version_lives[use.version] ? vk::AttachmentStoreOp::eStore
                                                              : vk::AttachmentStoreOp::eDontCare;
        attachment.imageLayout = vk_layout(layout_of(use.access));
        if (use.access == Access::depth_write) {
            attachment.imageView = realised_->image(graph, use.version).layer_view(use.layer);
            attachment.clearValue.depthStencil = vk::ClearDepthStencilValue(use.clear[0]);
            depth = attachment;
        } else {
            if (plan_.version_lives[use.version]) {
                attachment.imageView = realised_->image(graph, use.version).layer_view(use.layer);
            }
            attachment.clearValue.color = vk::ClearColorValue(use.clear);
            colors_.push_back(attachment);
        }
    }
    const vk::Rect2D area({0, 0}, extent);
    commands.beginRendering(
        vk::RenderingInfo({}, area, 1, 0, colors_, depth.imageView ? &depth : nullptr));
    commands.setViewport(0, vk::Viewport(0, 0, static_cast<float>(extent.width),
                                         static_cast<float>(extent.height), 0, 1));
    commands.setScissor(0, area);
    if (indices != nullptr) {
        commands.bindIndexBuffer(indices->vk(), 0, vk::IndexType::eUint32);
    }
    for (const Draw& draw : pass.draws) {
        commands.drawIndexed(draw.index_count, draw.instance_count, draw.first_index,
                             draw.vertex_offset, draw.first_instance);
    }
    commands.endRendering();
}

void Executor::record_presented(const Graph& graph, Slot& slot,
                                const vk::raii::CommandBuffer& commands) {
    end_barriers_.clear();
    for (const Presented& end : plan_.presented) {
        end_barriers_.push_back(end.barrier);
    }
    record_barriers(graph, end_barriers_, commands);
    bool copied = false;
    for (const Presented& end : plan_.presented) {
        const Resource& resource = graph.resource_of(end.version);
        if (resource.kind == ResourceKind::image) {
            continue;
        }
        auto found = slot.copies.find(resource.name);
        if (found == slot.copies.end() || found->second.bytes() != resource.bytes) {
            if (found != slot.copies.end()) {
                slot.copies.erase(found);
            }
            found = slot.copies
                        .emplace(resource.name, gpu::Buffer(device_, resource.bytes,
                                                            vk::BufferUsageFlagBits::eTransferDst,
                                                            gpu::BufferMemory::readback))
                        .first;
        }
        commands.copyBuffer(realised_->buffer(graph, end.version).vk(), found->second.vk(),
                            vk::BufferCopy(0, 0, resource.bytes));
        copied = true;
    }
    if (copied) {
        gpu::record(commands, gpu::memory_barrier(gpu::transfer_write, gpu::host_read));
    }
}

const gpu::Image& Executor::image(ImageHandle presented) const {
    const auto found = presented_.find(presented.version);
    if (found == presented_.end() || found->second.image == nullptr) {
        throw std::logic_error("only a presented image can be looked at after its frame");
    }
    return *found->second.image;
}

std::vector<std::byte> Executor::read_image(ImageHandle presented) {
    wait();
    return gpu::read_image(device_, image(presented), vk::ImageLayout::eTransferSrcOptimal);
}

std::vector<std::byte> Executor::read_buffer(BufferHandle presented) {
    wait();
    const auto found = presented_.find(presented.version);
    if (found == presented_.end() || found->second.image != nullptr) {
        throw std::logic_error("only a presented buffer can be read after its frame");
    }
    const auto bytes = slots_[slot_].copies.at(found->second.name).mapped();
    return {bytes.begin(), bytes.end()};
}

std::vector<std::byte> Executor::finished_buffer(const std::string& name) const {
    const Slot* newest = nullptr;
    for (const Slot& slot : slots_) {
        if (slot.frame > 0 && slot.copies.count(name) > 0 && slot.commands.is_done() &&
            (newest == nullptr || slot.frame > newest->frame)) {
            newest = &slot;
        }
    }
    if (newest == nullptr) {
        return {};
    }
    const auto bytes = newest->copies.at(name).mapped();
    return {bytes.begin(), bytes.end()};
}

std::vector<StepTime> Executor::timings() {
    wait();
    const Slot& slot = slots_[slot_];
    std::vector<StepTime> times;
    if (!slot.timers) {
        return times;
    }
    const std::vector<double> intervals = slot.timers->intervals();
    for (std::size_t index = 0; index < intervals.size() && index < slot.step_names.size();
         ++index) {
        times.push_back({slot.step_names[index], intervals[index]});
    }
    return times;
}

std::size_t Executor::persistent_count() const {
    return shared_->persistent.images.size() + shared_->persistent.buffers.size();
}

std::uint64_t Executor::pool_bytes() const {
    return realised_ ? realised_->pool_bytes() : 0;
}

std::uint64_t Executor::unshared_bytes() const {
    return realised_ ? realised_->unshared_bytes() : 0;
}

} // namespace preview
