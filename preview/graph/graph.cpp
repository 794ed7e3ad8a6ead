#include "preview/graph/graph.h"

#include "lutlib/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace preview {

namespace {

/// A graph that is declared wrongly is a fault of the program, not of somebody's input.
[[noreturn]] void fault(const std::string& message) {
    throw std::logic_error("render graph: " + message);
}

Resource image_resource(std::string_view name, const ImageDesc& desc) {
    if (desc.width == 0 || desc.height == 0) {
        fault(fmt::format("image '{}' is empty ({}x{})", name, desc.width, desc.height));
    }
    Resource resource;
    resource.name = name;
    resource.image = desc;
    return resource;
}

Resource buffer_resource(std::string_view name, std::uint64_t bytes) {
    if (bytes == 0) {
        fault(fmt::format("buffer '{}' is empty", name));
    }
    Resource resource;
    resource.name = name;
    resource.kind = ResourceKind::buffer;
    resource.bytes = bytes;
    return resource;
}

/// What a compute shader writes.
Use written(BindingType binding) {
    Use use;
    use.access = Access::compute_write;
    use.binding = binding;
    return use;
}

Use depth_layer_cleared(float clear, std::uint32_t layer) {
    Use use;
    use.access = Access::depth_write;
    use.clears = true;
    use.clear[0] = clear;
    use.layer = layer;
    return use;
}

} // namespace

std::uint32_t Graph::add_resource(Resource resource) {
    const auto resource_index = static_cast<std::uint32_t>(resources_.size());
    resources_.push_back(std::move(resource));
    versions_.push_back({resource_index, Version::none, Version::none, false});
    return static_cast<std::uint32_t>(versions_.size() - 1);
}

std::uint32_t Graph::add_persistent(Resource resource, std::string_view still_right) {
    for (const Resource& other : resources_) {
        if (other.origin == Origin::persistent && other.name == resource.name) {
            fault(fmt::format("two persistent resources are named '{}'", resource.name));
        }
    }
    resource.origin = Origin::persistent;
    resource.still_right = still_right;
    return add_resource(std::move(resource));
}

ImageHandle Graph::image(std::string_view name, const ImageDesc& desc) {
    return {add_resource(image_resource(name, desc))};
}

BufferHandle Graph::buffer(std::string_view name, std::uint64_t bytes) {
    return {add_resource(buffer_resource(name, bytes))};
}

ImageHandle Graph::persistent_image(std::string_view name, const ImageDesc& desc,
                                    std::string_view still_right) {
    return {add_persistent(image_resource(name, desc), still_right)};
}

BufferHandle Graph::persistent_buffer(std::string_view name, std::uint64_t bytes,
                                      std::string_view still_right) {
    return {add_persistent(buffer_resource(name, bytes), still_right)};
}

ImageHandle Graph::import_image(std::string_view name, const gpu::Image& image,
                                std::uint64_t serial, const ImageDesc& desc) {
    Resource resource;
    resource.name = name;
    resource.origin = Origin::imported;
    resource.image = desc;
    resource.imported_image = &image;
    resource.serial = serial;
    return {add_resource(std::move(resource))};
}

BufferHandle Graph::import_buffer(std::string_view name, const gpu::Buffer& buffer,
                                  std::uint64_t serial, std::uint64_t bytes) {
    Resource resource;
    resource.name = name;
    resource.kind = ResourceKind::buffer;
    resource.origin = Origin::imported;
    resource.bytes = bytes;
    resource.imported_buffer = &buffer;
    resource.serial = serial;
    return {add_resource(std::move(resource))};
}

BufferHandle Graph::data(std::string_view name, std::span<const std::byte> bytes) {
    if (bytes.empty() || bytes.size() % 4 != 0) {
        fault(fmt::format("data '{}' has {} bytes, not a positive multiple of 4", name,
                          bytes.size()));
    }
    for (const Resource& other : resources_) {
        if (other.origin == Origin::data && other.name == name &&
            !std::equal(bytes.begin(), bytes.end(), other.data.begin(), other.data.end())) {
            fault(fmt::format("two data blocks are named '{}' and differ", name));
        }
    }
    Resource resource;
    resource.name = name;
    resource.kind = ResourceKind::buffer;
    resource.origin = Origin::data;
    resource.bytes = bytes.size();
    resource.data.assign(bytes.begin(), bytes.end());
    return {add_resource(std::move(resource))};
}

Pass Graph::compute(std::string_view name, std::string_view shader) {
    PassRecord record;
    record.name = name;
    record.kind = PassKind::compute;
    record.shader = shader;
    passes_.push_back(std::move(record));
    return {*this, static_cast<std::uint32_t>(passes_.size() - 1)};
}

Pass Graph::raster(std::string_view name, std::string_view vertex_shader,
                   std::string_view fragment_shader) {
    PassRecord record;
    record.name = name;
    record.kind = PassKind::raster;
    record.shader = vertex_shader;
    record.fragment_shader = fragment_shader;
    passes_.push_back(std::move(record));
    return {*this, static_cast<std::uint32_t>(passes_.size() - 1)};
}

BufferHandle Graph::fill(std::string_view name, BufferHandle buffer, std::uint32_t word) {
    PassRecord record;
    record.name = name;
    record.kind = PassKind::fill;
    record.fill_value = word;
    passes_.push_back(std::move(record));
    Pass pass{*this, static_cast<std::uint32_t>(passes_.size() - 1)};
    Use use;
    use.access = Access::transfer_write;
    return {pass.add_write(buffer.version, use, false)};
}

void Graph::withhold(std::string_view name, std::string_view reason) {
    withheld_.push_back({std::string(name), std::string(reason)});
}

void Graph::present_version(std::uint32_t version) {
    current(version, "the frame's end");
    const Resource& resource = resource_of(version);
    if (resource.is_written() && versions_[version].producer == Version::none) {
        fault(fmt::format("'{}' is presented and was never written", resource.name));
    }
    if (std::find(presented_.begin(), presented_.end(), version) == presented_.end()) {
        presented_.push_back(version);
    }
}

const Resource& Graph::resource_of(std::uint32_t version) const {
    if (version >= versions_.size()) {
        fault(version == Version::none ? "an empty handle has no resource"
                                       : "a handle of another graph");
    }
    return resources_[versions_[version].resource];
}

const Version& Graph::current(std::uint32_t version, std::string_view user) const {
    const Resource& wanted = resource_of(version);
    if (versions_[version].retired) {
        fault(fmt::format("'{}' uses a version of '{}' that a later pass has overwritten", user,
                          wanted.name));
    }
    return versions_[version];
}

/// What is kept is the last version: an earlier one could not be had again.
void Graph::refuse_overwriting_what_was_read(std::uint32_t version, std::string_view writer) const {
    for (const PassRecord& pass : passes_) {
        for (const Use& use : pass.uses) {
            if (use.version == version && !use.writes) {
                fault(fmt::format("'{}' overwrites the persistent '{}', which '{}' has read",
                                  writer, resource_of(version).name, pass.name));
            }
        }
    }
}

std::optional<std::uint32_t> read_targets(const PassRecord& pass,
                                          const std::vector<bool>& version_lives) {
    std::optional<std::uint32_t> bits;
    std::uint32_t bit = 1;
    for (const Use& use : pass.uses) {
        if (use.only_if_read) {
            bits = bits.value_or(0) | (version_lives[use.version] ? bit : 0U);
            bit <<= 1U;
        }
    }
    return bits;
}

PassRecord& Pass::record() {
    return graph_->passes_[index_];
}

void Pass::add_read(std::uint32_t version, Use use) {
    if (version != Version::none) {
        const Version& read = graph_->current(version, record().name);
        const Resource& resource = graph_->resources_[read.resource];
        if (resource.is_written() && read.producer == Version::none) {
            fault(fmt::format("'{}' reads '{}', which no pass has written", record().name,
                              resource.name));
        }
        use.version = version;
    }
    record().uses.push_back(use);
}

std::uint32_t Pass::add_write(std::uint32_t version, Use use, bool keeps) {
    const Version old = graph_->current(version, record().name);
    const Resource& resource = graph_->resources_[old.resource];
    if (!resource.is_written()) {
        fault(fmt::format("'{}' writes '{}', which the frame may only read", record().name,
                          resource.name));
    }
    if (keeps && old.producer == Version::none) {
        fault(fmt::format("'{}' modifies '{}', which no pass has written", record().name,
                          resource.name));
    }
    for (const Use& other : record().uses) {
        if (other.version != Version::none &&
            graph_->versions_[other.version].resource == old.resource) {
            fault(fmt::format("'{}' reads and writes '{}' at once", record().name, resource.name));
        }
    }
    if (resource.origin == Origin::persistent) {
        graph_->refuse_overwriting_what_was_read(version, record().name);
    }
    graph_->versions_[version].retired = true;
    graph_->versions_.push_back({old.resource, index_, keeps ? version : Version::none, false});
    use.version = static_cast<std::uint32_t>(graph_->versions_.size() - 1);
    use.writes = true;
    record().uses.push_back(use);
    return use.version;
}

void Pass::sample(ImageHandle image, Sampler sampler, Neutral stand_in) {
    Use use;
    use.access =
        record().kind == PassKind::compute ? Access::compute_sample : Access::graphics_sample;
    use.binding = BindingType::sampled_image;
    use.sampler = sampler;
    use.neutral = stand_in;
    add_read(image.version, use);
}

void Pass::read(ImageHandle image, Neutral stand_in) {
    sample(image, Sampler::nearest_clamp, stand_in);
}

void Pass::add_buffer(BufferHandle buffer, BindingType binding) {
    Use use;
    use.access = record().kind == PassKind::compute ? Access::compute_read : Access::graphics_read;
    use.binding = binding;
    use.neutral = Neutral::no_buffer;
    add_read(buffer.version, use);
}

void Pass::storage(BufferHandle buffer) {
    add_buffer(buffer, BindingType::storage_buffer);
}

void Pass::uniform(BufferHandle buffer) {
    add_buffer(buffer, BindingType::uniform_buffer);
}

ImageHandle Pass::write(ImageHandle image) {
    return {add_write(image.version, written(BindingType::storage_image), false)};
}

BufferHandle Pass::write(BufferHandle buffer) {
    return {add_write(buffer.version, written(BindingType::storage_buffer), false)};
}

ImageHandle Pass::write_if_read(ImageHandle image) {
    Use use = written(BindingType::storage_image);
    use.only_if_read = true;
    return {add_write(image.version, use, false)};
}

ImageHandle Pass::modify(ImageHandle image) {
    if (graph_->image_desc(image).format != Format::r32ui) {
        fault(fmt::format("'{}' modifies '{}', and only r32ui images can be", record().name,
                          graph_->resource_of(image.version).name));
    }
    return {add_write(image.version, written(BindingType::storage_image), true)};
}

BufferHandle Pass::modify(BufferHandle buffer) {
    return {add_write(buffer.version, written(BindingType::storage_buffer), true)};
}

ImageHandle Pass::color(ImageHandle image, std::array<float, 4> clear) {
    Use use;
    use.access = Access::color_write;
    use.clears = true;
    use.clear = clear;
    return {add_write(image.version, use, false)};
}

ImageHandle Pass::color_over(ImageHandle image) {
    Use use;
    use.access = Access::color_write;
    return {add_write(image.version, use, true)};
}

ImageHandle Pass::depth(ImageHandle image, float clear, std::uint32_t layer) {
    return {add_write(image.version, depth_layer_cleared(clear, layer), false)};
}

ImageHandle Pass::depth_layer(ImageHandle image, float clear, std::uint32_t layer) {
    return {add_write(image.version, depth_layer_cleared(clear, layer), true)};
}

void Pass::index_buffer(BufferHandle buffer) {
    Use use;
    use.access = Access::index_read;
    add_read(buffer.version, use);
}

void Pass::state(const RasterState& state) {
    record().raster = state;
}

void Pass::draws(std::vector<Draw> list) {
    record().draws = std::move(list);
}

void Pass::constants(std::vector<std::uint32_t> words) {
    record().constants = std::move(words);
}

void Pass::push_bytes(std::span<const std::byte> bytes) {
    std::copy(bytes.begin(), bytes.end(), record().push.begin());
    record().push_bytes = static_cast<std::uint32_t>(bytes.size());
}

void Pass::dispatch(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    record().groups = {x, y, z};
}

void Pass::dispatch_over(std::uint32_t width, std::uint32_t height, Tile tile) {
    dispatch((width + tile.width - 1) / tile.width, (height + tile.height - 1) / tile.height);
}

void Pass::dispatch_indirect(BufferHandle buffer) {
    Use use;
    use.access = Access::indirect_read;
    add_read(buffer.version, use);
    record().indirect_use = static_cast<std::uint32_t>(record().uses.size() - 1);
}

} // namespace preview
