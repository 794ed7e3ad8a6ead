#include "lutlib/survey/survey.h"

#include "lutlib/metrics/samples.h"
#include "lutlib/resample/resample.h"
#include "lutlib/survey/detailer.h"
#include "lutlib/survey/lattices.h"
#include "lutlib/survey/precision.h"
#include "lutlib/survey/row_errors.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <iterator>
#include <map>
#include <mutex>
#include <set>

namespace lutlib {
namespace {

// Where shares of the progress bar end.
constexpr double after_sampling = 0.1, after_timing = 0.3, after_fitting = 0.8;

// Beyond it a survey would take minutes and gigabytes where seconds are expected.
constexpr int largest_own_size = 129;

// What a lookup's time depends on: not on the nodes' values.
struct TimingKey {
    int size;
    int shaper_size; // 0: none
    const Storage* storage;
    const Lookup* lookup;
    friend auto operator<=>(const TimingKey&, const TimingKey&) = default;
};

TimingKey timing_key(const Lut& lut, const Storage& storage, const Lookup& lookup) {
    return {lut.cube->size, lut.shaper ? lut.shaper->size() : 0, &storage, &lookup};
}

using Timings = std::map<TimingKey, Timing>;

// Seconds a pixel of every lattice in every storage by every lookup, all of them in each round.
Timings timings_of(const std::vector<PointLattice>& lattices, const Domain& domain,
                   const SurveySettings& settings, const Progress& progress) {
    const std::vector<Rgb> pixels = over_domain(
        sample_colors(2, {.neutral = 2, .random = settings.pixels, .lattice = false}), domain);
    std::vector<Rgb> results(pixels.size());
    std::deque<StoredLut> stored;
    std::vector<TimingKey> keys;
    std::vector<std::function<void()>> runs;
    std::set<TimingKey> seen;
    for (const PointLattice& lattice : lattices) {
        for (const Storage& storage : storages()) {
            if (!seen.insert(timing_key(lattice.lut, storage, lookups().front())).second) {
                continue;
            }
            const StoredLut& lut = stored.emplace_back(lattice.lut, *lattice.nodes, storage);
            for (const Lookup& lookup : lookups()) {
                keys.push_back(timing_key(lattice.lut, storage, lookup));
                runs.emplace_back(
                    [&pixels, &results, &lut, &lookup] { lut.apply(pixels, results, lookup); });
            }
        }
    }
    const std::vector<Timing> timings = measure_interleaved(
        runs, settings.rounds, [&](double share) { progress(share, "timing"); });
    Timings out;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        out[keys[i]] = timings[i].shared_by(pixels.size());
    }
    return out;
}

// The rows, and what else there is to say of each.
void measure_rows(const SurveyReference& reference, const std::vector<Candidate>& candidates,
                  const Timings& timings, const Progress& progress, Survey& out) {
    const Detailer detailer(reference);
    out.detail_colors = detailer.colors();
    std::vector<SurveyRow>& rows = out.rows;
    rows.resize(candidates.size());
    out.details.resize(candidates.size());
    std::atomic<std::size_t> done = 0;
    std::mutex one_at_a_time;
    tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t i) {
        const Candidate& c = candidates[i];
        const auto stored =
            std::make_shared<const StoredLut>(c.lattice->lut, *c.nodes, *c.what.storage);
        const Transform read = reference.reading(stored, *c.what.lookup);
        std::vector<double> errors;
        rows[i] = {c.what, row_errors(reference, read, *c.lattice->samples, errors),
                   stored->bytes(), c.seconds,
                   timings.at(timing_key(c.lattice->lut, *c.what.storage, *c.what.lookup))};
        out.details[i] = detailer.of(read, c.lattice->lut, *c.what.lookup,
                                     rows[i].error.worst_to_eye.in, std::move(errors));
        ++done;
        const std::unique_lock lock(one_at_a_time, std::try_to_lock);
        if (lock) {
            progress(static_cast<double>(done) / static_cast<double>(rows.size()),
                     "measuring errors");
        }
    });
}

// Recommends, climbs further from what is recommended, and again until that holds. Rows that were
// climbed further get the larger error.
Recommendation settled(const SurveyReference& reference, const std::vector<Candidate>& candidates,
                       const SurveySettings& settings, std::vector<SurveyRow>& rows) {
    std::set<std::size_t> seen;
    const auto holds = [&](std::size_t i) {
        if (seen.insert(i).second) {
            const Candidate& c = candidates[i];
            const Transform read = reference.reading(
                std::make_shared<const StoredLut>(c.lattice->lut, *c.nodes, *c.what.storage),
                *c.what.lookup);
            const Peak peak = largest_difference(reference.shown, read, c.lattice->samples->at,
                                                 reference.viewing, Metric::delta_e_2000);
            ErrorStats& stats = rows[i].error.delta_e_2000;
            if (peak.error > stats.max) {
                stats.max = peak.error;
                stats.at = peak.at;
            }
        }
        return rows[i].error.delta_e_2000.max <= settings.promise;
    };
    Recommendation out;
    do {
        out = recommend(rows, settings.promise);
    } while (out.kept && !(holds(out.row) && holds(out.fastest)));
    return out;
}

template <class T>
void append(std::vector<T>& out, std::vector<T> more) {
    std::move(more.begin(), more.end(), std::back_inserter(out));
}

// The size that the recipe bakes to, among those looked at.
void add_own_size(const Recipe& recipe, Survey& out) {
    const auto& base = recipe.base_lut;
    const int own =
        recipe.bake.size.value_or(base && base->cube ? base->cube->size : usual_cube_size);
    std::vector<int>& sizes = out.settings.sizes;
    const auto at = std::lower_bound(sizes.begin(), sizes.end(), own);
    if (at != sizes.end() && *at == own) {
        return;
    }
    if (own > largest_own_size) {
        out.notes.push_back("the " + std::to_string(own) +
                            " nodes that the recipe is baked to left out: name them with --sizes");
        return;
    }
    sizes.insert(at, own);
}

} // namespace

std::string to_text(const Combination& c) {
    std::string out = std::to_string(c.size) + " nodes, ";
    if (c.shaper != &no_shaper()) {
        out += std::string(c.shaper->label) + ", ";
    }
    out += std::string(c.storage->label) + ", " + std::string(c.lookup->label);
    return out + (c.fitted ? ", fitted" : "");
}

Survey survey(const Recipe& recipe, const SurveySettings& wanted, const Progress& progress) {
    const auto from_to = [&](double from, double to) -> Progress {
        return [&progress, from, to](double share, const std::string& doing) {
            progress(std::lerp(from, to, share), doing);
        };
    };
    Survey out;
    out.settings = wanted;
    if (wanted.own_size) {
        add_own_size(recipe, out);
    }
    const SurveySettings& settings = out.settings;
    const SurveyReference reference(recipe, settings);
    out.clamped = reference.clamped;
    out.outside = reference.outside;
    const PointLattices lattices = point_lattices(reference, settings, from_to(0, after_sampling));
    const Timings timings = timings_of(lattices.rows, reference.domain, settings,
                                       from_to(after_sampling, after_timing));
    std::vector<Candidate> candidates = point_candidates(lattices.rows);
    FittedCandidates fits =
        fitted_candidates(reference, lattices.rows, settings, from_to(after_timing, after_fitting));
    append(candidates, std::move(fits.rows));

    out.colors = reference.inputs.size();
    append(out.notes, lattices.notes);
    append(out.notes, std::move(fits.notes));
    measure_rows(reference, candidates, timings, from_to(after_fitting, 1), out);
    out.recommendation = settled(reference, candidates, settings, out.rows);
    out.strain = strain_of(reference);
    out.largest_seen = std::any_of(out.rows.begin(), out.rows.end(), [](const SurveyRow& row) {
        return row.error.delta_e_2000.largest_seen;
    });
    progress(1, "done");
    return out;
}

Recommendation recommend(const std::vector<SurveyRow>& rows, double max_delta_e) {
    Recommendation out;
    const auto smaller = [](const SurveyRow& a, const SurveyRow& b) {
        return a.bytes != b.bytes ? a.bytes < b.bytes : a.pixel.median < b.pixel.median;
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double error = rows[i].error.delta_e_2000.max;
        if (error <= max_delta_e) {
            const bool first = !out.kept;
            out.row = first || smaller(rows[i], rows[out.row]) ? i : out.row;
            out.fastest =
                first || rows[i].pixel.median < rows[out.fastest].pixel.median ? i : out.fastest;
            out.kept = true;
        } else if (!out.kept && error < rows[out.row].error.delta_e_2000.max) {
            out.row = out.fastest = i;
        }
    }
    return out;
}

} // namespace lutlib
