#include "lutlib/survey/survey.h"

#include "lutlib/color/difference.h"
#include "lutlib/metrics/peak.h"
#include "lutlib/metrics/samples.h"
#include "lutlib/survey/lattices.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <set>

namespace lutlib {
namespace {

// Where shares of the progress bar end.
constexpr double after_sampling = 0.1, after_timing = 0.3, after_fitting = 0.8;

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

// Seconds a pixel of every lattice in every storage by every lookup.
Timings timings_of(const std::vector<PointLattice>& lattices, const Domain& domain,
                   const SurveySettings& settings, const Progress& progress) {
    const std::vector<Rgb> pixels = over_domain(
        sample_colors(2, {.neutral = 2, .random = settings.pixels, .lattice = false}), domain);
    std::vector<Rgb> results(pixels.size());
    const auto timed = [&](const StoredLut& stored, const Lookup& lookup) {
        Timing t = measure([&] { stored.apply(pixels, results, lookup); }, settings.repetitions);
        const auto count = static_cast<double>(pixels.size());
        t.median /= count;
        t.lower_quartile /= count;
        t.upper_quartile /= count;
        return t;
    };
    Timings out;
    std::size_t done = 0;
    for (const PointLattice& lattice : lattices) {
        for (const Storage& storage : storages()) {
            const StoredLut stored(lattice.lut, *lattice.nodes, storage);
            for (const Lookup& lookup : lookups()) {
                const TimingKey key = timing_key(lattice.lut, storage, lookup);
                if (!out.count(key)) {
                    out[key] = timed(stored, lookup);
                }
            }
        }
        progress(static_cast<double>(++done) / static_cast<double>(lattices.size()), "timing");
    }
    return out;
}

std::vector<SurveyRow> measured(const SurveyReference& reference,
                                const std::vector<Candidate>& candidates, const Timings& timings,
                                const Progress& progress) {
    std::vector<SurveyRow> rows(candidates.size());
    std::atomic<std::size_t> done = 0;
    std::mutex one_at_a_time;
    tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t i) {
        const Candidate& c = candidates[i];
        const StoredLut stored(c.lattice->lut, *c.nodes, *c.what.storage);
        rows[i] = {c.what, reference.error_of(stored, *c.what.lookup), stored.bytes(), c.seconds,
                   timings.at(timing_key(c.lattice->lut, *c.what.storage, *c.what.lookup))};
        ++done;
        const std::unique_lock lock(one_at_a_time, std::try_to_lock);
        if (lock) {
            progress(static_cast<double>(done) / static_cast<double>(rows.size()),
                     "measuring errors");
        }
    });
    return rows;
}

// The largest dE2000 of a candidate, uphill from the worst of the colours.
double peak(const SurveyReference& reference, const Candidate& candidate,
            const std::vector<Rgb>& colours) {
    const Combination& what = candidate.what;
    const StoredLut stored(candidate.lattice->lut, *candidate.nodes, *what.storage);
    const Encoding output = reference.recipe.output_encoding();
    const Matrix3 to_rec709 = rgb_to_rgb(output.primaries(), rec709);
    const auto lab = [&](RgbD c) {
        return lab_from_linear(to_rec709 *
                               RgbD{output.decode(c.r), output.decode(c.g), output.decode(c.b)});
    };
    return peak_error(colours, reference.domain, 1.0F / static_cast<float>(what.size - 1),
                      [&](Rgb in) {
                          Rgb got;
                          stored.apply({&in, 1}, {&got, 1}, *what.lookup);
                          return delta_e_2000(lab(to_double(reference.held ? saturate(got) : got)),
                                              lab(reference.exact(to_double(in))));
                      });
}

struct Settled {
    Recommendation recommendation;
    std::size_t checked = 0;
};

// Recommends, looks closer at what is recommended, and again until that holds. Rows that were
// looked at closer get the larger error.
Settled settled(const SurveyReference& reference, const std::vector<Candidate>& candidates,
                const SurveySettings& settings, std::vector<SurveyRow>& rows) {
    const std::vector<Rgb> others = over_domain(
        sample_colors(
            2, {.neutral = 997, .random = 20000, .lattice = false, .skipped = settings.colours}),
        reference.domain);
    std::set<std::size_t> seen;
    const auto holds = [&](std::size_t i) {
        double& largest = rows[i].error.delta_e_2000.max;
        if (seen.insert(i).second) {
            largest = std::max(largest, peak(reference, candidates[i], others));
        }
        return largest <= settings.promise;
    };
    Settled out{{}, others.size()};
    do {
        out.recommendation = recommend(rows, settings.promise);
    } while (out.recommendation.kept &&
             !(holds(out.recommendation.row) && holds(out.recommendation.fastest)));
    return out;
}

template <class T>
void append(std::vector<T>& out, std::vector<T> more) {
    std::move(more.begin(), more.end(), std::back_inserter(out));
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

Survey survey(const Recipe& recipe, const SurveySettings& settings, const Progress& progress) {
    const auto from_to = [&](double from, double to) -> Progress {
        return [&progress, from, to](double share, const std::string& doing) {
            progress(std::lerp(from, to, share), doing);
        };
    };
    const SurveyReference reference(recipe, settings);
    const PointLattices lattices = point_lattices(reference, settings, from_to(0, after_sampling));
    const Timings timings = timings_of(lattices.rows, reference.domain, settings,
                                       from_to(after_sampling, after_timing));
    std::vector<Candidate> candidates = point_candidates(lattices.rows);
    FittedCandidates fits =
        fitted_candidates(reference, lattices.rows, settings, from_to(after_timing, after_fitting));
    append(candidates, std::move(fits.rows));

    Survey out;
    out.settings = settings;
    out.colours = reference.inputs.size();
    out.notes = lattices.notes;
    append(out.notes, std::move(fits.notes));
    out.rows = measured(reference, candidates, timings, from_to(after_fitting, 1));
    const Settled result = settled(reference, candidates, settings, out.rows);
    out.recommendation = result.recommendation;
    out.checked = result.checked;
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
