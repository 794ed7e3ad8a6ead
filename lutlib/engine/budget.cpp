#include "lutlib/engine/budget.h"

#include "lutlib/color/difference.h"
#include "lutlib/error.h"
#include "lutlib/fit/fit.h"
#include "lutlib/metrics/peak.h"
#include "lutlib/metrics/samples.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

constexpr std::array<int, 10> usual_sizes{8, 9, 16, 17, 25, 32, 33, 49, 64, 65};

constexpr SampleCounts glance{.neutral = 256, .random = 2048, .lattice = false};
constexpr SampleCounts choosing{.neutral = 1024, .random = 20000, .lattice = false};
constexpr SampleCounts checking{
    .neutral = 997, .random = 100000, .lattice = false, .skipped = choosing.random};

// A fit lowers the largest difference by less than this factor on any look seen.
constexpr double hopeless = 3;

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

std::vector<Combination> combinations(const Engine& engine, const Budget& budget) {
    std::vector<int> sizes(usual_sizes.begin(), usual_sizes.end());
    if (budget.size) {
        sizes = {*budget.size};
    } else if (!engine.sizes.empty()) {
        sizes.assign(engine.sizes.begin(), engine.sizes.end());
    }
    std::vector<Combination> out;
    for (const int size : sizes) {
        for (const int bits : engine.bits) {
            if (budget.bits.value_or(bits) == bits && accepts(engine, size, bits)) {
                out.push_back({size, bits});
            }
        }
    }
    if (out.empty()) {
        check_contract(engine, sizes.front(), budget.bits.value_or(engine.default_bits));
    }
    std::stable_sort(out.begin(), out.end(), [](Combination a, Combination b) {
        return lattice_bytes(a.size, a.bits) < lattice_bytes(b.size, b.bits);
    });
    return out;
}

// Colours with the answers that are right for them.
struct Questions {
    std::vector<Rgb> inputs, expected;

    Questions(const ExactLook& look, const SampleCounts& counts)
        : inputs(sample_colors(2, counts)), expected(inputs.size()) {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, inputs.size(), 1024),
                          [&](const auto& range) {
                              for (std::size_t i = range.begin(); i < range.end(); ++i) {
                                  expected[i] = to_float(saturate(look(to_double(inputs[i]))));
                              }
                          });
    }
};

class Examiner {
  public:
    Examiner(const ExactLook& look, const Engine& engine) : look_(look), engine_(engine) {}

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
    const ExactLook& look_;
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

FilledBake bake_fitted(const ExactLook& look, const Engine& engine, int size, int bits) {
    FilledBake out{bake(look, engine, size, bits), false, {}, {}};
    if (size > largest_fitted_size) {
        return out;
    }
    const Transform held = each_colour([&look](RgbD c) { return saturate(look(c)); });
    const LatticeReader reader = reader_of(engine, size);
    std::vector<RgbD> nodes = point_samples(held, reader);
    const FittedLattice fit =
        LatticeFit(held, reader, std::move(nodes)).rounded(out.bake.picture.maximum());
    out.fitted = fit.fitted;
    out.point_sampled = fit.point_sampled;
    out.result = fit.result;
    if (fit.fitted) {
        out.bake.picture = lay_out(fit.nodes, engine, size, bits).picture;
    }
    return out;
}

BudgetBake bake_within(const ExactLook& look, const Engine& engine, const Budget& budget) {
    const Examiner examiner(look, engine);
    const Questions quick(look, glance), choice(look, choosing), check(look, checking);
    std::optional<BudgetBake> best;
    std::size_t tried = 0;
    for (const Combination& c : combinations(engine, budget)) {
        for (const bool fit : {false, true}) {
            if (fit && (!budget.fit || c.size > largest_fitted_size)) {
                continue;
            }
            BudgetBake now;
            now.filled = fit ? bake_fitted(look, engine, c.size, c.bits)
                             : FilledBake{bake(look, engine, c.size, c.bits), false, {}, {}};
            if (fit && !now.filled.fitted) {
                continue;
            }
            ++tried;
            now.chosen_on = examiner.examine(now.filled.bake, quick);
            const double first_sight = now.chosen_on.delta_e.max;
            if (first_sight <= budget.max_delta_e) {
                now.chosen_on = examiner.examine(now.filled.bake, choice);
            }
            if (now.chosen_on.delta_e.max <= budget.max_delta_e) {
                now.checked_on = examiner.examine(now.filled.bake, check);
                examiner.climb(now.filled.bake, check.inputs, now.checked_on);
                now.kept = now.checked_on.delta_e.max <= budget.max_delta_e;
            }
            if (now.kept) {
                now.tried = tried;
                return now;
            }
            if (!best || now.largest_delta_e() < best->largest_delta_e()) {
                best = std::move(now);
            }
            if (first_sight > hopeless * budget.max_delta_e) {
                break;
            }
        }
    }
    best->chosen_on = examiner.examine(best->filled.bake, choice);
    best->checked_on = examiner.examine(best->filled.bake, check);
    examiner.climb(best->filled.bake, check.inputs, best->checked_on);
    best->tried = tried;
    return *best;
}

} // namespace lutlib
