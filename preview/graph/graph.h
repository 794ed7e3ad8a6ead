// The render graph: a frame as plain data, without a Vulkan header and testable without a GPU.
//
// A frame is declared from front to back on a fresh Graph, then planned (plan.h) and executed
// (execute.h). A pass is declared by a function that takes handles and returns handles:
//
//     ImageHandle add_tonemap(Graph& graph, ImageHandle hdr, float exposure) {
//         const ImageDesc size = graph.image_desc(hdr);
//         Pass pass = graph.compute("tone map", "tonemap.comp");       // shaders/tonemap.comp
//         pass.sample(hdr, Sampler::nearest_clamp);                    // binding 0
//         const ImageHandle out = pass.write(                          // binding 1
//             graph.image("tone mapped", {Format::rgba8, size.width, size.height}));
//         pass.constants({row.index});                                 // constant_id 0
//         pass.push(exposure);                                         // push constants
//         pass.dispatch_over(size.width, size.height);                 // 16x16 pixels a group
//         return out;
//     }
//
// Conventions
// - Descriptors: set 0 only; the binding number is the order of the calls that name a shader
//   resource (sample, read, uniform, storage, write, modify). Attachments, index and
//   indirect buffers take no number.
// - Shaders: shaders/NAME.comp|vert|frag, looked up by that file name; they may include
//   "common/x.glsl". Images are written with `writeonly uniform image2D` and no format, so one
//   shader serves every target format. `read` binds a sampled image without filtering (texelFetch
//   on a sampler2D/usampler2D), `sample` one with the named sampler. Only r32ui images may be
//   `modify`-ed from a shader (layout(r32ui)); other read-modify-write takes a second image.
// - Specialisation constants: 32-bit words, ids 0, 1, 2...; bools as 0 and 1.
// - Push constants: one trivially copyable struct of up to 128 bytes, laid out as std430.
// - Compute shaders over images have local_size 16x16 or divide the image as common/tile.glsl does,
//   and touch nothing outside the size that they ask imageSize() of their target for.
// - Names are for people: they appear in --explain, in --timings and in error messages.
//
// Handles are versions, of an image or of a buffer. Writing an image returns a new handle and
// retires the old one; reading a retired handle is an error, so the order of declaration is an
// order of execution. An empty handle stands for something that the frame withholds: an image binds
// its neutral stand-in.
//
// Resources that outlive the frame: persistent_image() and persistent_buffer() are declared and
// written in every frame as transients are. Whose contents an earlier frame left, and all that they
// were made from is the same, is not written again: its passes are left out. "All" is what its
// passes say (shaders, constants, push constants, draws) and what they read, up to the bytes of
// data() and to which object was imported, so a pass that shall rest reads no more than it needs.
#pragma once

#include "preview/gpu/types.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace preview {

namespace gpu {
class Image;
class Buffer;
} // namespace gpu

/// The texels that one group of a compute shader covers.
struct Tile {
    std::uint32_t width = 0, height = 0;
};
constexpr Tile one_each{16, 16};  ///< a texel a thread of 16x16
constexpr Tile many_each{32, 16}; ///< shaders/common/tile.glsl

enum class ResourceKind : std::uint8_t { image, buffer };

/// One version of a resource of that kind.
template <ResourceKind kind>
struct [[nodiscard]] Handle {
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    std::uint32_t version = none;

    explicit operator bool() const { return version != none; }
    friend bool operator==(Handle, Handle) = default;
};
using ImageHandle = Handle<ResourceKind::image>;
using BufferHandle = Handle<ResourceKind::buffer>;

/// What a pass does with a resource; decides layout, stage and memory access.
enum class Access : std::uint8_t {
    compute_sample,  ///< sampled image in a compute shader
    graphics_sample, ///< sampled image in a vertex or fragment shader
    compute_read,    ///< storage or uniform buffer read by a compute shader
    graphics_read,   ///< storage or uniform buffer read by a vertex or fragment shader
    index_read,
    indirect_read,
    compute_write, ///< storage image or buffer
    color_write,
    depth_write,
    transfer_read,
    transfer_write,
};
inline constexpr int access_count = 11;
using AccessMask = std::uint32_t;
constexpr AccessMask mask(Access access) {
    return AccessMask{1} << static_cast<unsigned>(access);
}

enum class Origin : std::uint8_t {
    transient,  ///< lives within the frame, memory is shared with others
    persistent, ///< owned by the executor, outlives the frame while frames need it
    imported,   ///< owned by somebody else, read only, ready for any read
    data, ///< bytes given with the graph; uploaded only when they differ from the last frame's
};

struct Resource {
    std::string name;
    ResourceKind kind = ResourceKind::image;
    Origin origin = Origin::transient;
    ImageDesc image;
    std::uint64_t bytes = 0; ///< of a buffer
    const gpu::Image* imported_image = nullptr;
    const gpu::Buffer* imported_buffer = nullptr;
    std::uint64_t serial = 0; ///< tells what is imported from anything else that ever was
    std::vector<std::byte> data;
    std::string still_right; ///< of a persistent one: why an earlier frame's contents may serve
    /// Its contents are made by passes of the frame.
    bool is_written() const { return origin == Origin::transient || origin == Origin::persistent; }
    friend bool operator==(const Resource&, const Resource&) = default;
};

struct Version {
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    std::uint32_t resource = 0;
    std::uint32_t producer = none; ///< the pass that writes it
    std::uint32_t previous = none; ///< the version whose contents it keeps
    bool retired = false;
    friend bool operator==(const Version&, const Version&) = default;
};

/// One appearance of a resource in a pass.
struct Use {
    std::uint32_t version = Version::none; ///< read, or written; none: the neutral stand-in
    Access access = Access::compute_sample;
    BindingType binding = BindingType::none;
    Sampler sampler = Sampler::nearest_clamp;
    Neutral neutral = Neutral::black;
    std::uint32_t layer = 0; ///< of an attachment
    bool writes = false;
    bool only_if_read = false; ///< see Pass::write_if_read()
    bool clears = false;       ///< an attachment that starts from `clear`
    std::array<float, 4> clear{};
    friend bool operator==(const Use&, const Use&) = default;
};

struct Draw {
    std::uint32_t index_count = 0;
    std::uint32_t first_index = 0;
    std::int32_t vertex_offset = 0;
    std::uint32_t instance_count = 1;
    std::uint32_t first_instance = 0;
    friend bool operator==(const Draw&, const Draw&) = default;
};

enum class PassKind : std::uint8_t { compute, raster, fill };

struct PassRecord {
    std::string name;
    PassKind kind = PassKind::compute;
    std::string shader;          ///< the compute or vertex shader's file name
    std::string fragment_shader; ///< empty: depth only
    std::vector<Use> uses;
    std::vector<std::uint32_t> constants;
    std::array<std::byte, 128> push{};
    std::uint32_t push_bytes = 0;
    std::array<std::uint32_t, 3> groups{0, 0, 0};
    std::uint32_t indirect_use = Version::none; ///< index in `uses` of the group counts
    RasterState raster;
    std::vector<Draw> draws;
    std::uint32_t fill_value = 0;
    friend bool operator==(const PassRecord&, const PassRecord&) = default;
};

/// The bits of the targets that are only written where they are read; nothing for a pass without.
std::optional<std::uint32_t> read_targets(const PassRecord& pass,
                                          const std::vector<bool>& version_lives);

/// Something that the scene or the settings withheld before it became a pass.
struct Withheld {
    std::string name;
    std::string reason;
    friend bool operator==(const Withheld&, const Withheld&) = default;
};

class Graph;

/// The pass being declared. Valid while its graph lives and until the next pass is added.
class Pass {
  public:
    // Shader resources, in binding order. An empty handle binds the neutral stand-in.
    void sample(ImageHandle image, Sampler sampler, Neutral stand_in = Neutral::black);
    void read(ImageHandle image, Neutral stand_in = Neutral::black);
    void storage(BufferHandle buffer); ///< read-only storage buffer
    void uniform(BufferHandle buffer);
    /// Overwrites all that is read later; earlier contents are lost. Returns the new version.
    ImageHandle write(ImageHandle image);
    BufferHandle write(BufferHandle buffer);
    /// As write(); while nobody reads the image it gets no memory, and the shader must not write
    /// it. It is told by a last specialisation constant of the pass, whose bits stand for its
    /// targets of this kind in their order: 1 for one that is read.
    ImageHandle write_if_read(ImageHandle image);
    /// Reads and writes; earlier contents count. Returns the new version.
    ImageHandle modify(ImageHandle image);
    BufferHandle modify(BufferHandle buffer);

    // Raster passes only. The attachment starts from the colour or depth `clear`.
    ImageHandle color(ImageHandle image, std::array<float, 4> clear);
    /// Draws over what stands there.
    ImageHandle color_over(ImageHandle image);
    ImageHandle depth(ImageHandle image, float clear, std::uint32_t layer = 0);
    /// Clears and writes one layer, keeping the others.
    ImageHandle depth_layer(ImageHandle image, float clear, std::uint32_t layer);
    void index_buffer(BufferHandle buffer);
    void state(const RasterState& state);
    void draws(std::vector<Draw> list);

    void constants(std::vector<std::uint32_t> words);
    template <class T>
    void push(const T& block) {
        static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= 128);
        push_bytes(std::as_bytes(std::span(&block, 1)));
    }
    void dispatch(std::uint32_t x, std::uint32_t y = 1, std::uint32_t z = 1);
    /// As many groups as cover the image.
    void dispatch_over(std::uint32_t width, std::uint32_t height, Tile tile = one_each);
    /// Group counts are read from the first 12 bytes of the buffer.
    void dispatch_indirect(BufferHandle buffer);

  private:
    friend class Graph;
    Pass(Graph& graph, std::uint32_t index) : graph_(&graph), index_(index) {}
    PassRecord& record();
    void add_read(std::uint32_t version, Use use);
    void add_buffer(BufferHandle buffer, BindingType binding);
    /// Returns the new version.
    std::uint32_t add_write(std::uint32_t version, Use use, bool keeps);
    void push_bytes(std::span<const std::byte> bytes);

    Graph* graph_;
    std::uint32_t index_;
};

class Graph {
  public:
    // Transients: no contents until a pass writes them.
    ImageHandle image(std::string_view name, const ImageDesc& desc);
    BufferHandle buffer(std::string_view name, std::uint64_t bytes);
    // Persistent: what an earlier frame made serves again while it is right. `name` identifies it
    // from frame to frame; a frame that does not need it drops it. `still_right` completes, for
    // people, "kept from an earlier frame: ...".
    ImageHandle persistent_image(std::string_view name, const ImageDesc& desc,
                                 std::string_view still_right);
    BufferHandle persistent_buffer(std::string_view name, std::uint64_t bytes,
                                   std::string_view still_right);
    // Imported: read only; must outlive the frame. Templates only so that the type may be
    // incomplete here. Nothing persistent may be made from what is rewritten in place.
    template <class Image = gpu::Image>
    ImageHandle import(std::string_view name, const std::type_identity_t<Image>& image,
                       const ImageDesc& desc) {
        return import_image(name, image, image.serial(), desc);
    }
    template <class Buffer = gpu::Buffer>
    BufferHandle import(std::string_view name, const std::type_identity_t<Buffer>& buffer,
                        std::uint64_t bytes) {
        return import_buffer(name, buffer, buffer.serial(), bytes);
    }
    /// A small buffer with these contents, for uniform() and storage(). `name` identifies it from
    /// frame to frame: unchanged contents are not uploaded again.
    BufferHandle data(std::string_view name, std::span<const std::byte> bytes);
    template <class T>
    BufferHandle data_of(std::string_view name, const T& block) {
        static_assert(std::is_trivially_copyable_v<T>);
        return data(name, std::as_bytes(std::span(&block, 1)));
    }

    Pass compute(std::string_view name, std::string_view shader);
    /// `fragment_shader` may be empty for a pass that writes depth alone.
    Pass raster(std::string_view name, std::string_view vertex_shader,
                std::string_view fragment_shader);
    /// Sets every word of a buffer. Returns the new version.
    BufferHandle fill(std::string_view name, BufferHandle buffer, std::uint32_t word);

    /// Records for explain() that something was not declared at all, and why.
    void withhold(std::string_view name, std::string_view reason);

    /// Wants this version: its producer lives, and its contents last to the end of the frame.
    void present(ImageHandle image) { present_version(image.version); }
    void present(BufferHandle buffer) { present_version(buffer.version); }

    const ImageDesc& image_desc(ImageHandle image) const {
        return resource_of(image.version).image;
    }
    std::uint64_t buffer_bytes(BufferHandle buffer) const {
        return resource_of(buffer.version).bytes;
    }
    const Resource& resource_of(std::uint32_t version) const;

    std::span<const Resource> resources() const { return resources_; }
    std::span<const Version> versions() const { return versions_; }
    std::span<const PassRecord> passes() const { return passes_; }
    std::span<const Withheld> withheld() const { return withheld_; }
    std::span<const std::uint32_t> presented() const { return presented_; }

    /// The same passes over the same inputs: the same results, when no imported resource was
    /// written in between.
    friend bool operator==(const Graph&, const Graph&) = default;

  private:
    friend class Pass;
    friend Graph interposed(const Graph& graph, ImageHandle image,
                            const std::function<ImageHandle(Graph&, ImageHandle)>& declare);
    ImageHandle import_image(std::string_view name, const gpu::Image& image, std::uint64_t serial,
                             const ImageDesc& desc);
    BufferHandle import_buffer(std::string_view name, const gpu::Buffer& buffer,
                               std::uint64_t serial, std::uint64_t bytes);
    std::uint32_t add_resource(Resource resource);
    std::uint32_t add_persistent(Resource resource, std::string_view still_right);
    void present_version(std::uint32_t version);
    const Version& current(std::uint32_t version, std::string_view user) const;
    void refuse_overwriting_what_was_read(std::uint32_t version, std::string_view writer) const;

    std::vector<Resource> resources_;
    std::vector<Version> versions_;
    std::vector<PassRecord> passes_;
    std::vector<Withheld> withheld_;
    std::vector<std::uint32_t> presented_;
};

} // namespace preview
