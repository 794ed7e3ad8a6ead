#include "lutlib/interpolation/grade_tables.h"

#include "lutlib/interpolation/interpolation.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lutlib {
namespace {

// Steps along red, green and blue.
using Steps = std::array<int, 3>;
constexpr std::array<Steps, 4> pair_steps{{{1, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

std::vector<CacheLine> lines_of(std::size_t bytes) {
    return std::vector<CacheLine>(bytes / sizeof(CacheLine) + 1);
}

std::byte* bytes_of(std::vector<CacheLine>& lines) {
    return lines[0].bytes.data();
}

// How many nodes can be named by a cell on the upper faces.
std::size_t with_faces(int size) {
    const auto n = static_cast<std::size_t>(size);
    return n * n * n + n * n + n + 2;
}

std::size_t held_index(int size, Steps at) {
    std::size_t out = 0;
    for (std::size_t c = 3; c-- > 0;) {
        out = out * static_cast<std::size_t>(size) +
              static_cast<std::size_t>(std::min(at[c], size - 1));
    }
    return out;
}

template <class F>
void for_each_node(int size, F f) {
    for (int b = 0; b < size; ++b) {
        for (int g = 0; g < size; ++g) {
            for (int r = 0; r < size; ++r) {
                f(Steps{r, g, b}, held_index(size, {r, g, b}));
            }
        }
    }
}

Steps moved(Steps at, Steps by) {
    return {at[0] + by[0], at[1] + by[1], at[2] + by[2]};
}

void put_node(std::byte* at, const Rgb& node) {
    std::memcpy(at, &node, sizeof node);
}

} // namespace

GradeTables::GradeTables(const Lut& lut, Interpolation kind) : shaper(lut.shaper), how(kind) {
    if (!lut.cube) {
        return;
    }
    size = lut.cube->size;
    domain = lut.cube->domain;
    is_plain = !shaper && domain.is_unit();
    const std::vector<Rgb>& from = lut.cube->nodes;
    nodes_ = lines_of(with_faces(size) * node_bytes);
    least = largest = from.front().r;
    for (std::size_t i = 0; i < from.size(); ++i) {
        put_node(bytes_of(nodes_) + i * node_bytes, from[i]);
        least = std::min({least, from[i].r, from[i].g, from[i].b});
        largest = std::max({largest, from[i].r, from[i].g, from[i].b});
    }
    if (how == Interpolation::tetrahedral && size <= largest_of_cells) {
        make_pairs(*lut.cube);
    }
    if (is_plain && how == Interpolation::tetrahedral && size <= largest_of_cells) {
        choose_cells();
    }
}

// 16 bits over a range of 2 err by a hundredth of an 8-bit code's step at most.
void GradeTables::choose_cells() {
    if (!(least >= -1 && largest <= 2 && largest - least <= 2)) {
        return;
    }
    const bool within = least >= 0 && largest <= 1;
    cell_bits_ = within ? cell_bits_within : cell_bits_beyond;
    cell_base_ = within ? 0 : static_cast<double>(least);
    constexpr double middle = 32768;
    cell_bias_ = static_cast<std::int32_t>(
        std::lround(middle * whole + std::ldexp(255 * cell_base_ + 0.5, cell_bits_)));
}

void GradeTables::make_pairs(const Lut3D& cube) {
    pairs_ = lines_of(with_faces(size) * pairs_bytes);
    for_each_node(size, [&](Steps at, std::size_t index) {
        std::byte* to = bytes_of(pairs_) + index * pairs_bytes;
        for (const Steps& by : pair_steps) {
            put_node(to, cube.nodes[index]);
            put_node(to + node_bytes, cube.nodes[held_index(size, moved(at, by))]);
            to += 2 * node_bytes;
        }
    });
}

void GradeTables::make_cells() const {
    std::vector<CacheLine> out = lines_of(with_faces(size) * cell_bytes);
    constexpr double middle = 32768;
    const double scale = std::ldexp(255.0 / whole, cell_bits_);
    const auto narrow = [&](std::size_t index) {
        Rgb node;
        std::memcpy(&node, nodes() + index * node_bytes, sizeof node);
        std::array<std::int16_t, 4> held{};
        for (std::size_t c = 0; c < 3; ++c) {
            const double steps = std::round((static_cast<double>(node[c]) - cell_base_) * scale);
            held[c] = static_cast<std::int16_t>(std::min(steps - middle, middle - 1));
        }
        return held;
    };
    for_each_node(size, [&](Steps at, std::size_t index) {
        std::array<std::int16_t, cell_bytes / 2> cell;
        auto* to = cell.data();
        for (const Steps& by : pair_steps) {
            const auto first = narrow(index), second = narrow(held_index(size, moved(at, by)));
            for (std::size_t c = 0; c < 4; ++c) {
                *to++ = first[c];
                *to++ = second[c];
            }
        }
        std::memcpy(bytes_of(out) + index * cell_bytes, cell.data(), cell_bytes);
    });
    cells_ = std::move(out);
}

const std::byte* GradeTables::cells() const {
    if (cell_bits_ == 0) {
        return nullptr;
    }
    std::call_once(cells_once_, [this] { make_cells(); });
    return cells_[0].bytes.data();
}

RgbD weighed_nodes(const GradeTables& tables, RgbD color) {
    RgbD place;
    for (std::size_t c = 0; c < 3; ++c) {
        const double min = tables.domain.min[c], max = tables.domain.max[c];
        const double t = (color[c] - min) / (max - min);
        place[c] = (t > 0 ? std::min(t, 1.0) : 0.0) * (tables.size - 1);
    }
    const NodeWeights weights = node_weights(tables.how, tables.size, place);
    RgbD out;
    for (std::size_t i = 0; i < weights.count; ++i) {
        Rgb node;
        std::memcpy(&node, tables.nodes() + weights.node[i] * GradeTables::node_bytes, sizeof node);
        out = out + weights.weight[i] * to_double(node);
    }
    return out;
}

} // namespace lutlib
