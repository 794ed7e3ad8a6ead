#include "preview/finish/bloom_dispatches.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace preview {

namespace {

int texels_of(const BloomPlan& plan, int image) {
    const BloomExtent& extent = plan.images[static_cast<std::size_t>(image)];
    return extent.width * extent.height;
}

bool reads(const BloomStep& step, int image) {
    return step.source == image || step.own == image;
}

/// The last of the `count` steps from `first` on that reads what the step `made` makes.
std::size_t last_reader(const BloomPlan& plan, std::size_t first, std::size_t count,
                        std::size_t made) {
    std::size_t last = made;
    for (std::size_t i = made + 1; i < first + count; ++i) {
        last = reads(plan.steps[i], plan.steps[made].target) ? i : last;
    }
    return last;
}

/// Whether nobody but the run itself reads what its steps before the last make.
bool is_closed(const BloomPlan& plan, std::size_t first, std::size_t count) {
    for (std::size_t made = first; made + 1 < first + count; ++made) {
        const int image = plan.steps[made].target;
        const auto later = plan.steps.begin() + static_cast<std::ptrdiff_t>(first + count);
        if (plan.last.image == image ||
            std::any_of(later, plan.steps.end(),
                        [&](const BloomStep& step) { return reads(step, image); })) {
            return false;
        }
    }
    return true;
}

/// The only image that the run reads of those it does not make; nothing where there are several, or
/// where it is the picture.
std::optional<int> only_source(const BloomPlan& plan, std::size_t first, std::size_t count) {
    std::optional<int> found;
    for (std::size_t i = first; i < first + count; ++i) {
        const BloomStep& step = plan.steps[i];
        for (const int image : {step.source, step.own < 0 ? step.source : step.own}) {
            const auto made = plan.steps.begin() + static_cast<std::ptrdiff_t>(first);
            const bool is_made =
                std::any_of(made, made + static_cast<std::ptrdiff_t>(i - first),
                            [&](const BloomStep& it) { return it.target == image; });
            if (is_made) {
                continue;
            }
            if (image == BloomPlan::picture_image || (found && *found != image)) {
                return {};
            }
            found = image;
        }
    }
    return found;
}

/// Where the targets of a run lie in shared memory; nothing where they do not fit. A target may lie
/// upon what its step is the last to read: a group reads all before it writes.
std::optional<std::vector<int>> places_of(const BloomPlan& plan, std::size_t first,
                                          std::size_t count) {
    std::vector<int> places;
    for (std::size_t i = first; i + 1 < first + count; ++i) {
        const int size = texels_of(plan, plan.steps[i].target);
        int place = 0;
        const auto overlapped = [&]() -> std::optional<int> {
            for (std::size_t other = first; other < i; ++other) {
                const int begin = places[other - first];
                const int end = begin + texels_of(plan, plan.steps[other].target);
                if (last_reader(plan, first, count, other) > i && place < end &&
                    begin < place + size) {
                    return end;
                }
            }
            return {};
        };
        while (const std::optional<int> end = overlapped()) {
            place = *end;
        }
        if (place + size > BloomDispatch::group_texels) {
            return {};
        }
        places.push_back(place);
    }
    return places;
}

/// Whether a group has the memory and the threads for a step's target.
bool fits(const BloomPlan& plan, const BloomStep& step) {
    if (texels_of(plan, step.target) > BloomDispatch::group_texels) {
        return false;
    }
    const BloomExtent& extent = plan.images[static_cast<std::size_t>(step.target)];
    const auto threads = [](int length, int lines) {
        return (length + BloomDispatch::thread_texels - 1) / BloomDispatch::thread_texels * lines;
    };
    constexpr int group = BloomDispatch::group_threads;
    switch (step.axis) {
    case BloomStep::Axis::x:
        return threads(extent.width, extent.height) <= group;
    case BloomStep::Axis::y:
        return threads(extent.height, extent.width) <= group;
    case BloomStep::Axis::both:
        break;
    }
    return extent.height <= BloomDispatch::thread_texels * (group / extent.width);
}

/// The longest run from there on that one group can do.
std::optional<BloomDispatch> small_run(const BloomPlan& plan, std::size_t first) {
    std::size_t most = 0, rows = 0;
    while (first + most < plan.steps.size() && most < BloomDispatch::most_steps) {
        const BloomStep& step = plan.steps[first + most];
        rows += rows_of(step);
        if (step.prefilter || step.karis || !fits(plan, step) || rows > BloomDispatch::most_rows) {
            break;
        }
        ++most;
    }
    for (std::size_t count = most; count > 1; --count) {
        const std::optional<int> source = only_source(plan, first, count);
        if (!source || !is_closed(plan, first, count)) {
            continue;
        }
        if (std::optional<std::vector<int>> places = places_of(plan, first, count)) {
            return BloomDispatch{BloomDispatch::Kind::small, first, count, *source,
                                 std::move(*places)};
        }
    }
    return {};
}

bool is_quarter(const BloomPlan& plan, std::size_t first) {
    if (first + 1 >= plan.steps.size()) {
        return false;
    }
    const BloomStep& one = plan.steps[first];
    BloomStep other = plan.steps[first + 1];
    other.taps = texel_taps(other.taps);
    return one.source != BloomPlan::picture_image && one.scale == 2 && !one.prefilter &&
           !one.karis && one.own < 0 && other.source == one.target && !other.prefilter &&
           halves_by_texels(other) && is_closed(plan, first, 2);
}

bool is_blur(const BloomPlan& plan, std::size_t first) {
    if (first + 1 >= plan.steps.size()) {
        return false;
    }
    const BloomStep& x = plan.steps[first];
    const BloomStep& y = plan.steps[first + 1];
    return x.axis == BloomStep::Axis::x && y.axis == BloomStep::Axis::y && x.own < 0 &&
           y.source == x.target && is_closed(plan, first, 2) &&
           std::max(x.taps.back().x, y.taps.back().x) <=
               static_cast<float>(BloomDispatch::most_reach);
}

} // namespace

std::vector<BloomDispatch> bloom_dispatches(const BloomPlan& plan, bool fuses) {
    std::vector<BloomDispatch> out;
    for (std::size_t i = 0; i < plan.steps.size(); i += out.back().count) {
        if (std::optional<BloomDispatch> run = fuses ? small_run(plan, i) : std::nullopt) {
            out.push_back(std::move(*run));
        } else if (fuses && is_quarter(plan, i)) {
            out.push_back({BloomDispatch::Kind::quarter, i, 2, plan.steps[i].source, {}});
        } else if (fuses && is_blur(plan, i)) {
            out.push_back({BloomDispatch::Kind::blur, i, 2, plan.steps[i].source, {}});
        } else {
            out.push_back({BloomDispatch::Kind::step, i, 1, plan.steps[i].source, {}});
        }
    }
    return out;
}

bool halves_by_texels(const BloomStep& step) {
    const auto on_texel = [](float v) { return std::abs(v) == 0.5F || std::abs(v) == 1.5F; };
    return step.scale == 2 && !step.karis && step.own < 0 &&
           std::all_of(step.taps.begin(), step.taps.end(),
                       [&](const BloomTap& tap) { return on_texel(tap.x) && on_texel(tap.y); });
}

std::size_t rows_of(const BloomStep& step) {
    const std::size_t rows =
        step.axis == BloomStep::Axis::both
            ? step.taps.size()
            : std::size_t{BloomDispatch::thread_texels} + 2 * (texel_weights(step.taps).size() - 1);
    return (rows + 3) / 4 * 4;
}

std::vector<float> texel_weights(const std::vector<BloomTap>& half) {
    std::vector<float> weights{half.front().weight};
    for (std::size_t i = 1; i < half.size(); ++i) {
        const float first = std::floor(half[i].x), part = half[i].x - first;
        weights.resize(static_cast<std::size_t>(first) + 1);
        weights.back() += (1 - part) * half[i].weight;
        if (part > 0) {
            weights.push_back(part * half[i].weight);
        }
    }
    return weights;
}

} // namespace preview
