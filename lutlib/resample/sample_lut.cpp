#include "lutlib/resample/sample_lut.h"

#include "lutlib/error.h"
#include "lutlib/named.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace lutlib {
namespace {

// Colours that stages pass to each other through the first-level cache.
constexpr std::size_t block = 512;

// The inputs of a lattice's nodes, per channel.
using Axis = std::array<std::vector<double>, 3>;

std::vector<Rgb> sampled(const Axis& axis, const Transform& transform) {
    const std::size_t n = axis[0].size();
    std::vector<Rgb> nodes(n * n * n);
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, nodes.size(), 4 * block), [&](const auto& range) {
            std::array<RgbD, block> colors;
            for (std::size_t first = range.begin(); first < range.end(); first += block) {
                const std::size_t count = std::min(block, range.end() - first);
                for (std::size_t i = 0; i < count; ++i) {
                    const std::size_t k = first + i;
                    colors[i] = {axis[0][k % n], axis[1][k / n % n], axis[2][k / (n * n)]};
                }
                transform(std::span(colors).first(count));
                for (std::size_t i = 0; i < count; ++i) {
                    nodes[first + i] = to_float(colors[i]);
                }
            }
        });
    return nodes;
}

Axis even_axis(const Domain& domain, int size) {
    const Lut3D lattice{domain, size, {}};
    Axis axis;
    for (int i = 0; i < size; ++i) {
        const RgbD place = node_position(lattice, i, i, i);
        for (std::size_t c = 0; c < 3; ++c) {
            axis[c].push_back(place[c]);
        }
    }
    return axis;
}

// Where a rising table reaches each of `size` even steps from 0 to 1.
Axis inverted_axis(const Lut1D& table, int size) {
    Axis axis;
    for (std::size_t c = 0; c < 3; ++c) {
        int k = 0;
        for (int i = 0; i < size; ++i) {
            const double wanted = static_cast<double>(i) / (size - 1);
            const auto entry = [&](int j) {
                return static_cast<double>(table.entries[static_cast<std::size_t>(j)][c]);
            };
            while (k + 2 < table.size() && entry(k + 1) < wanted) {
                ++k;
            }
            const double low = entry(k), high = entry(k + 1);
            const double t = std::clamp((wanted - low) / (high - low), 0.0, 1.0);
            axis[c].push_back(entry_position(table, k)[c] * (1 - t) +
                              entry_position(table, k + 1)[c] * t);
        }
    }
    return axis;
}

} // namespace

Lut3D sample_cube(const Transform& transform, const Domain& domain, int size) {
    check_cube_size(size);
    check_domain(domain);
    return {domain, size, sampled(even_axis(domain, size), transform)};
}

Lut3D sample_cube_behind(const Transform& transform, const Lut1D& shaper, int size) {
    check_cube_size(size);
    return {{}, size, sampled(inverted_axis(shaper, size), transform)};
}

Lut1D encoding_shaper(std::string_view shaper, const Encoding& input, const Domain& domain,
                      int size) {
    const std::optional<Encoding> encoding = encoding_named(shaper);
    if (!encoding) {
        throw Error(no_such_name("shaper", shaper, name_list(transfer_curves())));
    }
    check_shaper_size(size);
    check_domain(domain);
    Lut1D table{domain, std::vector<Rgb>(static_cast<std::size_t>(size))};
    const auto f = [&](double x) { return encoding->encode(input.decode(x)); };
    for (std::size_t c = 0; c < 3; ++c) {
        const double low = f(domain.min[c]), high = f(domain.max[c]);
        for (int i = 0; i < size; ++i) {
            const double y = (f(entry_position(table, i)[c]) - low) / (high - low);
            table.entries[static_cast<std::size_t>(i)][c] = static_cast<float>(y);
        }
        for (std::size_t i = 0; i + 1 < table.entries.size(); ++i) {
            if (!(table.entries[i][c] < table.entries[i + 1][c])) {
                throw Error("the shaper '" + std::string(shaper) +
                            "' does not rise over the whole domain; choose another domain, fewer "
                            "entries, or another shaper");
            }
        }
    }
    return table;
}

} // namespace lutlib
