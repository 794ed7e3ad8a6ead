#include "lutlib/stored_lut.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace lutlib {
namespace {

constexpr std::array<Storage, 5> storage_table{{
    {"8", "8 bits", 3, 255},
    {"10", "10 bits", 4, 1023},
    {"16", "16 bits", 6, 65535},
    {"half", "half float", 6, 0, true},
    {"float", "float", 12, 0},
}};

constexpr std::array<Lookup, 4> lookup_table{{
    {"nearest", "nearest", Interpolation::nearest, 0},
    {"trilinear", "trilinear", Interpolation::trilinear, 0},
    {"tetrahedral", "tetrahedral", Interpolation::tetrahedral, 0},
    {"hardware", "hardware trilinear", Interpolation::trilinear, 8},
}};
constexpr int nearest = 0, trilinear = 1, tetrahedral = 2, hardware = 3;

template <class T>
T load(const std::uint8_t* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

// IEEE 754 binary16 without infinities, which the constructor never stores: the exponent is moved
// by a multiplication, which is right for subnormals too.
float half_to_float(std::uint16_t h) {
    const auto magnitude = std::bit_cast<float>(static_cast<std::uint32_t>(h & 0x7FFF) << 13);
    const float value = magnitude * 0x1p112F;
    return h & 0x8000 ? -value : value;
}

// Rounds to nearest, ties to even.
std::uint16_t float_to_half(double x) {
    const double held = std::clamp(std::isnan(x) ? 0 : x, -65504.0, 65504.0);
    const auto sign = static_cast<std::uint16_t>(std::signbit(held) ? 0x8000 : 0);
    const double magnitude = std::abs(held);
    const int exponent = std::max(magnitude > 0 ? std::ilogb(magnitude) : -14, -14);
    const auto mantissa = static_cast<int>(std::nearbyint(std::ldexp(magnitude, 10 - exponent)));
    // A mantissa that rounds up to 2048 carries into the exponent, as it should.
    const int bits = ((exponent + 14) << 10) + mantissa;
    return static_cast<std::uint16_t>(sign | bits);
}

struct Codes8 {
    static constexpr std::size_t bytes = 3;
    static constexpr float scale = 1.0F / 255;
    static Rgb at(const std::uint8_t* p) {
        return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
    }
};
struct Codes10 {
    static constexpr std::size_t bytes = 4;
    static constexpr float scale = 1.0F / 1023;
    static Rgb at(const std::uint8_t* p) {
        const auto word = load<std::uint32_t>(p);
        const auto channel = [word](int shift) {
            return static_cast<float>(static_cast<int>(word >> shift & 1023));
        };
        return {channel(0), channel(10), channel(20)};
    }
};
struct Codes16 {
    static constexpr std::size_t bytes = 6;
    static constexpr float scale = 1.0F / 65535;
    static Rgb at(const std::uint8_t* p) {
        return {static_cast<float>(load<std::uint16_t>(p)),
                static_cast<float>(load<std::uint16_t>(p + 2)),
                static_cast<float>(load<std::uint16_t>(p + 4))};
    }
};
struct Halves {
    static constexpr std::size_t bytes = 6;
    static constexpr float scale = 1;
    static Rgb at(const std::uint8_t* p) {
        return {half_to_float(load<std::uint16_t>(p)), half_to_float(load<std::uint16_t>(p + 2)),
                half_to_float(load<std::uint16_t>(p + 4))};
    }
};
struct Floats {
    static constexpr std::size_t bytes = 12;
    static constexpr float scale = 1;
    static Rgb at(const std::uint8_t* p) {
        return {load<float>(p), load<float>(p + 4), load<float>(p + 8)};
    }
};

template <class T>
void store(std::uint8_t* at, T value) {
    std::memcpy(at, &value, sizeof value);
}

void store_node(std::uint8_t* at, RgbD node, const Storage& storage) {
    if (storage.maximum > 0) {
        std::array<std::uint32_t, 3> code{};
        for (std::size_t c = 0; c < 3; ++c) {
            code[c] =
                static_cast<std::uint32_t>(std::floor(saturate(node[c]) * storage.maximum + 0.5));
        }
        if (storage.bytes == Codes10::bytes) {
            store(at, code[0] | code[1] << 10 | code[2] << 20);
            return;
        }
        for (std::size_t c = 0; c < 3; ++c) {
            storage.bytes == Codes8::bytes ? store(at + c, static_cast<std::uint8_t>(code[c]))
                                           : store(at + 2 * c, static_cast<std::uint16_t>(code[c]));
        }
        return;
    }
    for (std::size_t c = 0; c < 3; ++c) {
        storage.half ? store(at + 2 * c, float_to_half(node[c]))
                     : store(at + 4 * c, static_cast<float>(node[c]));
    }
}

Rgb mix(Rgb a, Rgb b, float t) {
    return a * (1 - t) + b * t;
}

} // namespace

std::span<const Storage> storages() {
    return storage_table;
}

std::span<const Lookup> lookups() {
    return lookup_table;
}

StoredLut::StoredLut(const Lut& lut, const std::vector<RgbD>& nodes, const Storage& storage)
    : storage_(&storage), shaper_(lut.shaper), size_(lut.cube->size), low_(lut.cube->domain.min),
      data_(nodes.size() * storage.bytes) {
    for (std::size_t c = 0; c < 3; ++c) {
        scale_[c] = static_cast<float>(size_ - 1) / (lut.cube->domain.max[c] - low_[c]);
    }
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        store_node(&data_[k * storage.bytes], nodes[k], storage);
    }
}

std::size_t StoredLut::bytes() const {
    return data_.size() + (shaper_ ? shaper_->entries.size() * sizeof(Rgb) : 0);
}

template <class Fetch, int lookup>
Rgb StoredLut::read(Rgb in) const {
    const float last = static_cast<float>(size_ - 1);
    std::array<int, 3> i{};
    std::array<float, 3> f{};
    for (std::size_t c = 0; c < 3; ++c) {
        const float raw = (in[c] - low_[c]) * scale_[c];
        // The comparison's form sends NaN to 0.
        const float x = raw > 0 ? std::min(raw, last) : 0;
        if constexpr (lookup == nearest) {
            i[c] = static_cast<int>(x + 0.5F);
        } else {
            i[c] = std::min(static_cast<int>(x), size_ - 2);
            f[c] = x - static_cast<float>(i[c]);
            if constexpr (lookup == hardware) {
                f[c] = std::floor(f[c] * 256 + 0.5F) / 256;
            }
        }
    }
    const auto n = static_cast<std::size_t>(size_);
    const std::size_t dr = Fetch::bytes, dg = n * dr, db = n * dg;
    const std::uint8_t* const base =
        &data_[static_cast<std::size_t>(i[0]) * dr + static_cast<std::size_t>(i[1]) * dg +
               static_cast<std::size_t>(i[2]) * db];
    if constexpr (lookup == nearest) {
        return Fetch::at(base) * Fetch::scale;
    } else if constexpr (lookup == tetrahedral) {
        // From the dark corner to the bright one, along the axes in order of falling fraction.
        std::array<std::size_t, 3> step{dr, dg, db};
        const auto order = [&](std::size_t a, std::size_t b) {
            if (f[a] < f[b]) {
                std::swap(f[a], f[b]);
                std::swap(step[a], step[b]);
            }
        };
        order(0, 1);
        order(1, 2);
        order(0, 1);
        const Rgb sum = Fetch::at(base) * (1 - f[0]) + Fetch::at(base + step[0]) * (f[0] - f[1]) +
                        Fetch::at(base + step[0] + step[1]) * (f[1] - f[2]) +
                        Fetch::at(base + dr + dg + db) * f[2];
        return sum * Fetch::scale;
    } else {
        const auto row = [&](std::size_t offset) {
            return mix(Fetch::at(base + offset), Fetch::at(base + offset + dr), f[0]);
        };
        const Rgb sum = mix(mix(row(0), row(dg), f[1]), mix(row(db), row(db + dg), f[1]), f[2]);
        return sum * Fetch::scale;
    }
}

template <class Fetch, int lookup>
void StoredLut::apply_lookup(std::span<const Rgb> in, std::span<Rgb> out) const {
    if (shaper_) {
        for (std::size_t k = 0; k < in.size(); ++k) {
            out[k] = read<Fetch, lookup>(evaluate(*shaper_, in[k]));
        }
    } else {
        for (std::size_t k = 0; k < in.size(); ++k) {
            out[k] = read<Fetch, lookup>(in[k]);
        }
    }
}

template <class Fetch>
void StoredLut::apply_storage(std::span<const Rgb> in, std::span<Rgb> out,
                              const Lookup& lookup) const {
    switch (lookup.weights) {
    case Interpolation::nearest:
        return apply_lookup<Fetch, nearest>(in, out);
    case Interpolation::trilinear:
        return lookup.fraction_bits > 0 ? apply_lookup<Fetch, hardware>(in, out)
                                        : apply_lookup<Fetch, trilinear>(in, out);
    case Interpolation::tetrahedral:
        return apply_lookup<Fetch, tetrahedral>(in, out);
    }
}

void StoredLut::apply(std::span<const Rgb> in, std::span<Rgb> out, const Lookup& lookup) const {
    switch (storage_->maximum) {
    case 255:
        return apply_storage<Codes8>(in, out, lookup);
    case 1023:
        return apply_storage<Codes10>(in, out, lookup);
    case 65535:
        return apply_storage<Codes16>(in, out, lookup);
    default:
        return storage_->half ? apply_storage<Halves>(in, out, lookup)
                              : apply_storage<Floats>(in, out, lookup);
    }
}

} // namespace lutlib
