#include "lutlib/io/ocio/chain.h"

#include <algorithm>
#include <cmath>

namespace lutlib::io {
namespace {

template <class T>
std::shared_ptr<const T> as(const OCIO::ConstTransformRcPtr& op) {
    return std::dynamic_pointer_cast<const T>(op);
}

bool is_forward(const OCIO::Transform& op) {
    return op.getDirection() == OCIO::TRANSFORM_DIR_FORWARD;
}

void flatten(const OCIO::ConstTransformRcPtr& op, Chain& out) {
    if (const auto group = as<OCIO::GroupTransform>(op)) {
        for (int i = 0; i < group->getNumTransforms(); ++i) {
            flatten(group->getTransform(i), out);
        }
    } else {
        out.push_back(op);
    }
}

bool rising(const ChannelMaps& maps) {
    return std::all_of(maps.begin(), maps.end(),
                       [](const ChannelMap& map) { return map.scale > 0; });
}

// Clamps to low..high what `map` gives now.
void append_clamp(ChannelMap& map, double low, double high) {
    map.low = std::max(map.low, (low - map.offset) / map.scale);
    map.high = std::min(map.high, (high - map.offset) / map.scale);
}

void append_line(ChannelMap& map, double scale, double offset) {
    map.offset = scale * map.offset + offset;
    map.scale *= scale;
}

bool append_range(ChannelMaps& maps, const OCIO::RangeTransform& range) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const bool low = range.hasMinInValue(), high = range.hasMaxInValue();
    const double min_in = range.getMinInValue(), max_in = range.getMaxInValue();
    const double scale =
        low && high ? (range.getMaxOutValue() - range.getMinOutValue()) / (max_in - min_in) : 1;
    const double offset =
        low ? range.getMinOutValue() - scale * min_in : range.getMaxOutValue() - scale * max_in;
    if (!is_forward(range) || (!low && !high) || !(scale > 0) || !rising(maps)) {
        return false;
    }
    for (ChannelMap& map : maps) {
        if (range.getStyle() == OCIO::RANGE_CLAMP) {
            append_clamp(map, low ? min_in : -infinity, high ? max_in : infinity);
        }
        append_line(map, scale, offset);
    }
    return true;
}

} // namespace

Chain chain_of(const OCIO::ConstProcessorRcPtr& processor) {
    Chain out;
    flatten(processor->createGroupTransform(), out);
    return out;
}

OCIO::ConstProcessorRcPtr processor_of_chain(const Chain& chain, std::size_t first) {
    const OCIO::GroupTransformRcPtr group = OCIO::GroupTransform::Create();
    for (std::size_t i = first; i < chain.size(); ++i) {
        group->appendTransform(chain[i]->createEditableCopy());
    }
    return processor_of_transform(group);
}

std::optional<Affine> affine_of(const OCIO::ConstTransformRcPtr& op) {
    const auto matrix = as<OCIO::MatrixTransform>(op);
    if (!matrix || !is_forward(*matrix)) {
        return std::nullopt;
    }
    std::array<double, 16> m;
    std::array<double, 4> offset;
    matrix->getMatrix(m.data());
    matrix->getOffset(offset.data());
    Affine out{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            out.rows[row][column] = m[row * 4 + column];
            out.mixes = out.mixes || (row != column && m[row * 4 + column] != 0);
        }
        if (m[row * 4 + 3] != 0) {
            return std::nullopt; // alpha has no place in a look
        }
        out.rows[row][3] = offset[row];
    }
    return out;
}

Rgb Affine::operator()(Rgb c) const {
    Rgb out;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& row = rows[i];
        out[i] = static_cast<float>(row[0] * static_cast<double>(c.r) +
                                    row[1] * static_cast<double>(c.g) +
                                    row[2] * static_cast<double>(c.b) + row[3]);
    }
    return out;
}

bool append(ChannelMaps& maps, const OCIO::ConstTransformRcPtr& op) {
    if (const auto range = as<OCIO::RangeTransform>(op)) {
        return append_range(maps, *range);
    }
    const std::optional<Affine> affine = affine_of(op);
    if (!affine || affine->mixes) {
        return false;
    }
    for (std::size_t c = 0; c < 3; ++c) {
        append_line(maps[c], affine->rows[c][c], affine->rows[c][3]);
    }
    return true;
}

bool append_straight(ChannelMaps& maps, const Lut1D& curve) {
    const Rgb first = curve.entries.front(), last = curve.entries.back();
    for (std::size_t c = 0; c < 3; ++c) {
        const double low = first[c], high = last[c];
        const double rounding = 2e-7 * std::max(std::abs(low), std::abs(high));
        for (int i = 0; i < curve.size(); ++i) {
            const double line = low + (high - low) * i / (curve.size() - 1);
            if (std::abs(curve.entries[static_cast<std::size_t>(i)][c] - line) > rounding) {
                return false;
            }
        }
        if (!(high > low)) {
            return false;
        }
    }
    if (!rising(maps)) {
        return false;
    }
    for (std::size_t c = 0; c < 3; ++c) {
        append_clamp(maps[c], 0, 1);
        append_line(maps[c], static_cast<double>(last[c]) - static_cast<double>(first[c]),
                    first[c]);
    }
    return true;
}

std::optional<Domain> domain_of_unit(const ChannelMaps& maps) {
    Domain out;
    for (std::size_t c = 0; c < 3; ++c) {
        const ChannelMap& map = maps[c];
        const double min = (0 - map.offset) / map.scale, max = (1 - map.offset) / map.scale;
        // Readers scale in float, so the clamp and the table's end may differ by some roundings.
        const double slack = 1e-6 * (max - min);
        if (!(map.scale > 0) || !(max - min < std::numeric_limits<float>::max()) ||
            map.low > min + slack || map.high < max - slack) {
            return std::nullopt;
        }
        out.min[c] = static_cast<float>(min);
        out.max[c] = static_cast<float>(max);
    }
    return out;
}

std::optional<Domain> domain_onto(const ChannelMaps& maps, const Domain& values) {
    Domain out;
    for (std::size_t c = 0; c < 3; ++c) {
        const ChannelMap& map = maps[c];
        const double min = (static_cast<double>(values.min[c]) - map.offset) / map.scale;
        const double max = (static_cast<double>(values.max[c]) - map.offset) / map.scale;
        out.min[c] = static_cast<float>(std::max(min, map.low));
        out.max[c] = static_cast<float>(std::min(max, map.high));
        if (!(map.scale > 0) || !(out.min[c] < out.max[c])) {
            return std::nullopt;
        }
    }
    return out;
}

std::optional<Domain> values_of_inverse(const OCIO::ConstTransformRcPtr& op) {
    const auto table = as<OCIO::Lut1DTransform>(op);
    if (!table || is_forward(*table) || table->getInputHalfDomain() || table->getLength() == 0) {
        return std::nullopt;
    }
    Domain out;
    table->getValue(0, out.min.r, out.min.g, out.min.b);
    out.max = out.min;
    for (unsigned long i = 1; i < table->getLength(); ++i) {
        Rgb entry;
        table->getValue(i, entry.r, entry.g, entry.b);
        for (std::size_t c = 0; c < 3; ++c) {
            out.min[c] = std::min(out.min[c], entry[c]);
            out.max[c] = std::max(out.max[c], entry[c]);
        }
    }
    return out;
}

std::optional<Lut1D> curve_of(const OCIO::ConstTransformRcPtr& op) {
    const auto table = as<OCIO::Lut1DTransform>(op);
    if (!table || !is_forward(*table) || table->getInputHalfDomain() ||
        table->getHueAdjust() != OCIO::HUE_NONE) {
        return std::nullopt;
    }
    const unsigned long length = table->getLength();
    check_shaper_size(static_cast<long long>(length));
    Lut1D out;
    out.entries.resize(length);
    for (unsigned long i = 0; i < length; ++i) {
        Rgb& entry = out.entries[i];
        table->getValue(i, entry.r, entry.g, entry.b);
    }
    return out;
}

std::optional<Lut3D> cube_of(const OCIO::ConstTransformRcPtr& op) {
    const auto table = as<OCIO::Lut3DTransform>(op);
    if (!table || !is_forward(*table)) {
        return std::nullopt;
    }
    const unsigned long size = table->getGridSize();
    check_cube_size(static_cast<long long>(size));
    Lut3D out;
    out.size = static_cast<int>(size);
    out.nodes.resize(size * size * size);
    for (unsigned long b = 0; b < size; ++b) {
        for (unsigned long g = 0; g < size; ++g) {
            for (unsigned long r = 0; r < size; ++r) {
                Rgb& node = out.nodes[r + size * (g + size * b)];
                table->getValue(r, g, b, node.r, node.g, node.b);
            }
        }
    }
    return out;
}

} // namespace lutlib::io
