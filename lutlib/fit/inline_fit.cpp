#include "lutlib/fit/inline_fit.h"

#include "lutlib/fit/curves_fit.h"
#include "lutlib/metrics/breaks.h"
#include "lutlib/metrics/error_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace lutlib {
namespace {

constexpr std::array<int, 7> curve_lengths{2, 5, 9, 17, 33, 65, 257};
constexpr std::array<int, 11> lattice_sizes{2, 3, 4, 5, 6, 7, 8, 9, 11, 13, 17};
constexpr int mixing_entries = 33;
static_assert(curve_lengths.back() == most_inline_entries &&
              lattice_sizes.back() == most_inline_nodes);

// What to try, in order of numbers; curves with a matrix take as many as 6 nodes per axis.
std::vector<std::function<std::vector<InlineLook>()>>
forms_to_try(const Transform& look, const Domain& domain, const LookEncodings& encodings,
             const std::optional<ShapedTable>& shaped) {
    std::vector<std::function<std::vector<InlineLook>()>> out;
    const int own_size = shaped ? shaped->table.cube->size : 0;
    std::vector<int> sizes(lattice_sizes.begin(), lattice_sizes.end());
    std::erase_if(sizes, [own_size](int size) { return size >= own_size; });
    if (own_size > 0 && own_size <= most_inline_nodes) {
        sizes.push_back(own_size);
    }
    for (const int size : sizes) {
        out.push_back([shaped, size] {
            return std::vector<InlineLook>{
                inline_shaped(shaped->table, shaped->how, size, most_inline_entries)};
        });
    }
    if (keeps_channels_apart(look, domain)) {
        for (const int entries : curve_lengths) {
            out.push_back([&look, domain, entries] {
                return std::vector<InlineLook>{sampled_curves(look, domain, entries)};
            });
        }
        return out;
    }
    bool has_curves = false;
    for (const int size : lattice_sizes) {
        if (size > 5 && !has_curves) {
            has_curves = true;
            out.push_back([&look, domain, encodings] {
                const auto found = fit_curves(look, domain, encodings, mixing_entries);
                return std::vector<InlineLook>(found.begin(), found.end());
            });
        }
        out.push_back([&look, domain, size] {
            return std::vector<InlineLook>{inline_lattice(look, domain, size)};
        });
    }
    return out;
}

std::vector<double> places_of(double low, double high, std::size_t count) {
    std::vector<double> out;
    for (std::size_t i = 0; i < count; ++i) {
        out.push_back(
            std::lerp(low, high, static_cast<double>(i) / static_cast<double>(count - 1)));
    }
    return out;
}

Breaks breaks_of_form(const InlineLook& look) {
    Breaks out;
    if (const auto* const lattice = std::get_if<InlineLattice>(&look)) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.at[c] = places_of(lattice->domain.min[c], lattice->domain.max[c],
                                  static_cast<std::size_t>(lattice->size));
        }
        return out;
    }
    if (const auto* const shaped = std::get_if<InlineShaped>(&look)) {
        for (std::size_t c = 0; c < 3; ++c) {
            const InlineCurve& curve = shaped->shaper[c];
            out.at[c] = places_of(curve.low, curve.high, curve.entries.size());
        }
        out.all = false; // those of the lattice lie anywhere
        return out;
    }
    const auto& curves = std::get<InlineCurves>(look);
    for (std::size_t c = 0; c < 3; ++c) {
        const InlineCurve& first = curves.mixes ? curves.before[c] : curves.after[c];
        out.at[c] = places_of(first.low, first.high, first.entries.size());
    }
    out.all = !curves.mixes; // those of the curves behind the matrix lie anywhere
    return out;
}

struct TriedForm {
    InlineFit fit;
    bool is_measured = false; ///< else its error is that of a few colours
};

} // namespace

InlineSearch fit_inline(const Transform& look, const Domain& domain, const Breaks& breaks,
                        const LookEncodings& encodings, const Viewing& viewing, double max_delta_e,
                        const std::optional<ShapedTable>& shaped) {
    const std::vector<Rgb> few = even_samples(domain, 4000);
    const auto measured = [&](const InlineLook& form) {
        return measure(look, transform_of(form),
                       error_samples(domain, united(breaks, breaks_of_form(form))), viewing);
    };
    std::vector<TriedForm> tried;
    for (const auto& make : forms_to_try(look, domain, encodings, shaped)) {
        for (InlineLook& form : make()) {
            // A few colours show which forms are far off, at a hundredth of the cost.
            Difference error = compare(look, transform_of(form), few, viewing);
            const bool is_candidate = error.delta_e_2000.max <= max_delta_e;
            if (is_candidate) {
                error = measured(form);
            }
            if (error.delta_e_2000.max <= max_delta_e) {
                return {InlineFit{form, error}, {form, error}};
            }
            tried.push_back({{std::move(form), error}, is_candidate});
        }
    }
    // More colours only show larger errors: who errs less over a few may still be the closest.
    const auto errs_less = [](const TriedForm& a, const TriedForm& b) {
        return a.fit.error.delta_e_2000.max < b.fit.error.delta_e_2000.max;
    };
    for (;;) {
        TriedForm& closest = *std::min_element(tried.begin(), tried.end(), errs_less);
        if (closest.is_measured) {
            return {std::nullopt, closest.fit};
        }
        closest.fit.error = measured(closest.fit.look);
        closest.is_measured = true;
    }
}

} // namespace lutlib
