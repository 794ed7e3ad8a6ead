#include "lutlib/survey/precision.h"

#include "lutlib/codes.h"
#include "lutlib/half.h"
#include "lutlib/named.h"
#include "lutlib/recipe/bake_recipe.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

using Rounding = double (*)(double);

double exactly(double x) {
    return x;
}
double as_float(double x) {
    return static_cast<double>(static_cast<float>(x));
}
double as_half(double x) {
    return static_cast<double>(float_from_half(half_from(x)));
}
template <int bits>
double as_code(double x) {
    return CodeDepth{bits}.rounded(x);
}

struct Kept {
    const char* name;
    Rounding round;
};
constexpr Kept kept_exactly{"double", exactly};
constexpr std::array<Kept, 6> storages_kept{{{"8 bits", as_code<8>},
                                             {"10 bits", as_code<10>},
                                             {"12 bits", as_code<12>},
                                             {"16 bits", as_code<16>},
                                             {"half", as_half},
                                             {"float", as_float}}};

struct Arithmetic {
    const char* name;
    Rounding round;
    int fraction_bits; // 0: as `round` leaves them
};
constexpr Arithmetic in_double{"double", exactly, 0};
constexpr Arithmetic in_float{"float", as_float, 0};
constexpr Arithmetic in_half{"half", as_half, 0};
constexpr Arithmetic in_texture_unit{"float, 8 fraction bits", as_float, 8};

struct Way {
    Kept storage;
    Arithmetic arithmetic;
};
std::vector<Way> ways() {
    std::vector<Way> out;
    for (const Kept& storage : storages_kept) {
        out.push_back({storage, in_double});
    }
    constexpr Kept half = row_named(storages_kept, "half"),
                   floats = row_named(storages_kept, "float"),
                   codes = row_named(storages_kept, "8 bits");
    out.insert(out.end(), {{floats, in_float},
                           {floats, in_texture_unit},
                           {half, in_half},
                           {codes, in_half},
                           {codes, in_texture_unit}});
    return out;
}

// One read of a lattice in which every operation is rounded.
class RoundedRead {
  public:
    RoundedRead(const std::vector<RgbD>& nodes, int size, const Way& way)
        : nodes_(nodes), size_(size), way_(way) {}

    RgbD operator()(Interpolation how, RgbD place) const {
        std::array<int, 3> base{};
        std::array<double, 3> fraction{};
        for (std::size_t c = 0; c < 3; ++c) {
            base[c] = std::min(static_cast<int>(place[c]), size_ - 2);
            fraction[c] = fraction_of(place[c] - base[c]);
        }
        return how == Interpolation::trilinear ? trilinear(base, fraction)
                                               : tetrahedral(base, fraction);
    }

  private:
    double round(double x) const { return way_.arithmetic.round(x); }
    double fraction_of(double x) const {
        const double steps = std::ldexp(1.0, way_.arithmetic.fraction_bits);
        return way_.arithmetic.fraction_bits ? std::round(x * steps) / steps : round(x);
    }
    double node(std::array<int, 3> at, std::size_t channel) const {
        const auto n = static_cast<std::size_t>(size_);
        const std::size_t i =
            static_cast<std::size_t>(at[0]) +
            n * (static_cast<std::size_t>(at[1]) + n * static_cast<std::size_t>(at[2]));
        return way_.storage.round(nodes_[i][channel]);
    }

    RgbD trilinear(const std::array<int, 3>& base, const std::array<double, 3>& t) const {
        RgbD out;
        const auto mixed = [&](double a, double b, double f) {
            return round(a + round(round(b - a) * f));
        };
        for (std::size_t c = 0; c < 3; ++c) {
            const auto row = [&](int g, int b) {
                return mixed(node({base[0], base[1] + g, base[2] + b}, c),
                             node({base[0] + 1, base[1] + g, base[2] + b}, c), t[0]);
            };
            out[c] =
                mixed(mixed(row(0, 0), row(1, 0), t[1]), mixed(row(0, 1), row(1, 1), t[1]), t[2]);
        }
        return out;
    }

    RgbD tetrahedral(std::array<int, 3> at, const std::array<double, 3>& t) const {
        const Walk& walk = axes_by_fraction(t);
        RgbD sum;
        const auto add = [&](double weight) {
            for (std::size_t c = 0; c < 3; ++c) {
                sum[c] = round(sum[c] + round(node(at, c) * weight));
            }
        };
        add(round(1 - t[walk[0]]));
        for (std::size_t step = 0; step < 3; ++step) {
            ++at[walk[step]];
            add(round(t[walk[step]] - (step < 2 ? t[walk[step + 1]] : 0)));
        }
        return sum;
    }

    const std::vector<RgbD>& nodes_;
    int size_;
    Way way_;
};

// Last places of a float, of the exact result.
double ulps(RgbD got, RgbD exact) {
    constexpr int bits = 23, least = -10;
    double most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const int exponent = exact[c] == 0 ? least : std::max(std::ilogb(exact[c]), least);
        most = std::max(most, std::abs(got[c] - exact[c]) / std::ldexp(1.0, exponent - bits));
    }
    return most;
}

} // namespace

std::vector<PrecisionRow> precision_of(const SurveyReference& reference) {
    Lut lattice;
    lattice.cube = identity_cube(precision_size, reference.domain);
    const LatticeReader reader = reader_of(lattice, Interpolation::trilinear);
    // Where displays take the codes, what no display shows is not lost by rounding.
    const std::vector<RgbD> nodes = images_of(reference.shown, lattice.cube->nodes);
    const std::size_t count = reference.inputs.size();
    std::vector<RgbD> place(count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            place[i][c] = reader.place(static_cast<double>(reference.inputs[i][c]), c);
        }
    }
    std::vector<PrecisionRow> out;
    for (const Interpolation how : {Interpolation::trilinear, Interpolation::tetrahedral}) {
        const auto results = [&](const Way& way) {
            const RoundedRead read(nodes, precision_size, way);
            std::vector<RgbD> got(count);
            tbb::parallel_for(std::size_t{0}, count,
                              [&](std::size_t i) { got[i] = reference.seen(read(how, place[i])); });
            return got;
        };
        const std::vector<RgbD> exact = results({kept_exactly, in_double});
        for (const Way& way : ways()) {
            const std::vector<RgbD> got = results(way);
            std::vector<double> ulp(count), delta_e(count);
            std::transform(got.begin(), got.end(), exact.begin(), ulp.begin(), ulps);
            reference.delta_e(exact, got, delta_e);
            out.push_back({way.storage.name, way.arithmetic.name, std::string(name_of(how)),
                           error_stats(std::move(ulp)), error_stats(std::move(delta_e))});
        }
    }
    return out;
}

} // namespace lutlib
