#include "lutlib/resample/invert_index.h"

#include "lutlib/limits.h"
#include "lutlib/resample/invert_cells.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace lutlib {

OutputIndex::Bucket OutputIndex::bucket_of(RgbD output) const {
    Bucket out{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double x = (output[c] - low_[c]) * scale_[c];
        out[c] = static_cast<int>(std::clamp(x, 0.0, buckets_ - 1.0));
    }
    return out;
}

std::size_t OutputIndex::bucket_index(const Bucket& b) const {
    const auto n = static_cast<std::size_t>(buckets_);
    return static_cast<std::size_t>(b[0]) +
           n * (static_cast<std::size_t>(b[1]) + n * static_cast<std::size_t>(b[2]));
}

void OutputIndex::divide(RgbD high, int buckets) {
    buckets_ = buckets;
    for (std::size_t c = 0; c < 3; ++c) {
        scale_[c] = high[c] > low_[c] ? buckets / (high[c] - low_[c]) : 0;
    }
}

// Calls visit(from, to, id) for every cell: the box of buckets that its outputs touch.
template <class F>
void OutputIndex::each_cell(F visit) const {
    for (int b = 0; b + 1 < cube_.size; ++b) {
        for (int g = 0; g + 1 < cube_.size; ++g) {
            for (int r = 0; r + 1 < cube_.size; ++r) {
                Bucket from = bucket_of(to_double(cube_.at(r, g, b))), to = from;
                for (int corner = 1; corner < 8; ++corner) {
                    const Bucket at = bucket_of(to_double(
                        cube_.at(r + (corner & 1), g + (corner >> 1 & 1), b + (corner >> 2))));
                    for (std::size_t c = 0; c < 3; ++c) {
                        from[c] = std::min(from[c], at[c]);
                        to[c] = std::max(to[c], at[c]);
                    }
                }
                visit(from, to, static_cast<std::uint32_t>(cube_.index(r, g, b)));
            }
        }
    }
}

std::uint64_t OutputIndex::cell_entries() const {
    std::uint64_t out = 0;
    each_cell([&out](const Bucket& from, const Bucket& to, std::uint32_t) {
        std::uint64_t touched = 1;
        for (std::size_t c = 0; c < 3; ++c) {
            touched *= static_cast<std::uint64_t>(to[c] - from[c] + 1);
        }
        out += touched;
    });
    return out;
}

OutputIndex::OutputIndex(const Lut3D& cube) : cube_(cube) {
    RgbD high = low_ = to_double(cube.nodes.front());
    for (const Rgb& node : cube.nodes) {
        for (std::size_t c = 0; c < 3; ++c) {
            low_[c] = std::min(low_[c], static_cast<double>(node[c]));
            high[c] = std::max(high[c], static_cast<double>(node[c]));
        }
    }
    for (std::size_t c = 0; c < 3; ++c) {
        span_ = std::max(span_, high[c] - low_[c]);
    }
    // Half the last of six decimals, as files have them, or of a small look's own digits.
    rounding_ = 5e-7 * std::min({1.0, std::max(largest_magnitude(low_), largest_magnitude(high))});
    // The wilder the look, the more buckets each cell touches. One bucket holds each cell once.
    divide(high, std::max(cube.size, 8));
    while (buckets_ > 1 && cell_entries() > limits::max_output_index_entries) {
        divide(high, buckets_ / 2);
    }
    const auto n = static_cast<std::size_t>(buckets_);
    // Two passes: count, then place.
    const auto each_entry = [&](auto&& visit_cell, auto&& visit_node) {
        for (std::size_t i = 0; i < cube.nodes.size(); ++i) {
            visit_node(bucket_index(bucket_of(to_double(cube.nodes[i]))),
                       static_cast<std::uint32_t>(i));
        }
        each_cell([&](const Bucket& from, const Bucket& to, std::uint32_t id) {
            for (int z = from[2]; z <= to[2]; ++z) {
                for (int y = from[1]; y <= to[1]; ++y) {
                    for (int x = from[0]; x <= to[0]; ++x) {
                        visit_cell(bucket_index({x, y, z}), id);
                    }
                }
            }
        });
    };
    cell_start_.assign(n * n * n + 1, 0);
    node_start_.assign(n * n * n + 1, 0);
    each_entry([&](std::size_t k, std::uint32_t) { ++cell_start_[k + 1]; },
               [&](std::size_t k, std::uint32_t) { ++node_start_[k + 1]; });
    for (std::size_t k = 0; k < n * n * n; ++k) {
        cell_start_[k + 1] += cell_start_[k];
        node_start_[k + 1] += node_start_[k];
    }
    cells_.resize(cell_start_.back());
    nodes_.resize(node_start_.back());
    look_at_cells();
    std::vector<std::uint32_t> next_cell = cell_start_, next_node = node_start_;
    each_entry([&](std::size_t k, std::uint32_t id) { cells_[next_cell[k]++] = id; },
               [&](std::size_t k, std::uint32_t id) { nodes_[next_node[k]++] = id; });
}

double OutputIndex::cells_of_bucket() const {
    double squares = 0;
    for (std::size_t k = 0; k + 1 < cell_start_.size(); ++k) {
        const double cells = cell_start_[k + 1] - cell_start_[k];
        squares += cells * cells;
    }
    return cells_.empty() ? 0 : squares / static_cast<double>(cells_.size());
}

void OutputIndex::look_at_cells() {
    flat_.assign(cube_.nodes.size(), 0);
    outputs_.resize(cube_.nodes.size());
    tbb::parallel_for(0, cube_.size - 1, [&](int b) {
        for (int g = 0; g + 1 < cube_.size; ++g) {
            for (int r = 0; r + 1 < cube_.size; ++r) {
                unsigned bits = 0;
                for (std::size_t i = 0; i < tetrahedron_walks.size(); ++i) {
                    const Walk& path = tetrahedron_walks[i];
                    const Matrix3 m = slope(corners(cube_, {r, g, b}, path), path);
                    bits |= lutlib::is_flat(m, rounding_) ? 1U << i : 0U;
                }
                flat_[cube_.index(r, g, b)] = static_cast<std::uint8_t>(bits);
                Box& box = outputs_[cube_.index(r, g, b)];
                box = {cube_.at(r, g, b), cube_.at(r, g, b)};
                for (int corner = 1; corner < 8; ++corner) {
                    const Rgb& output =
                        cube_.at(r + (corner & 1), g + (corner >> 1 & 1), b + (corner >> 2));
                    for (std::size_t c = 0; c < 3; ++c) {
                        box.low[c] = std::min(box.low[c], output[c]);
                        box.high[c] = std::max(box.high[c], output[c]);
                    }
                }
            }
        }
    });
}

RgbD OutputIndex::place(const std::array<double, 3>& lattice) const {
    RgbD out;
    for (std::size_t c = 0; c < 3; ++c) {
        const double min = cube_.domain.min[c], max = cube_.domain.max[c];
        out[c] = min + (max - min) * lattice[c] / (cube_.size - 1);
    }
    return out;
}

std::array<double, 3> OutputIndex::lattice_of(RgbD input) const {
    Place out{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double min = cube_.domain.min[c], max = cube_.domain.max[c];
        const double last = cube_.size - 1;
        out[c] = std::clamp((input[c] - min) / (max - min) * last, 0.0, last);
    }
    return out;
}

RgbD OutputIndex::share_of(RgbD input) const {
    for (std::size_t c = 0; c < 3; ++c) {
        const double min = cube_.domain.min[c], max = cube_.domain.max[c];
        input[c] = (input[c] - min) / (max - min);
    }
    return input;
}

} // namespace lutlib
