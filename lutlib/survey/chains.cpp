// Looks one after the other.
#include "lutlib/codes.h"
#include "lutlib/error.h"
#include "lutlib/half.h"
#include "lutlib/resample/invert.h"
#include "lutlib/resample/invert_index.h"
#include "lutlib/survey/precision.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

struct Between {
    const char* name;
    double (*round)(double);
};
template <int bits>
double as_code(double x) {
    return CodeDepth{bits}.rounded(x);
}
constexpr std::array<Between, 4> betweens{
    {{"8 bits", as_code<8>},
     {"16 bits", as_code<16>},
     {"half", [](double x) { return static_cast<double>(float_from_half(half_from(x))); }},
     {"float", [](double x) { return static_cast<double>(static_cast<float>(x)); }}}};
constexpr std::array<int, 4> lengths{1, 2, 4, 8};

Lut lattice_of(const Transform& look, const Domain& domain) {
    Lut out;
    out.cube = identity_cube(precision_size, domain);
    const std::vector<RgbD> nodes = images_of(look, out.cube->nodes);
    std::transform(nodes.begin(), nodes.end(), out.cube->nodes.begin(), to_float);
    return out;
}

Transform rounded(const Between& between) {
    return Transform::each([round = between.round](RgbD c) {
        return RgbD{round(c.r), round(c.g), round(c.b)};
    });
}

Transform repeated(const Transform& step, int times) {
    return in_sequence(std::vector<Transform>(static_cast<std::size_t>(times), step));
}

} // namespace

std::vector<ChainRow> chains_of(const SurveyReference& reference) {
    const Recipe& recipe = reference.recipe;
    if (recipe.output_encoding() != recipe.input || !reference.domain.is_unit()) {
        return {};
    }
    std::vector<ChainRow> out;
    const auto add = [&](const std::string& what, const std::string& between,
                         const std::vector<RgbD>& right, const Transform& chain) {
        std::vector<double> errors(reference.inputs.size());
        reference.delta_e(right, images_of(chain, reference.inputs), errors);
        out.push_back({what, between, error_stats(std::move(errors))});
    };
    const Lut lattice = lattice_of(reference.shown, reference.domain);
    const Transform read = Transform::of(lattice, Interpolation::tetrahedral);
    for (const int length : lengths) {
        const std::vector<RgbD> right =
            images_of(repeated(reference.shown, length), reference.inputs);
        for (const Between& between : betweens) {
            add(std::to_string(length) + (length > 1 ? " looks in turn" : " look"), between.name,
                right, repeated(in_sequence({read, rounded(between)}), length));
        }
        if (length == 2) {
            const Lut both = lattice_of(repeated(reference.shown, 2), reference.domain);
            add("2 looks as one lattice", "nothing", right,
                Transform::of(both, Interpolation::tetrahedral));
        }
    }
    // A look whose cells overlap so much has no inverse worth a minute's search.
    constexpr double most_work = 1e7; // cells looked at
    if (OutputIndex(*lattice.cube).cells_of_bucket() *
            static_cast<double>(lattice.cube->nodes.size()) >
        most_work) {
        return out;
    }
    try {
        const Lut back = invert(lattice).lut;
        std::vector<RgbD> in(reference.inputs.size());
        std::transform(reference.inputs.begin(), reference.inputs.end(), in.begin(), to_double);
        for (const Between& between : betweens) {
            add("look and inverse", between.name, in,
                in_sequence({read, rounded(between), Transform::of(back)}));
        }
    } catch (const Error&) {
        // Nor has a look that cannot be inverted such rows.
    }
    return out;
}

} // namespace lutlib
