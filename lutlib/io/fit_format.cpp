#include "lutlib/io/fit_format.h"

#include "lutlib/codes.h"
#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/io/describe.h"
#include "lutlib/limits.h"
#include "lutlib/metrics/compare.h"
#include "lutlib/nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lutlib::io {
namespace {

constexpr int made_cube_size = 65;
constexpr int made_curve_size = 4096;

bool same_in_all_channels(const Domain& d) {
    return d.min == Rgb{d.min.r, d.min.r, d.min.r} && d.max == Rgb{d.max.r, d.max.r, d.max.r};
}

Domain united(const Domain& d) {
    const float min = std::min({d.min.r, d.min.g, d.min.b});
    const float max = std::max({d.max.r, d.max.g, d.max.b});
    return {{min, min, min}, {max, max, max}};
}

// The nearest interval to `wanted` that the format can say.
Domain allowed(const Domain& wanted, bool any_domain, bool per_channel) {
    if (!any_domain) {
        return {};
    }
    return per_channel || same_in_all_channels(wanted) ? wanted : united(wanted);
}

// Units of input that lie in `before` and not in `after`, of the channel that loses most.
double cut_away(const Domain& before, const Domain& after) {
    double most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const double lower = std::max(0.0F, after.min[c] - before.min[c]);
        const double upper = std::max(0.0F, before.max[c] - after.max[c]);
        most = std::max(most, std::min<double>(lower + upper, before.max[c] - before.min[c]));
    }
    return most;
}

// In code values; 0 where it is rounding of float arithmetic and no loss of the conversion.
double largest_error(const Lut& before, const Lut& after, const Domain& over) {
    constexpr double rounding_noise = 1e-6;
    constexpr SampleLimits limits{.even = 10'000, .between = 1 << 13};
    const Transform first = Transform::of(before), second = Transform::of(after);
    const Peak peak = largest_difference(
        first, second, error_samples(over, united(breaks_of(before), breaks_of(after)), limits), {},
        Metric::code);
    const double size = std::max(1.0, largest_magnitude(first(to_double(peak.at))));
    return peak.error > rounding_noise * size ? peak.error : 0;
}

// A shaper that only maps the cube's domain to 0..1, and the cube on 0..1: the same look.
void move_domain_into_shaper(Lut& lut) {
    lut.shaper = Lut1D{lut.cube->domain, {{0, 0, 0}, {1, 1, 1}}};
    lut.cube->domain = {};
}

// Rescales a shaper's values so that the cube behind it spans 0..1.
void move_domain_into_values(Lut& lut) {
    const Domain d = lut.cube->domain;
    for (Rgb& entry : lut.shaper->entries) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double min = d.min[c];
            entry[c] = static_cast<float>((static_cast<double>(entry[c]) - min) /
                                          (static_cast<double>(d.max[c]) - min));
        }
    }
    lut.cube->domain = {};
}

Lut sampled_curve(const Lut& lut, const Domain& domain) {
    Lut out = lut;
    out.cube.reset();
    const int size = std::max(made_curve_size, lut.shaper ? lut.shaper->size() : 0);
    out.shaper = Lut1D{domain, std::vector<Rgb>(static_cast<std::size_t>(size))};
    for (int i = 0; i < size; ++i) {
        const RgbD at = entry_position(*out.shaper, i);
        Rgb& entry = out.shaper->entries[static_cast<std::size_t>(i)];
        for (std::size_t c = 0; c < 3; ++c) {
            entry[c] = to_float(evaluate_exact(lut, {at[c], at[c], at[c]}))[c];
        }
    }
    return out;
}

Lut sampled_cube(const Lut& lut, const Domain& domain, int size) {
    Lut out = lut;
    out.shaper.reset();
    out.cube = identity_cube(size, domain);
    for_each_node(size, [&](int r, int g, int b) {
        out.cube->at(r, g, b) = evaluate(lut, to_float(node_position(*out.cube, r, g, b)));
    });
    return out;
}

// What is left of the values when the file's numbers have so many bits or decimals.
void report_precision(const Lut& lut, const Holds& holds, std::vector<Loss>& losses) {
    if (holds.integer_bits == 0 && holds.decimals == 0) {
        return;
    }
    const CodeDepth depth{holds.integer_bits};
    const double steps = holds.integer_bits ? depth.maximum() : std::pow(10.0, holds.decimals);
    std::size_t clamped = 0;
    double most_clamped = 0, most_rounded = 0;
    const auto look_at = [&](const std::vector<Rgb>& values) {
        for (const Rgb& value : values) {
            for (std::size_t c = 0; c < 3; ++c) {
                const double v = value[c];
                const double kept = holds.integer_bits ? std::clamp(v, 0.0, 1.0) : v;
                clamped += kept != v;
                most_clamped = std::max(most_clamped, std::abs(v - kept));
                const double rounded = holds.integer_bits ? depth.value(depth.code(kept))
                                                          : std::round(kept * steps) / steps;
                most_rounded = std::max(most_rounded, std::abs(rounded - kept));
            }
        }
    };
    if (lut.cube) {
        look_at(lut.cube->nodes);
    }
    if (lut.shaper) {
        look_at(lut.shaper->entries);
    }
    if (clamped > 0) {
        losses.push_back({std::to_string(clamped) + " values outside 0..1 clamped, the furthest by",
                          most_clamped, ""});
    }
    // A value that came from codes or decimals of this very precision is within float rounding.
    if (most_rounded > 1e-3 / steps) {
        const std::string unit = holds.integer_bits ? std::to_string(holds.integer_bits) + " bits"
                                                    : std::to_string(holds.decimals) + " decimals";
        losses.push_back({"rounded to " + unit + ", largest error", most_rounded, ""});
    }
}

void drop_tiny_values(const Holds& holds, FitToFormat& fit) {
    constexpr float least = std::numeric_limits<float>::min();
    if (holds.tiny) {
        return;
    }
    std::size_t dropped = 0;
    float largest = 0;
    const auto drop = [&](std::vector<Rgb>& values) {
        for (Rgb& value : values) {
            for (std::size_t c = 0; c < 3; ++c) {
                if (value[c] != 0 && std::abs(value[c]) < least) {
                    ++dropped;
                    largest = std::max(largest, std::abs(value[c]));
                    value[c] = 0;
                }
            }
        }
    };
    if (fit.lut.cube) {
        drop(fit.lut.cube->nodes);
    }
    if (fit.lut.shaper) {
        drop(fit.lut.shaper->entries);
    }
    if (dropped > 0) {
        fit.losses.push_back({std::to_string(dropped) +
                                  " values so small that OpenColorIO reads no number written as 0, "
                                  "the largest",
                              largest, ""});
    }
}

void report_keywords(const Lut& lut, const Holds& holds, std::vector<Loss>& losses) {
    if (holds.keywords || lut.keywords.empty()) {
        return;
    }
    std::string names;
    for (const std::string& line : lut.keywords) {
        names += (names.empty() ? "" : ", ") + line.substr(0, line.find_first_of(" \t"));
    }
    losses.push_back({"keywords that only a .cube keeps dropped (" + names + ")",
                      static_cast<double>(lut.keywords.size()), "lines"});
}

void report_encodings(const Lut& lut, const Holds& holds, std::vector<Loss>& losses) {
    const EncodingNames& known = lut.encodings;
    if (holds.encodings || !known.any()) {
        return;
    }
    const std::string said = (known.input.empty() ? "" : "input " + known.input) +
                             (known.input.empty() || known.output.empty() ? "" : ", ") +
                             (known.output.empty() ? "" : "output " + known.output);
    losses.push_back({"encodings not written, say them with --look-input and --look-output when "
                      "the file is used (" +
                          said + ")",
                      known.input.empty() || known.output.empty() ? 1.0 : 2.0, "names"});
}

// Formats that name one know trilinear and tetrahedral.
void report_interpolation(const Holds& holds, FitToFormat& fit) {
    const std::optional<Interpolation> asked = fit.lut.interpolation;
    if (!asked || (fit.lut.cube && holds.interpolation && *asked != Interpolation::nearest)) {
        return;
    }
    const Lut before = fit.lut;
    fit.lut.interpolation.reset();
    const double error = fit.lut.cube ? largest_error(before, fit.lut, before.domain()) : 0;
    if (error > 0) {
        fit.losses.push_back({std::string(name_of(*asked)) +
                                  " interpolation, which the look asks for, not kept; largest "
                                  "error of tetrahedral",
                              error, ""});
    }
}

struct Plan {
    bool curve = false, cube = false;
};

Plan plan_of(const Lut& lut, const Holds& holds) {
    const bool both = lut.shaper && lut.cube;
    if (both && holds.curve_and_cube) {
        return {true, true};
    }
    const bool cube_wanted = lut.cube || !lut.shaper;
    if (holds.cube && (cube_wanted || !holds.curve)) {
        return {false, true};
    }
    if (holds.curve) {
        return {true, false};
    }
    throw UsageError("this format can only be read");
}

// The least size that holds a lattice's own nodes, so that growing it costs nothing.
int grown(int own, int least) {
    const int cells = own - 1;
    return (least - 1 + cells - 1) / cells * cells + 1;
}

int cube_size_for(const Lut& lut, const Domain& domain, const Holds& holds, int wanted) {
    if (wanted != 0) {
        check_cube_size(wanted);
        if (wanted < holds.min_cube_size || wanted > holds.max_cube_size) {
            throw Error("the format holds " + std::to_string(holds.min_cube_size) + " to " +
                        std::to_string(holds.max_cube_size) + " nodes per axis, not " +
                        std::to_string(wanted));
        }
        return wanted;
    }
    const int own = lut.cube ? lut.cube->size : 0;
    const bool kept = lut.cube && !lut.shaper && lut.cube->domain == domain;
    const int size = kept ? own : std::max(own, made_cube_size);
    return std::min(size < holds.min_cube_size ? grown(size, holds.min_cube_size) : size,
                    holds.max_cube_size);
}

void resample(const Lut& lut, const Plan& plan, const Holds& holds, int cube_size,
              FitToFormat& fit) {
    Lut& out = fit.lut;
    const Domain before = lut.domain();
    const bool any_domain = plan.curve ? holds.curve_domain : holds.cube_domain;
    const Domain domain = allowed(before, any_domain, holds.per_channel_domain);
    if (plan.curve && plan.cube) {
        if (out.shaper->domain != domain) {
            Lut shaper_only;
            shaper_only.shaper = out.shaper;
            out.shaper = sampled_curve(shaper_only, domain).shaper;
        }
        if (cube_size != 0 && cube_size != out.cube->size) {
            Lut cube_only;
            cube_only.cube = out.cube;
            cube_only.interpolation = out.interpolation;
            out.cube = sampled_cube(cube_only, out.cube->domain, cube_size).cube;
        }
    } else if (plan.curve) {
        if (out.cube || !out.shaper || out.shaper->domain != domain) {
            out = sampled_curve(lut, domain);
        }
    } else {
        const int size = cube_size_for(lut, domain, holds, cube_size);
        if (out.shaper || !out.cube || out.cube->domain != domain || out.cube->size != size) {
            out = sampled_cube(lut, domain, size);
        }
    }
    if (const double cut = cut_away(before, domain); cut > 0) {
        fit.losses.push_back(
            {"input " + text_of(before) + " cut to " + text_of(domain), cut, "units of input"});
    }
    const bool same = lut.shaper == out.shaper && lut.cube == out.cube;
    const double error = same ? 0 : largest_error(lut, out, domain);
    if (error > 0) {
        const std::string what = plan.curve && !plan.cube && lut.cube
                                     ? "channels that mix replaced by the neutral axis in "
                                     : "resampled to ";
        fit.losses.push_back({what + shape_of(out) + ", largest error", error, ""});
    }
}

} // namespace

bool can_hold(const Lut& lut, const Holds& holds) {
    const auto domain_fits = [&](const Domain& d, bool any_domain) {
        return d == allowed(d, any_domain, holds.per_channel_domain);
    };
    if (lut.cube &&
        (lut.cube->size < holds.min_cube_size || lut.cube->size > holds.max_cube_size)) {
        return false;
    }
    if (lut.shaper && lut.cube) {
        return holds.curve_and_cube && domain_fits(lut.shaper->domain, holds.curve_domain) &&
               domain_fits(lut.cube->domain, holds.cube_domain);
    }
    return lut.shaper ? holds.curve && domain_fits(lut.shaper->domain, holds.curve_domain)
                      : lut.cube && holds.cube && domain_fits(lut.cube->domain, holds.cube_domain);
}

FitToFormat fit_to(const Lut& lut, const Holds& holds, int cube_size) {
    validate(lut);
    FitToFormat fit{lut, {}};
    Plan plan = plan_of(lut, holds);
    const auto cube_domain_fits = [&](const Domain& d) {
        return d == allowed(d, holds.cube_domain, holds.per_channel_domain);
    };
    if (lut.cube && !cube_domain_fits(lut.cube->domain)) {
        if (plan.curve && plan.cube) {
            move_domain_into_values(fit.lut);
        } else if (!lut.shaper && holds.curve_and_cube &&
                   lut.domain() ==
                       allowed(lut.domain(), holds.curve_domain, holds.per_channel_domain)) {
            move_domain_into_shaper(fit.lut);
            plan = {true, true};
        }
    }
    resample(lut, plan, holds, cube_size, fit);
    report_interpolation(holds, fit);
    drop_tiny_values(holds, fit);
    report_precision(fit.lut, holds, fit.losses);
    report_keywords(fit.lut, holds, fit.losses);
    report_encodings(fit.lut, holds, fit.losses);
    return fit;
}

} // namespace lutlib::io
