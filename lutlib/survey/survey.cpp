#include "lutlib/survey/survey.h"

#include "lutlib/bake/budget.h"
#include "lutlib/color/difference.h"
#include "lutlib/error.h"
#include "lutlib/fit/fit.h"
#include "lutlib/metrics/peak.h"
#include "lutlib/metrics/samples.h"
#include "lutlib/recipe/bake_recipe.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <set>

namespace lutlib {
namespace {

constexpr std::array<ShaperChoice, 5> shaper_table{{
    {"none", "no shaper", "none"},
    {"srgb", "sRGB shaper", "srgb"},
    {"log", "log shaper", "acescct"},
    {"pq", "PQ shaper", "pq"},
    {"own", "its own shaper", "base"},
}};
constexpr int shaper_entries = 1024;
// A shaper this near to a straight line, in code values, does nothing.
constexpr double straight = 1e-6;

// Where shares of the progress bar end.
constexpr double after_sampling = 0.1, after_timing = 0.3, after_fitting = 0.8;

bool is_straight(const Lut1D& shaper) {
    for (int i = 0; i < shaper.size(); ++i) {
        const double line = static_cast<double>(i) / (shaper.size() - 1);
        const Rgb& entry = shaper.entries[static_cast<std::size_t>(i)];
        for (std::size_t c = 0; c < 3; ++c) {
            if (std::abs(static_cast<double>(entry[c]) - line) > straight) {
                return false;
            }
        }
    }
    return true;
}

// A lattice before storage: its nodes by point sampling.
struct Filled {
    const ShaperChoice* shaper;
    Lut lut;
    std::shared_ptr<const std::vector<RgbD>> nodes;
    double seconds;
};

// What does not depend on the nodes' values.
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

class Surveyor {
  public:
    Surveyor(const Recipe& recipe, const SurveySettings& settings, const Progress& progress)
        : recipe_(recipe), progress_(progress), exact_(Transform::of(recipe)) {
        out_.settings = settings;
        domain_ =
            recipe.bake.domain.value_or(recipe.base_lut ? recipe.base_lut->domain() : Domain{});
        const auto over_domain = [&](std::vector<Rgb> colours) {
            for (Rgb& c : colours) {
                for (std::size_t i = 0; i < 3; ++i) {
                    c[i] = std::lerp(domain_.min[i], domain_.max[i], c[i]);
                }
            }
            return colours;
        };
        inputs_ = over_domain(
            sample_colors(2, {.neutral = 1024, .random = settings.colours, .lattice = false}));
        pixels_ = over_domain(
            sample_colors(2, {.neutral = 2, .random = settings.pixels, .lattice = false}));
        out_.colours = inputs_.size();
        expected_ = images_of(exact_, inputs_);
        held_ = std::all_of(expected_.begin(), expected_.end(),
                            [](RgbD c) { return saturate(c) == c; });
    }

    Survey run() {
        sample();
        time();
        fit();
        examine();
        settle();
        progress_(1, "done");
        return std::move(out_);
    }

  private:
    void note(const std::string& text) { out_.notes.push_back(text); }

    // Every lattice by point sampling; shapers that cannot be or do nothing go.
    void sample() {
        for (const ShaperChoice& shaper : shaper_table) {
            if (shaper.name == "own" && !(recipe_.base_lut && recipe_.base_lut->shaper)) {
                continue;
            }
            try {
                sample_with(shaper);
            } catch (const Error& error) {
                note(std::string(shaper.label) + " left out: " + error.message());
            }
        }
    }

    void sample_with(const ShaperChoice& shaper) {
        Recipe recipe = recipe_;
        recipe.bake.domain.reset();
        if (shaper.name != "own") { // which has a domain of its own
            recipe.bake.domain = domain_;
        }
        recipe.bake.shaper = shaper.bake_name;
        recipe.bake.shaper_size = shaper_entries;
        for (const int size : out_.settings.sizes) {
            recipe.bake.size = size;
            const double start = now_seconds();
            Lut lut = bake_recipe(recipe);
            const double seconds = now_seconds() - start;
            if (lut.shaper && shaper.name != "own" && is_straight(*lut.shaper)) {
                note(std::string(shaper.label) + " left out: it is linear on this input");
                return;
            }
            auto nodes = std::make_shared<std::vector<RgbD>>(lut.cube->nodes.size());
            std::transform(lut.cube->nodes.begin(), lut.cube->nodes.end(), nodes->begin(),
                           [](Rgb c) { return to_double(c); });
            filled_.push_back({&shaper, std::move(lut), std::move(nodes), seconds});
            progress_(after_sampling * static_cast<double>(filled_.size()) /
                          static_cast<double>(shaper_table.size() * out_.settings.sizes.size()),
                      "sampling");
        }
    }

    void time() {
        std::vector<Rgb> results(pixels_.size());
        std::size_t done = 0;
        for (const Filled& filled : filled_) {
            for (const Storage& storage : storages()) {
                const StoredLut stored(filled.lut, *filled.nodes, storage);
                for (const Lookup& lookup : lookups()) {
                    const TimingKey key = timing_key(filled.lut, storage, lookup);
                    if (timings_.count(key)) {
                        continue;
                    }
                    Timing t = measure([&] { stored.apply(pixels_, results, lookup); },
                                       out_.settings.repetitions);
                    const auto count = static_cast<double>(pixels_.size());
                    t.median /= count;
                    t.lower_quartile /= count;
                    t.upper_quartile /= count;
                    timings_[key] = t;
                }
            }
            progress_(std::lerp(after_sampling, after_timing,
                                static_cast<double>(++done) / static_cast<double>(filled_.size())),
                      "timing");
        }
    }

    void add(const Filled& filled, const Storage& storage, const Lookup& lookup,
             std::shared_ptr<const std::vector<RgbD>> nodes, double seconds, bool fitted) {
        SurveyRow row;
        row.what = {filled.lut.cube->size, filled.shaper, &storage, &lookup, fitted};
        row.bake_seconds = seconds;
        row.pixel = timings_.at(timing_key(filled.lut, storage, lookup));
        out_.rows.push_back(row);
        work_.push_back({&filled, std::move(nodes)});
    }

    // Fits for a shaper that makes point samples worse than none are not worth their time.
    bool worth_fitting(const Filled& filled) const {
        return filled.lut.cube->size <= largest_fitted_size &&
               (filled.shaper->name == "none" || helpful_.count(filled.shaper));
    }

    void find_helpful_shapers() {
        std::map<const ShaperChoice*, double> mean;
        const Storage& finest = storages().back();
        for (const Filled& filled : filled_) {
            if (filled.lut.cube->size != out_.settings.sizes[out_.settings.sizes.size() / 3]) {
                continue;
            }
            const StoredLut stored(filled.lut, *filled.nodes, finest);
            mean[filled.shaper] = error_of(stored, lookups()[2]).delta_e_2000.mean;
        }
        for (const auto& [shaper, error] : mean) {
            if (error < mean[&shaper_table[0]]) {
                helpful_[shaper] = true;
            } else if (shaper != &shaper_table[0]) {
                note(std::string(shaper->label) +
                     ": point samples only, as it makes them worse than no shaper does");
            }
        }
    }

    void fit() {
        for (const Filled& filled : filled_) {
            for (const Storage& storage : storages()) {
                for (const Lookup& lookup : lookups()) {
                    add(filled, storage, lookup, filled.nodes, filled.seconds, false);
                }
            }
        }
        find_helpful_shapers();
        const auto worth = [this](const Filled& f) { return worth_fitting(f); };
        const auto total = std::count_if(filled_.begin(), filled_.end(), worth);
        const bool any_large = std::any_of(filled_.begin(), filled_.end(), [](const Filled& f) {
            return f.lut.cube->size > largest_fitted_size;
        });
        if (any_large) {
            note(fit_limit_text());
        }
        std::ptrdiff_t done = 0;
        for (const Filled& filled : filled_) {
            if (!worth(filled)) {
                continue;
            }
            for (const Interpolation how : {Interpolation::trilinear, Interpolation::tetrahedral}) {
                fit_one(filled, how);
            }
            ++done;
            progress_(std::lerp(after_timing, after_fitting,
                                static_cast<double>(done) / static_cast<double>(total)),
                      "fitting");
        }
        if (unhelpful_ > 0) {
            note("fitting did not help " + std::to_string(unhelpful_) +
                 " combinations, which keep their point samples and are listed once");
        }
    }

    void fit_one(const Filled& filled, Interpolation how) {
        double start = now_seconds();
        const LatticeFit fit(exact_, reader_of(filled.lut, how), *filled.nodes);
        const FittedLattice exact = fit.exact();
        const double base_seconds = filled.seconds + now_seconds() - start;
        for (const Storage& storage : storages()) {
            // 16 bits are so fine that plain rounding loses nothing.
            const bool coarse = storage.bits > 0 && storage.bits < 16;
            start = now_seconds();
            const FittedLattice result = coarse ? fit.rounded({storage.bits}) : exact;
            const double seconds = base_seconds + now_seconds() - start;
            const auto nodes = std::make_shared<const std::vector<RgbD>>(result.nodes);
            for (const Lookup& lookup : lookups()) {
                if (lookup.weights != how) {
                    continue;
                }
                if (result.fitted) {
                    add(filled, storage, lookup, nodes, seconds, true);
                } else {
                    ++unhelpful_;
                }
            }
        }
    }

    Difference error_of(const StoredLut& stored, const Lookup& lookup) const {
        std::vector<Rgb> results(inputs_.size());
        stored.apply(inputs_, results, lookup);
        std::vector<RgbD> got(results.size());
        for (std::size_t i = 0; i < got.size(); ++i) {
            got[i] = to_double(held_ ? saturate(results[i]) : results[i]);
        }
        return difference_of(inputs_, expected_, got, recipe_.output_encoding());
    }

    void examine() {
        std::atomic<std::size_t> done = 0;
        std::mutex one_at_a_time;
        tbb::parallel_for(std::size_t{0}, out_.rows.size(), [&](std::size_t i) {
            SurveyRow& row = out_.rows[i];
            const StoredLut stored(work_[i].filled->lut, *work_[i].nodes, *row.what.storage);
            row.bytes = stored.bytes();
            row.error = error_of(stored, *row.what.lookup);
            ++done;
            const std::unique_lock lock(one_at_a_time, std::try_to_lock);
            if (lock) {
                progress_(
                    std::lerp(after_fitting, 1.0,
                              static_cast<double>(done) / static_cast<double>(out_.rows.size())),
                    "measuring errors");
            }
        });
    }

    // Recommends, looks closer at what is recommended, and again until that holds.
    void settle() {
        SampleCounts counts{.neutral = 997, .random = 20000, .lattice = false};
        counts.skipped = out_.settings.colours;
        std::vector<Rgb> others = sample_colors(2, counts);
        for (Rgb& c : others) {
            for (std::size_t i = 0; i < 3; ++i) {
                c[i] = std::lerp(domain_.min[i], domain_.max[i], c[i]);
            }
        }
        out_.checked = others.size();
        std::set<std::size_t> seen;
        const auto holds = [&](std::size_t i) {
            double& largest = out_.rows[i].error.delta_e_2000.max;
            if (seen.insert(i).second) {
                largest = std::max(largest, peak(i, others));
            }
            return largest <= out_.settings.promise;
        };
        do {
            out_.recommendation = recommend(out_.rows, out_.settings.promise);
        } while (out_.recommendation.kept &&
                 !(holds(out_.recommendation.row) && holds(out_.recommendation.fastest)));
    }

    double peak(std::size_t index, const std::vector<Rgb>& colours) const {
        const Combination& what = out_.rows[index].what;
        const StoredLut stored(work_[index].filled->lut, *work_[index].nodes, *what.storage);
        const Encoding& output = recipe_.output_encoding();
        const Matrix3 to_rec709 = rgb_to_rgb(output.primaries, rec709);
        const auto lab = [&](RgbD c) {
            return lab_from_linear(
                to_rec709 * RgbD{output.decode(c.r), output.decode(c.g), output.decode(c.b)});
        };
        return peak_error(colours, domain_, 1.0F / static_cast<float>(what.size - 1), [&](Rgb in) {
            Rgb got;
            stored.apply({&in, 1}, {&got, 1}, *what.lookup);
            return delta_e_2000(lab(to_double(held_ ? saturate(got) : got)),
                                lab(exact_(to_double(in))));
        });
    }

    struct Work {
        const Filled* filled;
        std::shared_ptr<const std::vector<RgbD>> nodes;
    };

    const Recipe& recipe_;
    const Progress& progress_;
    Transform exact_;
    Domain domain_;
    std::vector<Rgb> inputs_, pixels_;
    std::vector<RgbD> expected_;
    bool held_ = false;
    std::vector<Filled> filled_;
    std::map<TimingKey, Timing> timings_;
    std::map<const ShaperChoice*, bool> helpful_;
    std::size_t unhelpful_ = 0;
    std::vector<Work> work_;
    Survey out_;
};

} // namespace

std::string to_text(const Combination& c) {
    std::string out = std::to_string(c.size) + " nodes, ";
    if (c.shaper->name != "none") {
        out += std::string(c.shaper->label) + ", ";
    }
    out += std::string(c.storage->label) + ", " + std::string(c.lookup->label);
    return out + (c.fitted ? ", fitted" : "");
}

Survey survey(const Recipe& recipe, const SurveySettings& settings, const Progress& progress) {
    return Surveyor(recipe, settings, progress).run();
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
