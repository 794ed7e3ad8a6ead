#include "lutlib/bake/budget.h"

#include "lutlib/bake/promise.h"
#include "lutlib/error.h"
#include "lutlib/fit/fit.h"
#include "lutlib/limits.h"

#include <algorithm>
#include <utility>

namespace lutlib {
namespace {

// Beyond it, lattices take seconds each, and are of use only where they hold the nodes of a look.
constexpr int largest_usual_size = 128;
// The largest side of a 2D texture: Direct3D 11's feature level 11_0, and what Vulkan has on
// desktops. An engine that gets a larger picture does not load it.
constexpr int largest_texture_side = 16384;
// Of combinations that all break the promise, those that are measured to find the nearest.
constexpr std::size_t measured_misses = 3;
// A glance weighs nodes in double where an engine's lookup has float.
constexpr double lookup_rounding = 1.002;

struct Combination {
    int size, bits;
};

bool accepts(const Engine& engine, int size, int bits) {
    try {
        check_contract(engine, size, bits);
        return true;
    } catch (const UsageError&) {
        return false;
    }
}

bool smaller(Combination a, Combination b) {
    return lattice_bytes(a.size, a.bits) < lattice_bytes(b.size, b.bits);
}

// Whether the engine takes the size without a setting in the project.
bool is_usual(const Engine& engine, int size) {
    const auto& usual = engine.usual_sizes;
    return usual.empty() || std::find(usual.begin(), usual.end(), size) != usual.end();
}

bool is_loadable(const Engine& engine, int size) {
    const std::optional<PictureSize> picture = layout_named(engine.layout)->picture(size);
    return picture && std::max(picture->width, picture->height) <= largest_texture_side;
}

// The combinations that the engine and the budget allow: those of usual sizes, smallest first, then
// the others.
std::vector<Combination> combinations(const Engine& engine, const Budget& budget) {
    std::vector<Combination> out;
    for (const int size :
         budget.size ? std::vector{*budget.size} : sizes_tried(engine, budget.nodes)) {
        for (const int bits : engine.bits) {
            if (budget.bits.value_or(bits) == bits && accepts(engine, size, bits)) {
                out.push_back({size, bits});
            }
        }
    }
    std::stable_sort(out.begin(), out.end(), smaller);
    std::stable_partition(out.begin(), out.end(),
                          [&](Combination c) { return is_usual(engine, c.size); });
    return out;
}

} // namespace

std::string fit_limit_text() {
    return "beyond " + std::to_string(largest_fitted_size) +
           " nodes point samples only: rounding rules the error there, not the lattice";
}

std::vector<int> sizes_tried(const Engine& engine, std::optional<int> nodes) {
    std::vector<int> out;
    if (!engine.sizes.empty()) {
        out.assign(engine.sizes.begin(), engine.sizes.end());
    } else {
        const int cells = nodes.value_or(limits::max_cube_size) - 1;
        for (int size = limits::min_cube_size; size <= limits::max_cube_size; ++size) {
            if (size <= largest_usual_size || (size - 1) % cells == 0) {
                out.push_back(size);
            }
        }
    }
    std::erase_if(out, [&](int size) { return !is_loadable(engine, size); });
    return out;
}

std::uint64_t lattice_bytes(int size, int bits) {
    const auto n = static_cast<std::uint64_t>(size);
    return n * n * n * 3 * static_cast<std::uint64_t>(bits) / 8;
}

namespace {

// The largest difference between the channels' errors, of greys.
double grey_tint(const CodeImage& codes, const Engine& engine, int size, const Transform& held) {
    constexpr int greys = 1024;
    const Picture picture = decoded(codes);
    double largest = 0;
    for (int i = 0; i <= greys; ++i) {
        const float grey = static_cast<float>(i) / greys;
        const Rgb in{grey, grey, grey};
        const RgbD e = to_double(engine.lookup(picture, size, in)) - held(to_double(in));
        largest = std::max(largest, std::max({e.r, e.g, e.b}) - std::min({e.r, e.g, e.b}));
    }
    return largest;
}

bool is_no_worse(const Difference& fit, const Difference& plain, Metric metric) {
    const ErrorStats &now = fit.by(metric), &before = plain.by(metric);
    // The climbs end within so much of a peak that both share.
    constexpr double same_peak = 1e-4;
    return now.max <= before.max * (1 + same_peak) && now.mean <= before.mean;
}

} // namespace

FilledBake bake_fitted(const Transform& look, const Engine& engine, int size, int bits,
                       const FitView& view) {
    FilledBake out{.bake = bake(look, engine, size, bits)};
    if (size > largest_fitted_size) {
        return out;
    }
    const Transform held = held_to_codes(look);
    const auto measured = [&](const CodeImage& codes) {
        return measure_lookup(codes, engine, size, held, view.breaks, view.viewing);
    };
    out.point_sampled = out.result = measured(out.bake.picture);
    out.tint = out.tint_of_point_samples = grey_tint(out.bake.picture, engine, size, held);
    const LatticeReader reader = reader_of(engine, size);
    const LatticeFit fit(held, reader, point_samples(held, reader), view);
    for (const double tightness : {1.0, 0.9}) {
        const FittedLattice lattice = fit.rounded(out.bake.picture.depth, tightness);
        if (!lattice.fitted) {
            break;
        }
        CodeImage picture = lay_out(lattice.nodes, engine, size, bits).picture;
        Difference error = measured(picture);
        if (is_no_worse(error, *out.point_sampled, Metric::code) &&
            is_no_worse(error, *out.point_sampled, eye_metric(view.viewing))) {
            out.fitted = true;
            out.tint = grey_tint(picture, engine, size, held);
            out.bake.picture = std::move(picture);
            out.result = std::move(error);
            out.look_loss = std::exchange(out.bake.loss, {});
            break;
        }
    }
    return out;
}

namespace {

class Search {
  public:
    Search(const Transform& look, const Engine& engine, const Budget& budget)
        : look_(look), engine_(engine), budget_(budget), check_(look, engine, budget) {}

    /// Point samples, then a fit: the first that keeps the promise.
    std::optional<FilledBake> attempt(Combination c) {
        ++tried_;
        const bool may_fit = budget_.fit && c.size <= largest_fitted_size && fits_ < most_fits;
        const double limit = budget_.most * (may_fit ? fit_reach : 1);
        double largest = check_.glance(c.size, c.bits, limit * lookup_rounding);
        if (largest <= limit * lookup_rounding) {
            FilledBake plain{.bake = bake(look_, engine_, c.size, c.bits)};
            const double found = check_.largest_error(plain.bake, limit);
            if (found <= budget_.most) {
                return plain;
            }
            largest = std::max(largest, found);
        }
        if (may_fit && largest <= limit) {
            ++fits_;
            FilledBake fitted =
                bake_fitted(look_, engine_, c.size, c.bits, {budget_.breaks, budget_.viewing});
            const double found = fitted.result->by(budget_.metric).max;
            if (fitted.fitted && found <= budget_.most) {
                return fitted;
            }
            largest = std::min(largest, found);
        }
        misses_.push_back({largest, c});
        return std::nullopt;
    }

    BudgetBake measured(FilledBake filled) const {
        BudgetBake out{std::move(filled), {}, 0, false, tried_};
        const Bake& bake = out.filled.bake;
        out.error = out.filled.result ? *out.filled.result
                                      : measure_lookup(bake.picture, engine_, bake.size, look_,
                                                       budget_.breaks, budget_.viewing);
        out.largest = out.error.by(budget_.metric).max;
        out.kept = out.largest <= budget_.most;
        return out;
    }

    /// When none keeps the promise.
    BudgetBake nearest() {
        std::stable_sort(misses_.begin(), misses_.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        std::optional<BudgetBake> best;
        for (std::size_t i = 0; i < std::min(measured_misses, misses_.size()); ++i) {
            const Combination c = misses_[i].second;
            const auto is_further = [&](double error) { return best && error > best->largest; };
            if (best && is_further(check_.glance(c.size, c.bits, best->largest))) {
                continue;
            }
            FilledBake plain{.bake = bake(look_, engine_, c.size, c.bits)};
            if (best && is_further(check_.largest_error(plain.bake, best->largest))) {
                continue;
            }
            BudgetBake now = measured(std::move(plain));
            if (!best || now.largest < best->largest) {
                best = std::move(now);
            }
        }
        return *best;
    }

  private:
    const Transform& look_;
    const Engine& engine_;
    const Budget& budget_;
    PromiseCheck check_;
    std::vector<std::pair<double, Combination>> misses_; // with an error that was met
    std::size_t tried_ = 0;
    int fits_ = 0;
};

} // namespace

BudgetBake bake_within(const Transform& look, const Engine& engine, const Budget& budget) {
    const std::vector<Combination> all = combinations(engine, budget);
    if (all.empty()) {
        check_contract(engine, budget.size.value_or(engine.default_size),
                       budget.bits.value_or(engine.default_bits));
    }
    Search search(look, engine, budget);
    for (const Combination& c : all) {
        if (std::optional<FilledBake> found = search.attempt(c)) {
            BudgetBake out = search.measured(std::move(*found));
            if (out.kept) {
                return out;
            }
        }
    }
    return search.nearest();
}

} // namespace lutlib
