#include "preview/check/observe.h"

#include "lutlib/half.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <span>
#include <string_view>

namespace preview {

namespace {

/// Buffers that hold floats and nothing else.
constexpr std::string_view float_buffers[] = {"hdr maximum", "surroundings irradiance"};

template <class Word, class Convert>
void append(std::vector<float>& out, std::span<const std::byte> bytes, Convert convert) {
    for (std::size_t at = 0; at + sizeof(Word) <= bytes.size(); at += sizeof(Word)) {
        Word word{};
        std::memcpy(&word, bytes.data() + at, sizeof word);
        convert(out, word);
    }
}

/// How texels of a format become numbers, in the order of the enumeration; without a function they
/// are none.
struct Decoding {
    std::size_t channels;
    void (*decode)(std::vector<float>& out, std::span<const std::byte> bytes);
};

void decode_bytes(std::vector<float>& out, std::span<const std::byte> bytes) {
    append<std::uint8_t>(out, bytes, [](std::vector<float>& to, std::uint8_t word) {
        to.push_back(static_cast<float>(word) / 255);
    });
}
void decode_words(std::vector<float>& out, std::span<const std::byte> bytes) {
    append<std::uint16_t>(out, bytes, [](std::vector<float>& to, std::uint16_t word) {
        to.push_back(static_cast<float>(word) / 65535);
    });
}
void decode_tens(std::vector<float>& out, std::span<const std::byte> bytes) {
    append<std::uint32_t>(out, bytes, [](std::vector<float>& to, std::uint32_t word) {
        for (const unsigned shift : {0U, 10U, 20U}) {
            to.push_back(static_cast<float>(word >> shift & 1023U) / 1023);
        }
        to.push_back(static_cast<float>(word >> 30U) / 3);
    });
}
void decode_halves(std::vector<float>& out, std::span<const std::byte> bytes) {
    append<std::uint16_t>(out, bytes, [](std::vector<float>& to, std::uint16_t word) {
        to.push_back(lutlib::float_from_half(word));
    });
}
void decode_floats(std::vector<float>& out, std::span<const std::byte> bytes) {
    append<float>(out, bytes, [](std::vector<float>& to, float word) { to.push_back(word); });
}

/// Small unsigned floats of 5 bits of exponent: halves without a sign and with less mantissa.
void decode_packed(std::vector<float>& out, std::span<const std::byte> bytes) {
    append<std::uint32_t>(out, bytes, [](std::vector<float>& to, std::uint32_t word) {
        const auto from = [](std::uint32_t bits) {
            return lutlib::float_from_half(static_cast<std::uint16_t>(bits));
        };
        to.push_back(from((word & 2047U) << 4U));
        to.push_back(from((word >> 11U & 2047U) << 4U));
        to.push_back(from((word >> 22U & 1023U) << 5U));
        to.push_back(1);
    });
}

constexpr Decoding decodings[] = {
    {4, decode_bytes},  // rgba8
    {4, decode_tens},   // rgb10a2
    {2, decode_words},  // rg16ui: normals
    {4, decode_words},  // rgba16
    {4, decode_halves}, // rgba16f
    {1, decode_floats}, // r32f
    {1, nullptr},       // r32ui: numbers of materials, packed
    {4, decode_floats}, // rgba32f
    {1, decode_floats}, // d32
    {4, decode_packed}, // r11g11b10f
};
static_assert(std::size(decodings) == std::size(formats));

bool is_worth_reading(const Graph& graph, const Plan& plan, std::uint32_t version) {
    const Resource& resource = graph.resource_of(version);
    const Version& state = graph.versions()[version];
    const bool holds_floats = resource.kind == ResourceKind::image ||
                              std::find(std::begin(float_buffers), std::end(float_buffers),
                                        resource.name) != std::end(float_buffers);
    return holds_floats && resource.is_written() && !state.retired &&
           state.producer != Version::none && plan.version_lives[version];
}

Observed read(Executor& executor, const Graph& graph, std::uint32_t version) {
    const Resource& resource = graph.resource_of(version);
    Observed out;
    out.order = graph.versions()[version].producer;
    out.pass = graph.passes()[out.order].name;
    out.version = version;
    out.name = resource.name;
    out.desc = resource.image;
    if (resource.kind == ResourceKind::buffer) {
        out.desc = {Format::r32f, static_cast<std::uint32_t>(resource.bytes / sizeof(float)), 1};
        decode_floats(out.values, executor.read_buffer(BufferHandle{version}));
        return out;
    }
    const Decoding& decoding = decodings[static_cast<std::size_t>(resource.image.format)];
    out.channels = decoding.channels;
    const auto bytes = executor.read_image(ImageHandle{version});
    if (decoding.decode != nullptr) {
        decoding.decode(out.values, bytes);
    } else {
        out.words.resize(bytes.size() / sizeof(std::uint32_t));
        std::memcpy(out.words.data(), bytes.data(), out.words.size() * sizeof(std::uint32_t));
    }
    return out;
}

} // namespace

std::vector<Observed> observe(Executor& executor, const Graph& graph) {
    // What nobody needs stays out of the frame: it is what is presented now that decides.
    const Plan plan = make_plan(graph);
    Graph watched = graph;
    std::vector<std::uint32_t> versions;
    for (std::uint32_t version = 0; version < graph.versions().size(); ++version) {
        if (is_worth_reading(graph, plan, version)) {
            versions.push_back(version);
            graph.resource_of(version).kind == ResourceKind::image
                ? watched.present(ImageHandle{version})
                : watched.present(BufferHandle{version});
        }
    }
    executor.render(watched);
    std::vector<Observed> out;
    for (const std::uint32_t version : versions) {
        out.push_back(read(executor, watched, version));
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const Observed& a, const Observed& b) { return a.order < b.order; });
    return out;
}

NonFinite non_finite(const Observed& observed) {
    NonFinite out;
    for (std::size_t at = 0; at < observed.values.size(); at += observed.channels) {
        const std::span texel(observed.values.data() + at, observed.channels);
        if (std::any_of(texel.begin(), texel.end(), [](float v) { return std::isnan(v); })) {
            ++out.nan;
        } else if (std::any_of(texel.begin(), texel.end(), [](float v) { return std::isinf(v); })) {
            ++out.infinite;
        }
    }
    return out;
}

const Observed* left_by(const std::vector<Observed>& all, std::string_view pass) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Observed& one) { return one.pass == pass; });
    return found == all.end() ? nullptr : &*found;
}

const Observed* with_version(const std::vector<Observed>& all, std::uint32_t version) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Observed& one) { return one.version == version; });
    return found == all.end() ? nullptr : &*found;
}

} // namespace preview
