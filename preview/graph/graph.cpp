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

} // namespace

Handle Graph::add_resource(Resource resource) {
    const auto resource_index = static_cast<std::uint32_t>(resources_.size());
    resources_.push_back(std::move(resource));
    versions_.push_back({resource_index, Version::none, Version::none, false});
    return {static_cast<std::uint32_t>(versions_.size() - 1)};
}

Handle Graph::image(std::string_view name, const ImageDesc& desc) {
    if (desc.width == 0 || desc.height == 0)
        fault(fmt::format("image '{}' is empty ({}x{})", name, desc.width, desc.height));
    Resource resource;
    resource.name = name;
    resource.image = desc;
    return add_resource(std::move(resource));
}

Handle Graph::buffer(std::string_view name, std::uint64_t bytes) {
    if (bytes == 0)
        fault(fmt::format("buffer '{}' is empty", name));
    Resource resource;
    resource.name = name;
    resource.kind = ResourceKind::buffer;
    resource.bytes = bytes;
    return add_resource(std::move(resource));
}

Handle Graph::import(std::string_view name, const gpu::Image& image, const ImageDesc& desc) {
    Resource resource;
    resource.name = name;
    resource.origin = Origin::imported;
    resource.image = desc;
    resource.imported_image = &image;
    return add_resource(std::move(resource));
}

Handle Graph::import(std::string_view name, const gpu::Buffer& buffer, std::uint64_t bytes) {
    Resource resource;
    resource.name = name;
    resource.kind = ResourceKind::buffer;
    resource.origin = Origin::imported;
    resource.bytes = bytes;
    resource.imported_buffer = &buffer;
    return add_resource(std::move(resource));
}

Handle Graph::data(std::string_view name, std::span<const std::byte> bytes) {
    if (bytes.empty() || bytes.size() % 4 != 0)
        fault(fmt::format("data '{}' has {} bytes, not a positive multiple of 4", name,
                          bytes.size()));
    for (const Resource& other : resources_)
        if (other.origin == Origin::data && other.name == name &&
            !std::equal(bytes.begin(), bytes.end(), other.data.begin(), other.data.end()))
            fault(fmt::format("two data blocks are named '{}' and differ", name));
    Resource resource;
    resource.name = name;
    resource.kind = ResourceKind::buffer;
    resource.origin = Origin::data;
    resource.bytes = bytes.size();
    resource.data.assign(bytes.begin(), bytes.end());
    return add_resource(std::move(resource));
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

Handle Graph::fill(std::string_view name, Handle buffer, std::uint32_t word) {
    PassRecord record;
    record.name = name;
    record.kind = PassKind::fill;
    record.fill_value = word;
    passes_.push_back(std::move(record));
    Pass pass{*this, static_cast<std::uint32_t>(passes_.size() - 1)};
    Use use;
    use.access = Access::transfer_write;
    return pass.add_write(buffer, use, false);
}

void Graph::withhold(std::string_view name, std::string_view reason) {
    withheld_.push_back({std::string(name), std::string(reason)});
}

void Graph::present(Handle handle) {
    current(handle, "the frame's end");
    if (resource(handle).origin == Origin::transient &&
        versions_[handle.version].producer == Version::none)
        fault(fmt::format("'{}' is presented and was never written", resource(handle).name));
    if (std::find(presented_.begin(), presented_.end(), handle.version) == presented_.end())
        presented_.push_back(handle.version);
}

const ImageDesc& Graph::image_desc(Handle handle) const {
    return resource(handle).image;
}

std::uint64_t Graph::buffer_bytes(Handle handle) const {
    return resource(handle).bytes;
}

const Resource& Graph::resource(Handle handle) const {
    if (handle.version >= versions_.size())
        fault(handle ? "a handle of another graph" : "an empty handle has no resource");
    return resources_[versions_[handle.version].resource];
}

const Version& Graph::current(Handle handle, std::string_view user) const {
    const Resource& wanted = resource(handle);
    const Version& version = versions_[handle.version];
    if (version.retired)
        fault(fmt::format("'{}' uses a version of '{}' that a later pass has overwritten", user,
                          wanted.name));
    return version;
}

PassRecord& Pass::record() {
    return graph_->passes_[index_];
}

void Pass::add_read(Handle handle, ResourceKind kind, Use use) {
    if (handle) {
        const Version& version = graph_->current(handle, record().name);
        const Resource& resource = graph_->resources_[version.resource];
        if (resource.kind != kind)
            fault(fmt::format("'{}' binds '{}' as the wrong kind of resource", record().name,
                              resource.name));
        if (resource.origin == Origin::transient && version.producer == Version::none)
            fault(fmt::format("'{}' reads '{}', which no pass has written", record().name,
                              resource.name));
        use.version = handle.version;
    }
    record().uses.push_back(use);
}

Handle Pass::add_write(Handle handle, Use use, bool keeps) {
    const Version old = graph_->current(handle, record().name);
    const Resource& resource = graph_->resources_[old.resource];
    if (resource.origin != Origin::transient)
        fault(fmt::format("'{}' writes '{}', which the frame may only read", record().name,
                          resource.name));
    if (keeps && old.producer == Version::none)
        fault(fmt::format("'{}' modifies '{}', which no pass has written", record().name,
                          resource.name));
    for (const Use& other : record().uses)
        if (other.version != Version::none &&
            graph_->versions_[other.version].resource == old.resource)
            fault(fmt::format("'{}' reads and writes '{}' at once", record().name, resource.name));
    graph_->versions_[handle.version].retired = true;
    graph_->versions_.push_back(
        {old.resource, index_, keeps ? handle.version : Version::none, false});
    use.version = static_cast<std::uint32_t>(graph_->versions_.size() - 1);
    use.writes = true;
    record().uses.push_back(use);
    return {use.version};
}

void Pass::sample(Handle image, Sampler sampler, Neutral stand_in) {
    Use use;
    use.access =
        record().kind == PassKind::compute ? Access::compute_sample : Access::graphics_sample;
    use.binding = BindingType::sampled_image;
    use.sampler = sampler;
    use.neutral = stand_in;
    add_read(image, ResourceKind::image, use);
}

void Pass::read(Handle image, Neutral stand_in) {
    sample(image, Sampler::nearest_clamp, stand_in);
}

void Pass::storage(Handle buffer) {
    Use use;
    use.access = record().kind == PassKind::compute ? Access::compute_read : Access::graphics_read;
    use.binding = BindingType::storage_buffer;
    use.neutral = Neutral::no_buffer;
    add_read(buffer, ResourceKind::buffer, use);
}

void Pass::uniform(Handle buffer) {
    Use use;
    use.access = record().kind == PassKind::compute ? Access::compute_read : Access::graphics_read;
    use.binding = BindingType::uniform_buffer;
    use.neutral = Neutral::no_buffer;
    add_read(buffer, ResourceKind::buffer, use);
}

Handle Pass::write(Handle handle) {
    Use use;
    use.access = Access::compute_write;
    use.binding = graph_->resource(handle).kind == ResourceKind::image
                      ? BindingType::storage_image
                      : BindingType::storage_buffer;
    return add_write(handle, use, false);
}

Handle Pass::modify(Handle handle) {
    const Resource& resource = graph_->resource(handle);
    if (resource.kind == ResourceKind::image && resource.image.format != Format::r32ui)
        fault(fmt::format("'{}' modifies '{}', and only r32ui images can be", record().name,
                          resource.name));
    Use use;
    use.access = Access::compute_write;
    use.binding = resource.kind == ResourceKind::image ? BindingType::storage_image
                                                       : BindingType::storage_buffer;
    return add_write(handle, use, true);
}

Handle Pass::color(Handle image, std::array<float, 4> clear) {
    Use use;
    use.access = Access::color_write;
    use.clears = true;
    use.clear = clear;
    return add_write(image, use, false);
}

Handle Pass::depth(Handle image, float clear, std::uint32_t layer) {
    Use use;
    use.access = Access::depth_write;
    use.clears = true;
    use.clear[0] = clear;
    use.layer = layer;
    return add_write(image, use, false);
}

Handle Pass::depth_layer(Handle image, float clear, std::uint32_t layer) {
    Use use;
    use.access = Access::depth_write;
    use.clears = true;
    use.clear[0] = clear;
    use.layer = layer;
    return add_write(image, use, true);
}

void Pass::index_buffer(Handle buffer) {
    Use use;
    use.access = Access::index_read;
    add_read(buffer, ResourceKind::buffer, use);
}

void Pass::state(const RasterState& state) {
    record().raster = state;
}

void Pass::draws(std::vector<Draw> list) {
    record().draws = std::move(list);
}

void Pass::constants(std::initializer_list<std::uint32_t> words) {
    record().constants = words;
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

void Pass::dispatch_indirect(Handle buffer) {
    Use use;
    use.access = Access::indirect_read;
    add_read(buffer, ResourceKind::buffer, use);
    record().indirect_use = static_cast<std::uint32_t>(record().uses.size() - 1);
}

} // namespace preview
