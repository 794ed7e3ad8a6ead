#include "lutlib/survey/detailer.h"

#include "lutlib/color/oklab.h"
#include "lutlib/color/swatches.h"
#include "lutlib/color/transfer.h"
#include "lutlib/interpolation/lattice_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lutlib {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int neutral_steps = 11;

// Colours that are named by shares of the domain or by light, as the look takes them.
class Place {
  public:
    Place(const Domain& domain, const Encoding& input) : domain_(domain), input_(input) {}

    std::optional<Rgb> of_share(RgbD share) const {
        if (saturate(share) != share) {
            return std::nullopt;
        }
        Rgb out;
        for (std::size_t c = 0; c < 3; ++c) {
            out[c] = static_cast<float>(std::lerp(static_cast<double>(domain_.min[c]),
                                                  static_cast<double>(domain_.max[c]), share[c]));
        }
        return out;
    }

    // Of linear Rec.709 light; none where its code lies outside the domain.
    std::optional<Rgb> of_light(RgbD linear) const {
        const RgbD code = code_of(linear);
        for (std::size_t c = 0; c < 3; ++c) {
            constexpr double rounding = 1e-6;
            if (code[c] < static_cast<double>(domain_.min[c]) - rounding ||
                code[c] > static_cast<double>(domain_.max[c]) + rounding) {
                return std::nullopt;
            }
        }
        return to_float(code);
    }

    RgbD code_of(RgbD linear) const {
        const RgbD light = rgb_to_rgb(rec709, input_.primaries()) * linear;
        return {input_.encode(light.r), input_.encode(light.g), input_.encode(light.b)};
    }

    RgbD srgb_of(Rgb in) const {
        const RgbD light{input_.decode(in.r), input_.decode(in.g), input_.decode(in.b)};
        const RgbD shown = rgb_to_rgb(input_.primaries(), rec709) * light;
        return {srgb_encode(shown.r), srgb_encode(shown.g), srgb_encode(shown.b)};
    }

  private:
    Domain domain_;
    Encoding input_;
};

// A plane by a function of its columns' and rows' middles, 0..1.
template <class F>
std::vector<std::optional<Rgb>> grid(F f) {
    std::vector<std::optional<Rgb>> out;
    for (int y = 0; y < plane_cells; ++y) {
        for (int x = 0; x < plane_cells; ++x) {
            out.push_back(f((x + 0.5) / plane_cells, (y + 0.5) / plane_cells));
        }
    }
    return out;
}

bool is_shown(RgbD linear) {
    constexpr double rounding = 1e-9;
    return largest_magnitude(linear - saturate(linear)) < rounding;
}

// Half way from grey to the end of sRGB's gamut, which depends on hue and lightness.
RgbD half_chroma(double dial, double lightness) {
    const double angle = oklab_hue(dial) * std::acos(-1.0) / 180;
    const auto at = [&](double chroma) {
        return linear_from_oklab({lightness, chroma * std::cos(angle), chroma * std::sin(angle)});
    };
    double low = 0, high = srgb_chroma;
    for (int i = 0; i < 30; ++i) {
        const double middle = (low + high) / 2;
        (is_shown(at(middle)) ? low : high) = middle;
    }
    return at(low / 2);
}

std::vector<DetailPlane> planes_of(const Place& place) {
    const auto across = [&](double x, double y) {
        // Two unit vectors at right angles to the neutral axis; the cube reaches 0.71 that way.
        constexpr double reach = 0.72;
        const double u = (2 * x - 1) * reach, v = (2 * y - 1) * reach;
        const double a = u / std::sqrt(2.0), b = v / std::sqrt(6.0);
        return place.of_share(RgbD{0.5 + a - b, 0.5 - a - b, 0.5 + 2 * b});
    };
    return {{"rg", "r = g", "red and green", "blue", grid([&](double x, double y) {
                 return place.of_share({x, x, y});
             })},
            {"neutral", "across the neutral axis", "green to red", "yellow to blue", grid(across)},
            {"hue", "hue against lightness", "hue 0..360 degrees, at half of the chroma",
             "lightness",
             grid([&](double x, double y) { return place.of_light(half_chroma(360 * x, y)); })}};
}

RgbD linear_of(const Swatch& swatch) {
    return {srgb_decode(swatch.srgb[0] / 255.0), srgb_decode(swatch.srgb[1] / 255.0),
            srgb_decode(swatch.srgb[2] / 255.0)};
}

std::vector<DetailPatch> patches_of(const Place& place) {
    std::vector<DetailPatch> out;
    const auto add = [&](const char* group, const Swatch& swatch) {
        if (const auto in = place.of_light(linear_of(swatch))) {
            out.push_back({group, std::string(swatch.name), *in, place.srgb_of(*in)});
        }
    };
    for (const Swatch& swatch : color_checker) {
        add("ColorChecker 24", swatch);
    }
    for (const Swatch& swatch : skin_tones) {
        add("Skin", swatch);
    }
    for (int i = 0; i < neutral_steps; ++i) {
        const double share = static_cast<double>(i) / (neutral_steps - 1);
        const Rgb in = *place.of_share({share, share, share});
        out.push_back(
            {"Neutrals, of the input", std::to_string(10 * i) + " %", in, place.srgb_of(in)});
    }
    return out;
}

double rounded(double value, int bits) {
    const double most = std::ldexp(1.0, bits) - 1;
    return std::round(value * most) / most;
}

RgbD rounded(RgbD value, int bits) {
    return {rounded(value.r, bits), rounded(value.g, bits), rounded(value.b, bits)};
}

// The share of the domain at a gradient's column.
double gradient_share(int column) {
    return static_cast<double>(column) / (gradient_columns - 1);
}

RgbD lerp_domain(const Domain& domain, double share) {
    RgbD out;
    for (std::size_t c = 0; c < 3; ++c) {
        out[c] = std::lerp(static_cast<double>(domain.min[c]), static_cast<double>(domain.max[c]),
                           share);
    }
    return out;
}

// A gradient of codes through a transform and into codes again, against the exact one, enlarged.
std::vector<RgbD> enlarged(const SurveyReference& reference, const Transform& read,
                           const std::vector<RgbD>& exact, int bits) {
    std::vector<RgbD> out;
    for (int i = 0; i < gradient_columns; ++i) {
        const RgbD in = lerp_domain(reference.domain, rounded(gradient_share(i), bits));
        const RgbD got = read(in);
        // Codes hold what a display shows, and no other range.
        const RgbD kept = reference.clamped ? rounded(got, bits) : got;
        out.push_back(RgbD{0.5, 0.5, 0.5} +
                      gradient_magnification * (kept - exact[static_cast<std::size_t>(i)]));
    }
    return out;
}

} // namespace

Detailer::Detailer(const SurveyReference& reference) : reference_(reference) {
    const Place place(reference.domain, reference.recipe.input);
    colors_.planes = planes_of(place);
    colors_.patches = patches_of(place);
    for (int i = 0; i < gradient_columns; ++i) {
        colors_.gradient.push_back(
            reference.shown(lerp_domain(reference.domain, gradient_share(i))));
    }
    for (std::size_t k = 0; k < gradient_bits.size(); ++k) {
        colors_.before[k] =
            enlarged(reference, reference.shown, colors_.gradient, gradient_bits[k]);
    }
    for (const DetailPlane& plane : colors_.planes) {
        for (const auto& in : plane.inputs) {
            all_.push_back(in.value_or(reference.domain.min));
        }
    }
    for (const DetailPatch& patch : colors_.patches) {
        all_.push_back(patch.in);
    }
    expected_ = images_of(reference.shown, all_);
}

std::vector<double> Detailer::errors_of(const Transform& read,
                                        const std::vector<Rgb>& inputs) const {
    std::vector<double> out(inputs.size());
    reference_.delta_e(images_of(reference_.shown, inputs), images_of(read, inputs), out);
    return out;
}

Details Detailer::of(const Transform& read, const Lut& lut, const Lookup& lookup, Rgb worst,
                     std::vector<double> errors) const {
    Details out;
    std::vector<double> found(all_.size());
    reference_.delta_e(expected_, images_of(read, all_), found);
    auto next = found.begin();
    for (const DetailPlane& plane : colors_.planes) {
        std::vector<double>& to = out.planes.emplace_back();
        for (const auto& in : plane.inputs) {
            to.push_back(in ? *next : nan);
            ++next;
        }
    }
    out.patches.assign(next, found.end());

    std::sort(errors.begin(), errors.end());
    for (std::size_t i = 0; i < detail_shares.size() && !errors.empty(); ++i) {
        const double rank = std::ceil(detail_shares[i] * static_cast<double>(errors.size()));
        out.shares[i] = errors[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
    }

    const LatticeReader reader = reader_of(lut, lookup.weights);
    out.worst = worst;
    out.worst_error = errors_of(read, {worst}).front();
    std::vector<Rgb> near;
    std::vector<bool> inside;
    std::array<std::array<double, near_cells>, 2> node{}, input{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double at = reader.place(static_cast<double>(worst[c]), c);
        out.worst_cell[c] = std::clamp(static_cast<int>(at), 0, reader.size - 2);
    }
    for (std::size_t c = 0; c < 2; ++c) {
        for (std::size_t i = 0; i < near_cells; ++i) {
            node[c][i] = out.worst_cell[c] - 1 + (static_cast<double>(i) + 0.5) / cell_parts;
            input[c][i] = reader.input_at(c, node[c][i]);
        }
    }
    const auto is_node = [&](double at) { return at >= 0 && at <= reader.size - 1; };
    for (std::size_t y = 0; y < near_cells; ++y) {
        for (std::size_t x = 0; x < near_cells; ++x) {
            inside.push_back(is_node(node[0][x]) && is_node(node[1][y]));
            near.push_back(inside.back()
                               ? to_float({input[0][x], input[1][y], static_cast<double>(worst.b)})
                               : worst);
        }
    }
    out.near_worst = errors_of(read, near);
    for (std::size_t i = 0; i < inside.size(); ++i) {
        if (!inside[i]) {
            out.near_worst[i] = nan;
        }
    }
    for (std::size_t k = 0; k < gradient_bits.size(); ++k) {
        out.after[k] = enlarged(reference_, read, colors_.gradient, gradient_bits[k]);
    }
    return out;
}

} // namespace lutlib
