#include "lutlib/survey/lattices.h"

#include "lutlib/error.h"
#include "lutlib/metrics/samples.h"
#include "lutlib/recipe/bake_recipe.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

constexpr std::array<ShaperChoice, 5> shapers{{
    {.name = "none", .label = "no shaper", .bake_name = "none"},
    {.name = "srgb", .label = "sRGB shaper", .bake_name = "srgb"},
    {.name = "log", .label = "log shaper", .bake_name = "acescct"},
    {.name = "pq", .label = "PQ shaper", .bake_name = "pq"},
    {.name = "own", .label = "its own shaper", .bake_name = "base"},
}};
constexpr const ShaperChoice& own_shaper = shapers.back();
constexpr int shaper_entries = 1024;
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

// The shares are of all shapers and sizes.
class Sampler {
  public:
    Sampler(const SurveyReference& reference, const SurveySettings& settings,
            const Progress& progress)
        : reference_(reference), sizes_(settings.sizes), progress_(progress) {}

    void add(const ShaperChoice& shaper) {
        Recipe recipe = reference_.recipe;
        recipe.bake.domain.reset();
        if (&shaper != &own_shaper) { // which has a domain of its own
            recipe.bake.domain = reference_.domain;
        }
        recipe.bake.shaper = shaper.bake_name;
        recipe.bake.shaper_size = shaper_entries;
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
            out.rows.push_back({&shaper, std::move(lut), std::move(nodes), seconds});
            progress_(static_cast<double>(out.rows.size()) /
                          static_cast<double>(shapers.size() * sizes_.size()),
                      "sampling");
        }
    }

    PointLattices out;

  private:
    const SurveyReference& reference_;
    const std::vector<int>& sizes_;
    const Progress& progress_;
};

} // namespace

const ShaperChoice& no_shaper() {
    return shapers.front();
}

SurveyReference::SurveyReference(const Recipe& look, const SurveySettings& settings)
    : recipe(look), exact(Transform::of(look)),
      domain(look.bake.domain.value_or(look.base_lut ? look.base_lut->domain() : Domain{})),
      inputs(over_domain(
          sample_colors(2, {.neutral = 1024, .random = settings.colours, .lattice = false}),
          domain)),
      expected(images_of(exact, inputs)) {
    held = std::all_of(expected.begin(), expected.end(), [](RgbD c) { return saturate(c) == c; });
}

Difference SurveyReference::error_of(const StoredLut& stored, const Lookup& lookup) const {
    std::vector<Rgb> results(inputs.size());
    stored.apply(inputs, results, lookup);
    std::vector<RgbD> got(results.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
        got[i] = to_double(held ? saturate(results[i]) : results[i]);
    }
    return difference_of(inputs, expected, got, recipe.output_encoding());
}

PointLattices point_lattices(const SurveyReference& reference, const SurveySettings& settings,
                             const Progress& progress) {
    Sampler sampler(reference, settings, progress);
    const auto& base = reference.recipe.base_lut;
    for (const ShaperChoice& shaper : shapers) {
        if (&shaper == &own_shaper && !(base && base->shaper)) {
            continue;
        }
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
