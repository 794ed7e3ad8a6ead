#include "preview/finish/scope_csv.h"

#include <fmt/format.h>

#include <iterator>

namespace preview {

namespace {

constexpr std::array<std::string_view, 4> channels{"red", "green", "blue", "luma"};

double value_of(const ScopeLevels& levels, std::size_t level) {
    return level_value(levels, static_cast<double>(level) / (scope_levels - 1));
}

std::string columns_csv(const Scope& scope, std::span<const std::uint32_t> counts,
                        const ScopeLevels& levels) {
    std::string out = fmt::format("channel,column,level,value ({}),count\n", level_unit(levels));
    const std::size_t columns = counts.size() / scope.planes / scope_levels;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] > 0) {
            const std::size_t level = i % scope_levels, column = i / scope_levels % columns;
            const std::size_t plane = i / scope_levels / columns;
            fmt::format_to(std::back_inserter(out), "{},{},{},{:.6g},{}\n",
                           scope.planes == 1 ? channels[3] : channels[plane], column, level,
                           value_of(levels, level), counts[i]);
        }
    }
    return out;
}

std::string chroma_csv(std::span<const std::uint32_t> counts) {
    std::string out = "cb,cr,count\n";
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] > 0) {
            fmt::format_to(std::back_inserter(out), "{},{},{}\n", i % scope_levels,
                           i / scope_levels, counts[i]);
        }
    }
    return out;
}

std::string levels_csv(std::span<const std::uint32_t> counts, const ScopeLevels& levels) {
    std::string out =
        fmt::format("level,value ({}),{}\n", level_unit(levels), fmt::join(channels, ","));
    for (std::size_t level = 0; level < scope_levels; ++level) {
        fmt::format_to(std::back_inserter(out), "{},{:.6g}", level, value_of(levels, level));
        for (std::size_t plane = 0; plane < channels.size(); ++plane) {
            fmt::format_to(std::back_inserter(out), ",{}", counts[plane * scope_levels + level]);
        }
        out += '\n';
    }
    return out;
}

} // namespace

std::string scope_csv(const Scope& scope, std::span<const std::uint32_t> counts,
                      const ScopeLevels& levels) {
    switch (scope.bins) {
    case ScopeBins::columns:
        return columns_csv(scope, counts, levels);
    case ScopeBins::chroma:
        return chroma_csv(counts);
    case ScopeBins::levels:
        break;
    }
    return levels_csv(counts, levels);
}

} // namespace preview
