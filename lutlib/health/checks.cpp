// The checks as a table: what a look's figures mean, in words.
#include "lutlib/health/health.h"
#include "lutlib/health/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace lutlib {
namespace {

// Limits of the verdict.
constexpr double fold_note = 0, fold_fault = 0.02;  // shares of the tetrahedra
constexpr double gain_warning = 8, gain_fault = 32; // an 8-bit code becomes as many
constexpr double condition_warning = 1e3;           // of all but one in a hundred
// Of a ramp's steps: dE2000 and dE-ITP of 1 are just noticeable (ITU-R BT.2124 for the latter).
constexpr double step_warning = 1, step_fault = 5;
constexpr double noise_warning = 4;
constexpr double error_warning = 2;                              // to the eye
constexpr double clipped_warning = 0.25, plateau_warning = 0.01; // shares of the cells
constexpr double invertible_note = 0.99;
using health::fall_fault, health::fall_warning;
const char* largest_name(const ErrorStats& stats) {
    return stats.largest_seen ? "largest seen" : "max";
}

constexpr std::array<const char*, 3> channels{"red", "green", "blue"};

template <class... Values>
std::string text(const char* format, Values... values) {
    std::array<char, 320> out{};
    std::snprintf(out.data(), out.size(), format, values...);
    return out.data();
}

Severity graded(double figure, double warning, double fault = INFINITY) {
    return figure > fault ? Severity::fault : figure > warning ? Severity::warning : Severity::good;
}

std::size_t largest_of(const std::array<Extreme, 3>& channels_of) {
    const auto at =
        std::max_element(channels_of.begin(), channels_of.end(),
                         [](const Extreme& a, const Extreme& b) { return a.value < b.value; });
    return static_cast<std::size_t>(at - channels_of.begin());
}

std::optional<Rgb> place(const Extreme& extreme) {
    return extreme.value > 0 ? std::optional<Rgb>(extreme.in) : std::nullopt;
}

Finding spikes(const Health& h) {
    if (h.spikes == 0) {
        return {Severity::good, 0, "no single node stands out of its neighbours", {}};
    }
    return {Severity::fault, static_cast<double>(h.spikes),
            text("%zu values of single nodes stand out of their neighbours, by %.3g at most; "
                 "--repair levels them",
                 h.spikes, h.largest_spike.value),
            h.largest_spike.in};
}

Finding non_finite(const Health& h) {
    if (h.non_finite == 0) {
        return {Severity::good, 0, "every value is a number", {}};
    }
    return {Severity::fault, static_cast<double>(h.non_finite),
            text("%zu of %zu values are NaN or infinite", h.non_finite, h.values),
            h.first_non_finite};
}

Finding range(const Health& h) {
    if (!(h.lowest.value <= h.highest.value)) {
        return {Severity::fault, 0, "no value is a number", {}};
    }
    const double beyond = std::max({0.0, -h.lowest.value, h.highest.value - 1});
    const std::string span = text("outputs run from %.6g to %.6g", h.lowest.value, h.highest.value);
    if (h.outside == 0) {
        return {Severity::good, 0, span, {}};
    }
    return {Severity::note, beyond,
            span + text("; %zu of %zu values lie outside 0..1, and integer codes clip them",
                        h.outside, h.values),
            -h.lowest.value > h.highest.value - 1 ? h.lowest.in : h.highest.in};
}

Finding folds(const Health& h) {
    const double folded = health::share(h.folded, h.tetrahedra);
    if (h.folded == 0) {
        return {h.mirrored ? Severity::note : Severity::good,
                0,
                h.mirrored ? "nothing folds over, but the cube is turned inside out: two channels "
                             "are swapped, or an odd number inverted"
                           : "no tetrahedron folds over",
                {}};
    }
    return {folded > fold_fault  ? Severity::fault
            : folded > fold_note ? Severity::warning
                                 : Severity::good,
            folded,
            text("%zu of %zu tetrahedra (%.3g %%) fold over: different inputs cross to one output",
                 h.folded, h.tetrahedra, 100 * folded),
            h.deepest_fold.in};
}

Finding table_falls(const Health& h) {
    const std::size_t c = largest_of(h.shaper_fall);
    const Extreme& most = h.shaper_fall[c];
    if (most.value <= 0) {
        return {Severity::good, 0, "the 1D table, if any, is monotonic", {}};
    }
    return {Severity::fault, most.value,
            text("the 1D table of %s is not monotonic: it falls by %.3g from one entry to the next",
                 channels[c], most.value),
            most.in};
}

// Steepness in codes that nobody looks at is how such looks are, from log to light say.
Severity for_shown(const Health& h, Severity severity) {
    return h.results == Results::scene ? std::min(severity, Severity::note) : severity;
}

Finding gain(const Health& h) {
    const Spread& spread = h.gain_spread;
    const Severity usual = graded(spread.p99, gain_warning, gain_fault);
    return {for_shown(h, std::max(usual, graded(h.gain.value, gain_fault))), spread.p99,
            text("the steepest direction gains %.4g at the median, %.4g at 99 %%, %.4g at most",
                 spread.p50, spread.p99, h.gain.value),
            place(h.gain)};
}

Finding condition(const Health& h) {
    if (h.flat == h.tetrahedra) {
        return {Severity::note, 0, "flat everywhere: there is no direction to compare", {}};
    }
    const Spread& spread = h.condition_spread;
    return {for_shown(h, graded(spread.p99, condition_warning)), spread.p99,
            text("the steepest direction gains %.3g times the flattest beside it at the median, "
                 "%.3g at 99 %%, %.3g at most",
                 spread.p50, spread.p99, h.condition.value),
            place(h.condition)};
}

Finding second_difference(const Health& h) {
    return {Severity::good, h.second_difference.value,
            text("neighbouring slopes differ by at most %.4g a node", h.second_difference.value),
            place(h.second_difference)};
}

Finding banding(const Health& h) {
    const std::string codes = text("%d bits: a neutral ramp steps by up to %.3g codes", h.ramp_bits,
                                   h.banding_neutral.value);
    if (h.results == Results::scene) {
        return {Severity::good, 0,
                codes + "; not judged, as results of light or log are not looked at",
                place(h.banding_neutral)};
    }
    const double most = h.banding_to_eye.value;
    return {graded(most, step_warning, step_fault), most,
            codes + text(", %s %.3g; %.3g is just noticeable",
                         h.results == Results::hdr ? "dE-ITP" : "dE2000", most, step_warning),
            place(h.banding_to_eye)};
}

Finding noise(const Health& h) {
    return {for_shown(h, graded(h.noise_gain.value, noise_warning)), h.noise_gain.value,
            text("noise near black is multiplied by up to %.3g", h.noise_gain.value),
            place(h.noise_gain)};
}

Finding lattice_error(const Health& h, const LatticeError& e) {
    if (!e.measured) {
        return {Severity::note,
                0,
                "not measured: some values are not numbers; repair them first (--repair)",
                {}};
    }
    if (!(e.code.max > 0)) {
        return {Severity::good, 0, "none: the lattice keeps what is there", {}};
    }
    return {for_shown(h, graded(e.to_eye.p99, error_warning)), e.to_eye.p99,
            text("%s p99 %.3g, mean %.3g, %s %.3g; codes p99 %.3g, %s %.3g",
                 h.results == Results::hdr ? "dE-ITP" : "dE2000", e.to_eye.p99, e.to_eye.mean,
                 largest_name(e.to_eye), e.to_eye.max, e.code.p99, largest_name(e.code),
                 e.code.max),
            e.in};
}

Finding error_at_16(const Health& h) {
    return lattice_error(h, h.lattices[0]);
}

Finding error_at_33(const Health& h) {
    return lattice_error(h, h.lattices[1]);
}

Finding clipping(const Health& h) {
    const std::size_t low = largest_of(h.clipped_low), high = largest_of(h.clipped_high);
    const bool top = h.clipped_high[high].value >= h.clipped_low[low].value;
    const Extreme& most = top ? h.clipped_high[high] : h.clipped_low[low];
    if (most.value <= 0) {
        return {Severity::good, 0, "no channel is clipped", {}};
    }
    return {most.value > clipped_warning ? Severity::warning : Severity::note, most.value,
            text("%s is clipped at its %s in %.3g %% of the cells", channels[top ? high : low],
                 top ? "highest" : "lowest", 100 * most.value),
            most.in};
}

Finding plateau(const Health& h) {
    if (h.plateau.value <= 0) {
        return {Severity::good, 0, "no channel is flat between its ends", {}};
    }
    return {
        graded(h.plateau.value, plateau_warning) == Severity::good ? Severity::note
                                                                   : Severity::warning,
        h.plateau.value,
        text("a channel is flat between its ends in %.3g %% of the cells", 100 * h.plateau.value),
        h.plateau.in};
}

Finding neutral_axis(const Health& h) {
    const std::size_t c = largest_of(h.channel_fall);
    const double luma = h.neutral_fall.value, channel = h.channel_fall[c].value;
    if (h.neutral_rise < 0 && luma >= -h.neutral_rise) {
        return {Severity::fault, luma,
                text("neutrals become darker towards white, by %.3g: a negative", luma),
                h.neutral_fall.in};
    }
    if (luma > 0) {
        return {graded(luma, fall_warning, fall_fault) == Severity::good
                    ? Severity::note
                    : graded(luma, fall_warning, fall_fault),
                luma, text("brighter neutrals become darker by up to %.3g", luma),
                h.neutral_fall.in};
    }
    if (channel > 0) {
        return {graded(channel, fall_fault) == Severity::good ? Severity::note : Severity::warning,
                channel, text("luma rises, but %s falls by up to %.3g", channels[c], channel),
                h.channel_fall[c].in};
    }
    return {h.neutral_rise > 0 ? Severity::good : Severity::note,
            0,
            h.neutral_rise > 0 ? "neutrals never fall" : "neutrals never rise",
            {}};
}

Finding invertible(const Health& h) {
    const double part = h.invertible;
    return {part < invertible_note ? Severity::note : Severity::good,
            part,
            part > 0
                ? text("at most %.4g %% of the input's volume can be inverted: the rest is flat or "
                       "turned over",
                       100 * part)
                : "nothing can be inverted: every tetrahedron is flat",
            {}};
}

Finding cut_off(const Health& h) {
    if (h.cut_off == 0) {
        return {Severity::good, 0, "the cube takes all that the 1D table, if any, gives", {}};
    }
    return {Severity::note,
            static_cast<double>(h.cut_off),
            text("%zu values of the 1D table lie outside the cube's domain and are clamped to it",
                 h.cut_off),
            {}};
}

constexpr std::array<HealthCheck, 17> health_check_rows{{
    {"non-finite", "values", "values that are not numbers", non_finite},
    {"spikes", "values", "single nodes that stand out", spikes},
    {"range", "beyond 0..1", "the outputs' range", range},
    {"1d-table", "fall", "a 1D table that is not monotonic", table_falls},
    {"cut-off", "values", "a 1D table that leaves the cube's domain", cut_off},
    {"fold-over", "share", "sign of the Jacobian in every tetrahedron", folds},
    {"neutral-axis", "fall", "neutrals that rise stay in order", neutral_axis},
    {"gain", "out per in", "largest singular value of the Jacobian", gain},
    {"condition", "ratio", "ratio of singular values", condition},
    {"second-difference", "output", "largest bend between neighbouring nodes", second_difference},
    {"banding", "dE", "largest step of a neutral ramp, to the eye", banding},
    {"noise-near-black", "times", "what small noise becomes in the dark", noise},
    {"error-at-16", "dE at 99 %", "measured of a lattice of 16 nodes per axis", error_at_16},
    {"error-at-33", "dE at 99 %", "measured of a lattice of 33 nodes per axis", error_at_33},
    {"clipping", "share of cells", "channels at their lowest or highest", clipping},
    {"plateaus", "share of cells", "channels that are flat in between", plateau},
    {"invertible", "share of volume", "what can be inverted at most", invertible},
}};

} // namespace

std::string_view name_of(Severity severity) {
    constexpr std::array<std::string_view, 4> names{"good", "note", "warning", "fault"};
    return names[static_cast<std::size_t>(severity)];
}

std::span<const HealthCheck> health_checks() {
    return health_check_rows;
}

Severity verdict(const Health& health) {
    Severity worst = Severity::good;
    for (const HealthCheck& check : health_check_rows) {
        worst = std::max(worst, check.judge(health).severity);
    }
    return worst;
}

} // namespace lutlib
