#include "lutlib/interpolation/stored_lut.h"

#include "lutlib/codes.h"
#include "lutlib/half.h"
#include "lutlib/interpolation/apply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace lutlib {
namespace {

constexpr std::array<Storage, 5> storage_table{{
    {NodeFormat::codes8, "8", "8 bits", 3, 8, 3},
    {NodeFormat::codes10, "10", "10 bits", 4, 10, 4},
    {NodeFormat::codes16, "16", "16 bits", 6, 16, 6},
    {NodeFormat::halves, "half", "half float", 6, 0, 6},
    {NodeFormat::floats, "float", "float", 12, 0, 16},
}};

constexpr std::array<Lookup, 4> lookup_table{{
    {"nearest", "nearest", Interpolation::nearest, 0},
    {"trilinear", "trilinear", Interpolation::trilinear, 0},
    {"tetrahedral", "tetrahedral", Interpolation::tetrahedral, 0},
    {"hardware", "hardware trilinear", Interpolation::trilinear, 8},
}};

// A vector of four channels is loaded where a node has three.
constexpr std::size_t padding = 16;

template <class T>
void store(std::uint8_t* at, T value) {
    std::memcpy(at, &value, sizeof value);
}

void store_node(std::uint8_t* at, RgbD node, const Storage& storage) {
    std::array<std::uint32_t, 3> code{};
    for (std::size_t c = 0; c < 3; ++c) {
        code[c] = CodeDepth{storage.bits}.code(node[c]);
    }
    if (storage.format == NodeFormat::codes10) {
        store(at, code[0] | code[1] << 10 | code[2] << 20);
        return;
    }
    const std::size_t step = storage.bytes / 3;
    for (std::size_t c = 0; c < 3; ++c) {
        std::uint8_t* const to = at + c * step;
        switch (storage.format) {
        case NodeFormat::codes8:
            store(to, static_cast<std::uint8_t>(code[c]));
            break;
        case NodeFormat::codes16:
            store(to, static_cast<std::uint16_t>(code[c]));
            break;
        case NodeFormat::halves:
            store(to, half_from(node[c]));
            break;
        case NodeFormat::floats:
            store(to, static_cast<float>(node[c]));
            break;
        case NodeFormat::codes10:
            break;
        }
    }
}

} // namespace

std::span<const Storage> storages() {
    return storage_table;
}

std::span<const Lookup> lookups() {
    return lookup_table;
}

const Lookup& lookup_of(Interpolation how) {
    return *std::find_if(lookup_table.begin(), lookup_table.end(),
                         [how](const Lookup& row) { return row.weights == how; });
}

StoredLut::StoredLut(const Lut& lut) : storage_(&storage_table.back()), shaper_(lut.shaper) {
    if (lut.cube) {
        size_ = lut.cube->size;
        cube_domain_ = lut.cube->domain;
        static_assert(sizeof(Rgb) == 3 * sizeof(float));
        const std::vector<Rgb>& nodes = lut.cube->nodes;
        data_.resize(nodes.size() * storage_->stride + padding);
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            std::memcpy(&data_[k * storage_->stride], &nodes[k], sizeof(Rgb));
        }
    }
}

StoredLut::StoredLut(const Lut& lut, const std::vector<RgbD>& nodes, const Storage& storage)
    : storage_(&storage), shaper_(lut.shaper), size_(lut.cube->size),
      cube_domain_(lut.cube->domain), data_(nodes.size() * storage.stride + padding) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        store_node(&data_[k * storage.stride], nodes[k], storage);
    }
}

std::size_t StoredLut::bytes() const {
    return static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_) *
               static_cast<std::size_t>(size_) * storage_->bytes +
           (shaper_ ? shaper_->entries.size() * sizeof(Rgb) : 0);
}

void StoredLut::apply(std::span<const Rgb> in, std::span<Rgb> out, const Lookup& lookup) const {
    if (!in.empty()) {
        apply_on_this_thread(*this, lookup, &in[0].r, &out[0].r, in.size(), 3);
    }
}

} // namespace lutlib
