#include "lutlib/survey/stiff_survey.h"

#include "lutlib/fit/fit.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

namespace lutlib {
namespace {

constexpr std::array<int, 2> lattice_sizes{16, 33};
// Where cells are wide, so that what a fit can do shows.
constexpr int largest_fitted = 16;
constexpr int colours = 8192;

// Of the look's outputs: what an error is a share of.
double extent(const std::vector<RgbD>& outputs) {
    double low = INFINITY, high = -INFINITY, largest = 0;
    for (const RgbD& c : outputs) {
        for (std::size_t i = 0; i < 3; ++i) {
            low = std::min(low, c[i]);
            high = std::max(high, c[i]);
            largest = std::max(largest, std::abs(c[i]));
        }
    }
    return high > low ? high - low : largest > 0 ? largest : 1;
}

class StiffSurveyor {
  public:
    explicit StiffSurveyor(const StiffLook& look)
        : look_(look), source_(look.make()), inputs_(samples_over(source_.domain(), 2, colours)),
          expected_(images_of(Transform::of(source_, Interpolation::tetrahedral), inputs_)) {
        extent_ = extent(expected_);
        stiffness_ = look.stiffness / extent_;
    }

    std::vector<StiffRow> run() const {
        const Transform exact = Transform::of(source_, Interpolation::tetrahedral);
        std::vector<StiffRow> rows;
        for (const int size : lattice_sizes) {
            Lut lattice;
            lattice.cube = identity_cube(size, source_.domain());
            const std::vector<RgbD> nodes =
                point_samples(exact, reader_of(lattice, Interpolation::tetrahedral));
            for (const Lookup& lookup : lookups()) {
                rows.push_back(
                    {&look_, size, &lookup, false, stiffness_, error_of(lattice, nodes, lookup)});
            }
            if (size > largest_fitted) {
                continue;
            }
            for (const Interpolation how : {Interpolation::trilinear, Interpolation::tetrahedral}) {
                const FittedLattice fit = LatticeFit(exact, reader_of(lattice, how), nodes).exact();
                const auto lookup =
                    std::find_if(lookups().begin(), lookups().end(),
                                 [how](const Lookup& l) { return l.weights == how; });
                if (fit.fitted) {
                    rows.push_back({&look_, size, &*lookup, true, stiffness_,
                                    error_of(lattice, fit.nodes, *lookup)});
                }
            }
        }
        return rows;
    }

    std::size_t colour_count() const { return inputs_.size(); }

  private:
    ErrorStats error_of(const Lut& lattice, const std::vector<RgbD>& nodes,
                        const Lookup& lookup) const {
        const StoredLut stored(lattice, nodes, storages().back());
        std::vector<Rgb> got(inputs_.size());
        stored.apply(inputs_, got, lookup);
        std::vector<double> errors(got.size());
        for (std::size_t i = 0; i < got.size(); ++i) {
            errors[i] = largest_magnitude(to_double(got[i]) - expected_[i]) / extent_;
        }
        return error_stats(std::move(errors));
    }

    const StiffLook& look_;
    Lut source_;
    std::vector<Rgb> inputs_;
    std::vector<RgbD> expected_;
    double extent_ = 1, stiffness_ = 0;
};

} // namespace

StiffSurvey survey_stiff_suite(const Progress& progress) {
    const auto suite = stiff_suite();
    std::vector<std::vector<StiffRow>> rows(suite.size());
    std::size_t done = 0;
    StiffSurvey out;
    std::mutex one_at_a_time;
    tbb::parallel_for(std::size_t{0}, suite.size(), [&](std::size_t i) {
        const StiffSurveyor surveyor(suite[i]);
        rows[i] = surveyor.run();
        const std::lock_guard lock(one_at_a_time);
        out.colours = surveyor.colour_count();
        progress(static_cast<double>(++done) / static_cast<double>(suite.size()),
                 std::string(suite[i].name));
    });
    for (const auto& of_look : rows) {
        out.rows.insert(out.rows.end(), of_look.begin(), of_look.end());
    }
    return out;
}

} // namespace lutlib
