#include "lutlib/survey/lattices.h"

#include "lutlib/error.h"
#include "lutlib/interpolation/lattice_reader.h"
#include "lutlib/named.h"
#include "lutlib/recipe/bake_recipe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <string>

namespace lutlib {
namespace {

constexpr std::array<ShaperChoice, 5> usual_shapers{{
    {.name = "none", .label = "no shaper", .bake_name = "none"},
    {.name = "srgb", .label = "sRGB shaper", .bake_name = "srgb"},
    {.name = "log", .label = "log shaper", .bake_name = "acescct"},
    {.name = "pq", .label = "PQ shaper", .bake_name = "pq"},
    {.name = "own", .label = "its own shaper", .bake_name = "base"},
}};
constexpr const ShaperChoice& own_shaper = usual_shapers.back();
constexpr int usual_entries = 1024;
// A shaper this near to a straight line, in code values, does nothing.
constexpr double straight = 1e-6;

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

// Every name that a recipe may bake with and that is not among the usual ones, in a table of its
// own since rows are known by their addresses.
const ShaperChoice* recipe_shaper(std::string_view name) {
    static const std::vector<ShaperChoice> rows = [] {
        static std::deque<std::string> labels;
        std::vector<ShaperChoice> out;
        for (const std::string_view each : recipe_shaper_names()) {
            out.push_back({.name = each,
                           .label = labels.emplace_back(std::string(each) + " shaper"),
                           .bake_name = each,
                           .recipe = true});
        }
        return out;
    }();
    return find_named(rows, name);
}

// The usual ones, the look's own where it has one, and the recipe's where that is another.
std::vector<const ShaperChoice*> shapers_for(const Recipe& recipe) {
    std::vector<const ShaperChoice*> out;
    bool usual = recipe.bake.shaper.empty();
    for (const ShaperChoice& shaper : usual_shapers) {
        if (&shaper != &own_shaper || (recipe.base_lut && recipe.base_lut->shaper)) {
            out.push_back(&shaper);
        }
        usual = usual || shaper.bake_name == recipe.bake.shaper;
    }
    if (const ShaperChoice* const own = usual ? nullptr : recipe_shaper(recipe.bake.shaper)) {
        out.push_back(own);
    }
    return out;
}

// Operators may bend anywhere.
Breaks breaks_of(const Recipe& recipe) {
    if (!recipe.base_lut) {
        return no_breaks();
    }
    Breaks out = breaks_of(*recipe.base_lut);
    out.all = out.all && recipe.operations.empty();
    return out;
}

// The shares are of all shapers and sizes.
class Sampler {
  public:
    Sampler(const SurveyReference& reference, const SurveySettings& settings, std::size_t shapers,
            const Progress& progress)
        : reference_(reference), sizes_(settings.sizes), samples_(settings.samples),
          shapers_(shapers), progress_(progress) {}

    void add(const ShaperChoice& shaper) {
        Recipe recipe = reference_.recipe;
        recipe.bake.domain.reset();
        if (&shaper != &own_shaper) { // which has a domain of its own
            recipe.bake.domain = reference_.domain;
        }
        recipe.bake.shaper = shaper.bake_name;
        if (!shaper.recipe) {
            recipe.bake.shaper_size = usual_entries;
        }
        for (const int size : sizes_) {
            recipe.bake.size = size;
            const double start = now_seconds();
            Lut lut = bake_recipe(recipe);
            const double seconds = now_seconds() - start;
            if (lut.shaper && &shaper != &own_shaper && is_straight(*lut.shaper)) {
                out.notes.push_back(std::string(shaper.label) +
                                    " left out: it is linear on this input");
                return;
            }
            auto nodes = std::make_shared<std::vector<RgbD>>(lut.cube->nodes.size());
            std::transform(lut.cube->nodes.begin(), lut.cube->nodes.end(), nodes->begin(),
                           [](Rgb c) { return to_double(c); });
            auto samples = std::make_shared<LatticeSamples>();
            samples->at = error_samples(
                reference_.domain,
                united(reference_.breaks, breaks_of(reader_of(lut, Interpolation::tetrahedral))),
                samples_);
            samples->expected = images_of(reference_.shown, samples->at.hiding);
            out.rows.push_back(
                {&shaper, std::move(lut), std::move(nodes), seconds, std::move(samples)});
            progress_(static_cast<double>(out.rows.size()) /
                          static_cast<double>(shapers_ * sizes_.size()),
                      "sampling");
        }
    }

    PointLattices out;

  private:
    const SurveyReference& reference_;
    const std::vector<int>& sizes_;
    const SampleLimits& samples_;
    const std::size_t shapers_;
    const Progress& progress_;
};

} // namespace

const ShaperChoice& no_shaper() {
    return usual_shapers.front();
}

SurveyReference::SurveyReference(const Recipe& look, const SurveySettings& settings)
    : recipe(look), exact(Transform::of(look)),
      domain(look.bake.domain.value_or(look.base_lut ? look.base_lut->domain() : Domain{})),
      viewing(look.output_encoding()), breaks(breaks_of(look)),
      inputs(even_samples(domain, settings.samples.even)), expected(images_of(exact, inputs)) {
    const bool display = is_for_displays(recipe.output_encoding());
    outside = display ? outside_display(expected) : OutsideDisplay{};
    clamped = display && !settings.unclamped;
    shown =
        clamped ? in_sequence({exact, Transform::each([](RgbD c) { return saturate(c); })}) : exact;
    for (RgbD& c : expected) {
        c = seen(c);
    }
}

void SurveyReference::delta_e(std::span<const RgbD> a, std::span<const RgbD> b,
                              std::span<double> out) const {
    const Eye eye(viewing);
    eye(Metric::delta_e_2000, a, b, out);
}

Transform SurveyReference::reading(std::shared_ptr<const StoredLut> stored,
                                   const Lookup& lookup) const {
    return Transform::batch(
        [stored = std::move(stored), &lookup, held = clamped](std::span<RgbD> colors) {
            std::vector<Rgb> in(colors.size()), got(colors.size());
            std::transform(colors.begin(), colors.end(), in.begin(), to_float);
            stored->apply(in, got, lookup);
            std::transform(got.begin(), got.end(), colors.begin(),
                           [held](Rgb c) { return held ? saturate(to_double(c)) : to_double(c); });
        },
        Precision::float32);
}

PointLattices point_lattices(const SurveyReference& reference, const SurveySettings& settings,
                             const Progress& progress) {
    const std::vector<const ShaperChoice*> shapers = shapers_for(reference.recipe);
    Sampler sampler(reference, settings, shapers.size(), progress);
    for (const ShaperChoice* const each : shapers) {
        const ShaperChoice& shaper = *each;
        try {
            sampler.add(shaper);
        } catch (const Error& error) {
            sampler.out.notes.push_back(std::string(shaper.label) +
                                        " left out: " + error.message());
        }
    }
    return std::move(sampler.out);
}

std::vector<Candidate> point_candidates(const std::vector<PointLattice>& lattices) {
    std::vector<Candidate> out;
    for (const PointLattice& lattice : lattices) {
        for (const Storage& storage : storages()) {
            for (const Lookup& lookup : lookups()) {
                out.push_back({&lattice,
                               {lattice.lut.cube->size, lattice.shaper, &storage, &lookup, false},
                               lattice.nodes,
                               lattice.seconds});
            }
        }
    }
    return out;
}

} // namespace lutlib
