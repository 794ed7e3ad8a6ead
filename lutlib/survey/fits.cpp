// The fitted lattices of a survey.
#include "lutlib/bake/budget.h"
#include "lutlib/fit/fit.h"
#include "lutlib/survey/lattices.h"

#include <algorithm>
#include <map>
#include <set>

namespace lutlib {
namespace {

// 16 bits are so fine that plain rounding loses nothing.
constexpr int fine_bits = 16;

// Shapers are compared at a third of the way through the sizes, where a lattice's error still
// shows, and by the interpolation that most programs use.
int compared_size(const SurveySettings& settings) {
    return settings.sizes[settings.sizes.size() / 3];
}

// The mean error of each shaper's point samples.
std::map<const ShaperChoice*, double> errors_by_shaper(const SurveyReference& reference,
                                                       const std::vector<PointLattice>& lattices,
                                                       int size) {
    std::map<const ShaperChoice*, double> out;
    const Lookup& lookup = lookup_of(Interpolation::tetrahedral);
    for (const PointLattice& lattice : lattices) {
        if (lattice.lut.cube->size == size) {
            const auto stored =
                std::make_shared<const StoredLut>(lattice.lut, *lattice.nodes, storages().back());
            std::vector<double> errors(reference.inputs.size());
            reference.delta_e(reference.expected,
                              images_of(reference.reading(stored, lookup), reference.inputs),
                              errors);
            out[lattice.shaper] = error_stats(std::move(errors)).mean;
        }
    }
    return out;
}

// One lattice fitted for one interpolation: a candidate for each storage and each lookup that reads
// so. `unhelpful` counts those that kept their point samples.
std::vector<Candidate> fitted(const SurveyReference& reference, const PointLattice& lattice,
                              Interpolation how, std::size_t& unhelpful) {
    double start = now_seconds();
    const LatticeFit fit(reference.exact, reader_of(lattice.lut, how), *lattice.nodes);
    const FittedLattice exact = fit.exact();
    const double base_seconds = lattice.seconds + now_seconds() - start;
    std::vector<Candidate> out;
    for (const Storage& storage : storages()) {
        const bool coarse = storage.bits > 0 && storage.bits < fine_bits;
        start = now_seconds();
        const FittedLattice result = coarse ? fit.rounded({storage.bits}) : exact;
        const double seconds = base_seconds + now_seconds() - start;
        const auto nodes = std::make_shared<const std::vector<RgbD>>(result.nodes);
        for (const Lookup& lookup : lookups()) {
            if (lookup.weights != how) {
                continue;
            }
            if (!result.fitted) {
                ++unhelpful;
                continue;
            }
            out.push_back({&lattice,
                           {lattice.lut.cube->size, lattice.shaper, &storage, &lookup, true},
                           nodes,
                           seconds});
        }
    }
    return out;
}

} // namespace

FittedCandidates fitted_candidates(const SurveyReference& reference,
                                   const std::vector<PointLattice>& lattices,
                                   const SurveySettings& settings, const Progress& progress) {
    FittedCandidates out;
    const auto errors = errors_by_shaper(reference, lattices, compared_size(settings));
    const ShaperChoice* const none = &no_shaper();
    const double plain = errors.count(none) ? errors.at(none) : 0;
    std::set<const ShaperChoice*> worth{none};
    for (const auto& [shaper, error] : errors) {
        // The look's own is wanted whatever the others do.
        if (error < plain || shaper->recipe || shaper->name == "own") {
            worth.insert(shaper);
        } else if (shaper != none) {
            out.notes.push_back(std::string(shaper->label) +
                                ": point samples only, as it makes them worse than no shaper does");
        }
    }
    std::vector<const PointLattice*> chosen;
    bool any_large = false;
    for (const PointLattice& lattice : lattices) {
        const bool large = lattice.lut.cube->size > largest_fitted_size;
        any_large = any_large || large;
        if (!large && worth.count(lattice.shaper)) {
            chosen.push_back(&lattice);
        }
    }
    if (any_large) {
        out.notes.push_back(fit_limit_text());
    }
    std::size_t done = 0, unhelpful = 0;
    for (const PointLattice* const lattice : chosen) {
        for (const Interpolation how : {Interpolation::trilinear, Interpolation::tetrahedral}) {
            std::vector<Candidate> more = fitted(reference, *lattice, how, unhelpful);
            std::move(more.begin(), more.end(), std::back_inserter(out.rows));
        }
        progress(static_cast<double>(++done) / static_cast<double>(chosen.size()), "fitting");
    }
    if (unhelpful > 0) {
        out.notes.push_back("fitting did not help " + std::to_string(unhelpful) +
                            " combinations, which keep their point samples and are listed once");
    }
    return out;
}

} // namespace lutlib
