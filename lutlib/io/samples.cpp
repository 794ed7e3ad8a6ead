#include "lutlib/io/samples.h"

#include "lutlib/codes.h"
#include "lutlib/half.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstring>

namespace lutlib::io {
namespace {

constexpr std::size_t pixels_at_once = std::size_t{1} << 14;

// On every core, `work(first, last)`.
template <class Work>
void for_pixels(std::size_t pixels, const Work& work) {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, pixels, pixels_at_once),
        [&](const tbb::blocked_range<std::size_t>& part) { work(part.begin(), part.end()); });
}

template <class Sample, class Value>
void spread(const SampleImage& image, const Value& value_of, std::vector<float>& rgba) {
    const auto samples = image.samples.as<Sample>();
    const std::size_t channels = image.samples_a_pixel();
    for_pixels(image.pixels(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            for (std::size_t c = 0; c < channels; ++c) {
                rgba[i * 4 + c] = value_of(samples[i * channels + c]);
            }
        }
    });
}

// A look-up of every code's value.
template <class Value>
std::vector<float> values(int maximum, const Value& value_of) {
    std::vector<float> out(static_cast<std::size_t>(maximum) + 1);
    for (int code = 0; code <= maximum; ++code) {
        out[static_cast<std::size_t>(code)] = value_of(code);
    }
    return out;
}

std::vector<float> values_of_codes(int bits) {
    const CodeDepth depth{bits};
    return values(depth.maximum(), [&](int code) { return static_cast<float>(depth.value(code)); });
}

const std::vector<float>& values_of_halves() {
    static const std::vector<float> all =
        values(0xFFFF, [](int half) { return float_from_half(static_cast<std::uint16_t>(half)); });
    return all;
}

// CodeDepth::code() of a float without its call for each: halves go up.
template <class Code>
Code nearest_code(float value, float maximum) {
    const float scaled = saturate(value) * maximum;
    const int below = static_cast<int>(scaled);
    return static_cast<Code>(below + (scaled - static_cast<float>(below) >= 0.5F ? 1 : 0));
}

template <class Sample, class Nearest>
void gather(const FloatImage& image, const Nearest& nearest, SampleImage& out) {
    const auto samples = out.samples.as<Sample>();
    const std::size_t channels = out.samples_a_pixel();
    for_pixels(out.pixels(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            for (std::size_t c = 0; c < channels; ++c) {
                samples[i * channels + c] = nearest(image.rgba[i * 4 + c]);
            }
        }
    });
}

template <class Sample>
bool are_all(const SampleImage& image, Sample one) {
    const auto samples = image.samples.as<Sample>();
    std::atomic<bool> out = true;
    for_pixels(image.pixels(), [&](std::size_t first, std::size_t last) {
        bool all = out.load(std::memory_order_relaxed);
        for (std::size_t i = first; all && i < last; ++i) {
            all = samples[i * 4 + 3] == one;
        }
        if (!all) {
            out.store(false, std::memory_order_relaxed);
        }
    });
    return out;
}

} // namespace

FloatImage floats_of(SampleImage&& image) {
    FloatImage out{image, std::vector<float>(image.pixels() * 4, 1.0F)};
    const auto looked_up = [](const std::vector<float>& table) {
        return [&table](auto sample) { return table[sample]; };
    };
    switch (image.depth) {
    case Depth::uint8:
        spread<std::uint8_t>(image, looked_up(values_of_codes(8)), out.rgba);
        break;
    case Depth::uint16:
        spread<std::uint16_t>(image, looked_up(values_of_codes(16)), out.rgba);
        break;
    case Depth::half:
        spread<std::uint16_t>(image, looked_up(values_of_halves()), out.rgba);
        break;
    case Depth::float32:
        spread<float>(
            image, [](float value) { return value; }, out.rgba);
        break;
    }
    image.samples = {};
    return out;
}

SampleImage
samples_of(const FloatImage& image, Depth depth, bool alpha,
           const std::function<SampleBuffer(const SampleImage& without_samples)>& memory) {
    SampleImage out{image};
    out.depth = depth;
    out.alpha = alpha;
    out.samples = memory ? memory(out) : SampleBuffer();
    if (out.samples.size() == 0) {
        out.samples = SampleBuffer(out.bytes());
    }
    const auto code_of = [](auto maximum) {
        return [maximum](float value) {
            return nearest_code<decltype(maximum)>(value, static_cast<float>(maximum));
        };
    };
    switch (depth) {
    case Depth::uint8:
        gather<std::uint8_t>(image, code_of(std::uint8_t{0xFF}), out);
        break;
    case Depth::uint16:
        gather<std::uint16_t>(image, code_of(std::uint16_t{0xFFFF}), out);
        break;
    case Depth::half:
        gather<std::uint16_t>(image, half_near, out);
        break;
    case Depth::float32:
        gather<float>(
            image, [](float value) { return value; }, out);
        break;
    }
    return out;
}

bool is_opaque(const SampleImage& image) {
    if (!image.alpha) {
        return true;
    }
    switch (image.depth) {
    case Depth::uint8:
        return are_all<std::uint8_t>(image, 0xFF);
    case Depth::uint16:
        return are_all<std::uint16_t>(image, 0xFFFF);
    case Depth::half:
        return are_all<std::uint16_t>(image, half_from(1));
    case Depth::float32:
        break;
    }
    return are_all<float>(image, 1);
}

} // namespace lutlib::io
