#include "lutlib/bake/stack.h"

#include "lutlib/error.h"

#include <algorithm>
#include <array>
#include <string>

namespace lutlib {
namespace {

struct Stacking {
    std::string_view engine, source;
};
constexpr std::array<Stacking, 1> stackings{{{"reshade", "ReShade, MultiLUT.fx"}}};

} // namespace

bool reads_stacks(const Engine& engine) {
    return std::any_of(stackings.begin(), stackings.end(),
                       [&](const Stacking& row) { return row.engine == engine.name; });
}

Bake stacked(const std::vector<Bake>& bakes) {
    const Bake& first = bakes.front();
    if (!reads_stacks(*first.engine)) {
        throw UsageError(std::string(first.engine->name) + " reads one lattice a picture; bake "
                                                           "each by itself");
    }
    Bake out{first.engine, first.size, {}, {}};
    out.picture.width = first.picture.width;
    out.picture.depth = first.picture.depth;
    for (const Bake& one : bakes) {
        if (one.engine != first.engine || one.size != first.size ||
            one.picture.depth != first.picture.depth) {
            throw UsageError("pictures of one engine, size and depth can be stacked alone");
        }
        out.picture.height += one.picture.height;
        out.picture.samples.insert(out.picture.samples.end(), one.picture.samples.begin(),
                                   one.picture.samples.end());
        out.loss.clamped_values += one.loss.clamped_values;
        out.loss.most_clamped = std::max(out.loss.most_clamped, one.loss.most_clamped);
        out.loss.max_rounding = std::max(out.loss.max_rounding, one.loss.max_rounding);
        out.loss.mean_rounding += one.loss.mean_rounding / static_cast<double>(bakes.size());
    }
    return out;
}

} // namespace lutlib
