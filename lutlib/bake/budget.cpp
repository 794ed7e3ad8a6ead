#include "lutlib/bake/budget.h"

#include "lutlib/color/difference.h"
#include "lutlib/error.h"
#include "lutlib/fit/fit.h"
#include "lutlib/limits.h"
#include "lutlib/metrics/peak.h"
#include "lutlib/metrics/samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <utility>

namespace lutlib {
namespace {

// The sizes of most looks are among them, and a look's own nodes err less than more of others do.
constexpr std::array<int, 10> usual_sizes{8, 9, 16, 17, 25, 32, 33, 49, 64, 65};

constexpr SampleCounts glance{.neutral = 256, .random = 2048, .lattice = false};
constexpr SampleCounts choosing{.neutral = 1024, .random = 20000, .lattice = false};
constexpr SampleCounts checking{
    .neutral = 997, .random = 100000, .lattice = false, .skipped = choosing.random};

// A fit lowers the largest difference by less than this factor: by 1.54 at most on six looks at 6
// to 29 nodes.
constexpr double hopeless = 1.75;

// Errors fall with size, but not from each size to the next.
constexpr std::size_t steps_below = 2;

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

// The combinations of these sizes that the engine and the budget allow, smallest first.
std::vector<Combination> combinations(const Engine& engine, const Budget& budget,
                                      std::span<const int> sizes) {
    std::vector<Combination> out;
    const auto usual = engine.usual_sizes;
    for (const int size : sizes) {
        if (!budget.size && !usual.empty() &&
            std::find(usual.begin(), usual.end(), size) == usual.end()) {
            continue;
        }
        for (const int bits : engine.bits) {
            if (budget.bits.value_or(bits) == bits && accepts(engine, size, bits)) {
                out.push_back({size, bits});
            }
        }
    }
    std::stable_sort(out.begin(), out.end(), smaller);
    return out;
}

// Colours with the answers that are right for them.
struct Questions {
    std::vector<Rgb> inputs;
    std::vector<RgbD> expected;

    Questions(const Transform& look, const SampleCounts& counts)
        : inputs(sample_colors(2, counts)), expected(images_of(look, inputs)) {}
};

class Examiner {
  public:
    Examiner(const Transform& look, const Engine& engine) : look_(look), engine_(engine) {}

    double difference(const Picture& picture, int size, Rgb in) const {
        return delta_e_2000(to_double(engine_.lookup(picture, size, in)),
                            saturate(look_(to_double(in))));
    }

    void climb(const Bake& bake, const std::vector<Rgb>& inputs, LookupError& error) const {
        const Picture picture = decoded(bake.picture);
        error.delta_e.max =
            std::max(error.delta_e.max,
                     peak_error(inputs, {}, 1.0F / static_cast<float>(bake.size - 1),
                                [&](Rgb in) { return difference(picture, bake.size, in); }));
    }

    LookupError examine(const Bake& bake, const Questions& questions) const {
        return lookup_error(engine_, decoded(bake.picture), bake.size, questions.inputs,
                            questions.expected);
    }

  private:
    const Transform& look_;
    const Engine& engine_;
};

} // namespace

double BudgetBake::largest_delta_e() const {
    return std::max(chosen_on.delta_e.max, checked_on.delta_e.max);
}

std::string fit_limit_text() {
    return "beyond " + std::to_string(largest_fitted_size) +
           " nodes point samples only: rounding rules the error there, not the lattice";
}

std::uint64_t lattice_bytes(int size, int bits) {
    const auto n = static_cast<std::uint64_t>(size);
    return n * n * n * 3 * static_cast<std::uint64_t>(bits) / 8;
}

FilledBake bake_fitted(const Transform& look, const Engine& engine, int size, int bits) {
    FilledBake out{bake(look, engine, size, bits), false, {}, {}};
    if (size > largest_fitted_size) {
        return out;
    }
    const Transform held = in_sequence({look, Transform::each([](RgbD c) { return saturate(c); })});
    const LatticeReader reader = reader_of(engine, size);
    std::vector<RgbD> nodes = point_samples(held, reader);
    const FittedLattice fit =
        LatticeFit(held, reader, std::move(nodes)).rounded(out.bake.picture.depth);
    out.fitted = fit.fitted;
    out.point_sampled = fit.point_sampled;
    out.result = fit.result;
    if (fit.fitted) {
        out.bake.picture = lay_out(fit.nodes, engine, size, bits).picture;
        out.look_loss = std::exchange(out.bake.loss, {});
    }
    return out;
}

namespace {

class Search {
  public:
    Search(const Transform& look, const Engine& engine, const Budget& budget)
        : look_(look), engine_(engine), budget_(budget), examiner_(look, engine),
          quick_(look, glance), choice_(look, choosing), check_(look, checking) {}

    // Point samples, then a fit: the first that keeps the promise, else the nearer one. Without
    // `checked` it is enough to keep it on the colours to choose by, and `kept` stays false.
    BudgetBake attempt(Combination c, bool checked) {
        std::optional<BudgetBake> best;
        for (const bool fit : {false, true}) {
            if (fit && (!budget_.fit || c.size > largest_fitted_size)) {
                continue;
            }
            BudgetBake now;
            now.filled = fit ? bake_fitted(look_, engine_, c.size, c.bits)
                             : FilledBake{bake(look_, engine_, c.size, c.bits), false, {}, {}};
            if (fit && !now.filled.fitted) {
                continue;
            }
            ++tried_;
            now.chosen_on = examiner_.examine(now.filled.bake, quick_);
            const double first_sight = now.chosen_on.delta_e.max;
            if (first_sight <= budget_.max_delta_e) {
                now.chosen_on = examiner_.examine(now.filled.bake, choice_);
            }
            if (promising(now) && checked) {
                check(now);
            }
            if (checked ? now.kept : promising(now)) {
                return now;
            }
            if (!best || now.largest_delta_e() < best->largest_delta_e()) {
                best = std::move(now);
            }
            if (first_sight > hopeless * budget_.max_delta_e) {
                break;
            }
        }
        return *best;
    }

    bool promising(const BudgetBake& b) const {
        return b.chosen_on.delta_e.max <= budget_.max_delta_e;
    }

    void check(BudgetBake& b) const {
        b.checked_on = examiner_.examine(b.filled.bake, check_);
        examiner_.climb(b.filled.bake, check_.inputs, b.checked_on);
        b.kept = promising(b) && b.checked_on.delta_e.max <= budget_.max_delta_e;
    }

    void examine_in_full(BudgetBake& b) const {
        b.chosen_on = examiner_.examine(b.filled.bake, choice_);
        check(b);
    }

    // Of combinations between one that does not keep the promise and `found`, which does, smallest
    // first: the first that keeps it, looked for by halves, then a little below; else `found`.
    BudgetBake smallest(const std::vector<Combination>& between, BudgetBake found) {
        const auto promises = [&](std::size_t i) { return promising(attempt(between[i], false)); };
        std::size_t low = 0, high = between.size();
        while (low < high) {
            const std::size_t middle = low + (high - low) / 2;
            if (promises(middle)) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        std::size_t first = high;
        // The one before was tried, or there is none.
        for (std::size_t step = 2; step < 2 + steps_below && step <= high; ++step) {
            first = promises(high - step) ? high - step : first;
        }
        for (; first < between.size(); ++first) {
            BudgetBake now = attempt(between[first], true);
            if (now.kept) {
                return now;
            }
        }
        return found;
    }

    std::size_t tried() const { return tried_; }

  private:
    const Transform& look_;
    const Engine& engine_;
    const Budget& budget_;
    Examiner examiner_;
    Questions quick_, choice_, check_;
    std::size_t tried_ = 0;
};

} // namespace

BudgetBake bake_within(const Transform& look, const Engine& engine, const Budget& budget) {
    std::span<const int> sizes = usual_sizes;
    if (budget.size) {
        sizes = {&*budget.size, 1};
    } else if (!engine.sizes.empty()) {
        sizes = engine.sizes;
    }
    const std::vector<Combination> usual = combinations(engine, budget, sizes);
    if (usual.empty()) {
        check_contract(engine, sizes.front(), budget.bits.value_or(engine.default_bits));
    }
    Search search(look, engine, budget);
    std::optional<BudgetBake> best;
    std::map<int, int> too_small; // by bits
    for (const Combination& c : usual) {
        BudgetBake now = search.attempt(c, true);
        if (!best || now.kept || now.largest_delta_e() < best->largest_delta_e()) {
            best = std::move(now);
        }
        if (best->kept) {
            break;
        }
        too_small[c.bits] = c.size;
    }
    if (!best->kept) {
        search.examine_in_full(*best);
    } else if (!budget.size && engine.sizes.empty()) {
        std::vector<int> others(usual_sizes.back() + 1 - limits::min_cube_size);
        std::iota(others.begin(), others.end(), limits::min_cube_size);
        for (const int bits : engine.bits) {
            std::vector<Combination> between = combinations(engine, budget, others);
            const Combination found{best->filled.bake.size, best->filled.bake.picture.depth.bits};
            std::erase_if(between, [&](Combination c) {
                return c.bits != bits || c.size <= too_small[bits] || !smaller(c, found);
            });
            best = search.smallest(between, std::move(*best));
        }
    }
    best->tried = search.tried();
    return *best;
}

} // namespace lutlib
