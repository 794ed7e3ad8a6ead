#include "lutlib/fit/curves_fit.h"

#include "lutlib/metrics/samples.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

constexpr int rounds = 12;
/// Of second differences between entries, as a share of what a sample weighs: settles entries that
/// no sample reaches.
constexpr double stiffness = 1e-6;
constexpr std::size_t lattice_of_samples = 13;

struct CurveSamples {
    std::vector<RgbD> in, out;
};

// Entries of a curve between low and high, in double.
struct WorkingCurve {
    double low = 0, high = 1;
    std::vector<double> entries;
    bool by_root = false;

    struct Place {
        std::size_t i;
        double t;
    };
    double share(double x) const { return saturate((x - low) / (high - low)); }
    Place place(double x) const {
        const auto last = static_cast<double>(entries.size() - 1);
        const double at = (by_root ? std::sqrt(share(x)) : share(x)) * last;
        const double i = std::min(std::floor(at), last - 1);
        return {static_cast<std::size_t>(i), at - i};
    }
    double at(double x) const {
        const auto [i, t] = place(x);
        return std::lerp(entries[i], entries[i + 1], t);
    }
    double slope(double x) const {
        constexpr double nearest = 1e-4; // to where a root is upright
        const std::size_t i = place(x).i;
        const double each =
            (entries[i + 1] - entries[i]) * static_cast<double>(entries.size() - 1) / (high - low);
        return by_root ? each / (2 * std::sqrt(std::max(share(x), nearest))) : each;
    }
};

struct WorkingCurves {
    std::array<WorkingCurve, 3> before, after;
    std::array<RgbD, 3> matrix{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

    RgbD mixed(RgbD in) const {
        const RgbD bent{before[0].at(in.r), before[1].at(in.g), before[2].at(in.b)};
        RgbD out;
        for (std::size_t c = 0; c < 3; ++c) {
            out[c] = matrix[c].r * bent.r + matrix[c].g * bent.g + matrix[c].b * bent.b;
        }
        return out;
    }
    RgbD operator()(RgbD in) const {
        const RgbD m = mixed(in);
        return {after[0].at(m.r), after[1].at(m.g), after[2].at(m.b)};
    }
};

CurveSamples curve_samples(const Transform& look, const Domain& domain) {
    const SampleCounts counts{.neutral = 129, .random = 2000};
    CurveSamples out;
    for (const Rgb& color : over_domain(sample_colors(lattice_of_samples, counts), domain)) {
        out.in.push_back(to_double(color));
    }
    out.out = out.in;
    apply_in_parallel(look, out.out);
    for (RgbD& c : out.out) {
        c = {held(c.r), held(c.g), held(c.b)};
    }
    return out;
}

void add_stiffness(Eigen::MatrixXd& normal, Eigen::Index first, Eigen::Index count, double weight) {
    constexpr std::array<double, 3> second{1, -2, 1};
    for (Eigen::Index i = 0; i + 2 < count; ++i) {
        for (Eigen::Index a = 0; a < 3; ++a) {
            for (Eigen::Index b = 0; b < 3; ++b) {
                normal(first + i + a, first + i + b) += weight *
                                                        second[static_cast<std::size_t>(a)] *
                                                        second[static_cast<std::size_t>(b)];
            }
        }
    }
}

Eigen::VectorXd solved(Eigen::MatrixXd normal, const Eigen::VectorXd& right) {
    // Entries of one constant more are as good: held by a trace of themselves.
    normal.diagonal().array() += 1e-12 * std::max(normal.trace(), 1e-30);
    return normal.ldlt().solve(right);
}

// The curves `after` for what is before them.
void fit_after(WorkingCurves& curves, const CurveSamples& samples) {
    for (std::size_t c = 0; c < 3; ++c) {
        WorkingCurve& curve = curves.after[c];
        std::vector<double> mixed;
        for (const RgbD& in : samples.in) {
            mixed.push_back(curves.mixed(in)[c]);
        }
        const auto [low, high] = std::minmax_element(mixed.begin(), mixed.end());
        curve.low = *low;
        curve.high = *high > *low ? *high : *low + 1;
        const auto n = static_cast<Eigen::Index>(curve.entries.size());
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
        for (std::size_t s = 0; s < mixed.size(); ++s) {
            const auto [i, t] = curve.place(mixed[s]);
            const auto k = static_cast<Eigen::Index>(i);
            const double y = samples.out[s][c];
            normal(k, k) += (1 - t) * (1 - t);
            normal(k, k + 1) += t * (1 - t);
            normal(k + 1, k) += t * (1 - t);
            normal(k + 1, k + 1) += t * t;
            right(k) += (1 - t) * y;
            right(k + 1) += t * y;
        }
        add_stiffness(normal, 0, n, stiffness * static_cast<double>(mixed.size()));
        const Eigen::VectorXd found = solved(normal, right);
        for (Eigen::Index i = 0; i < n; ++i) {
            curve.entries[static_cast<std::size_t>(i)] = found(i);
        }
    }
}

// What the results of the matrix should be, and how much each counts.
struct Aim {
    double value, weight;
};

// The nearest input for which a curve has a value; an end's where it has it nowhere.
double input_of(const WorkingCurve& curve, double value, double near) {
    const std::vector<double>& e = curve.entries;
    const auto [i, t] = curve.place(near);
    const double start = static_cast<double>(i) + t;
    double found = value > e.back() ? static_cast<double>(e.size() - 1) : 0, distance = 1e9;
    for (std::size_t k = 0; k + 1 < e.size(); ++k) {
        if (e[k] == e[k + 1] || (value - e[k]) * (value - e[k + 1]) > 0) {
            continue;
        }
        const double at = static_cast<double>(k) + (value - e[k]) / (e[k + 1] - e[k]);
        if (std::abs(at - start) < distance) {
            distance = std::abs(at - start);
            found = at;
        }
    }
    const double share = found / static_cast<double>(e.size() - 1);
    return std::lerp(curve.low, curve.high, curve.by_root ? share * share : share);
}

// With the mean slope on the way as weight, what is left of the way counts as it does behind the
// curve.
Aim aim_of(const WorkingCurve& after, double mixed, double out) {
    const double value = input_of(after, out, mixed);
    const double way = value - mixed, width = after.high - after.low;
    const double slope =
        std::abs(way) > 1e-9 * width ? (out - after.at(mixed)) / way : after.slope(mixed);
    // A clipped result says nothing of what was clipped.
    return std::abs(slope) * width > 1e-3 ? Aim{value, slope * slope} : Aim{mixed, 0};
}

void fit_matrix(WorkingCurves& curves, const CurveSamples& samples) {
    const WorkingCurves was = curves;
    for (std::size_t c = 0; c < 3; ++c) {
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(3, 3);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(3);
        for (std::size_t s = 0; s < samples.in.size(); ++s) {
            const RgbD in = samples.in[s];
            const Eigen::Vector3d bent(was.before[0].at(in.r), was.before[1].at(in.g),
                                       was.before[2].at(in.b));
            const Aim aim = aim_of(was.after[c], was.mixed(in)[c], samples.out[s][c]);
            normal += aim.weight * bent * bent.transpose();
            right += aim.weight * aim.value * bent;
        }
        if (normal.trace() > 0) {
            const Eigen::VectorXd row = solved(normal, right);
            curves.matrix[c] = {row(0), row(1), row(2)};
        }
    }
}

void fit_before(WorkingCurves& curves, const CurveSamples& samples) {
    const auto n = static_cast<Eigen::Index>(curves.before[0].entries.size());
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(3 * n);
    double weights = 0;
    for (std::size_t s = 0; s < samples.in.size(); ++s) {
        const RgbD in = samples.in[s], mixed = curves.mixed(in);
        std::array<Eigen::Index, 6> at{};
        std::array<double, 6> hat{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [i, t] = curves.before[k].place(in[k]);
            at[2 * k] = static_cast<Eigen::Index>(k) * n + static_cast<Eigen::Index>(i);
            at[2 * k + 1] = at[2 * k] + 1;
            hat[2 * k] = 1 - t;
            hat[2 * k + 1] = t;
        }
        for (std::size_t c = 0; c < 3; ++c) {
            const Aim aim = aim_of(curves.after[c], mixed[c], samples.out[s][c]);
            for (std::size_t a = 0; a < 6; ++a) {
                const double left = aim.weight * curves.matrix[c][a / 2] * hat[a];
                right(at[a]) += left * aim.value;
                for (std::size_t b = 0; b < 6; ++b) {
                    normal(at[a], at[b]) += left * curves.matrix[c][b / 2] * hat[b];
                }
            }
            weights += aim.weight * curves.matrix[c][c] * curves.matrix[c][c];
        }
    }
    for (Eigen::Index k = 0; k < 3; ++k) {
        add_stiffness(normal, k * n, n, stiffness * weights);
    }
    const Eigen::VectorXd found = solved(normal, right);
    for (std::size_t k = 0; k < 3; ++k) {
        // From 0 to 1: the matrix and the curves behind it take the rest.
        const auto first = static_cast<Eigen::Index>(k) * n;
        const double low = found(first), width = found(first + n - 1) - low;
        if (!(std::abs(width) > 1e-9)) {
            continue;
        }
        for (Eigen::Index i = 0; i < n; ++i) {
            curves.before[k].entries[static_cast<std::size_t>(i)] =
                (found(first + i) - low) / width;
        }
        for (RgbD& row : curves.matrix) {
            row[k] *= width;
        }
    }
}

double squares(const WorkingCurves& curves, const CurveSamples& samples) {
    double out = 0;
    for (std::size_t s = 0; s < samples.in.size(); ++s) {
        const RgbD d = curves(samples.in[s]) - samples.out[s];
        out += d.r * d.r + d.g * d.g + d.b * d.b;
    }
    return out;
}

// The encodings between whose curves a look may be a matrix; both null: those that do nothing.
struct Beginning {
    const Encoding *input, *output;
};

// The matrix that is best for the results as `output` decodes them; what is added to all of them is
// the affair of the curves behind it.
void begin_matrix(WorkingCurves& curves, const Encoding* output, const CurveSamples& samples) {
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(4, 4);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(4, 3);
    for (std::size_t s = 0; s < samples.in.size(); ++s) {
        const RgbD in = samples.in[s], out = samples.out[s];
        const Eigen::Vector4d bent(curves.before[0].at(in.r), curves.before[1].at(in.g),
                                   curves.before[2].at(in.b), 1);
        normal += bent * bent.transpose();
        for (std::size_t c = 0; c < 3; ++c) {
            right.col(static_cast<Eigen::Index>(c)) +=
                bent * (output ? output->decode(out[c]) : out[c]);
        }
    }
    for (std::size_t c = 0; c < 3; ++c) {
        const Eigen::VectorXd row = solved(normal, right.col(static_cast<Eigen::Index>(c)));
        curves.matrix[c] = {row(0), row(1), row(2)};
    }
}

WorkingCurves beginning(const Domain& domain, int entries, const Beginning& from,
                        const CurveSamples& samples) {
    WorkingCurves out;
    for (std::size_t k = 0; k < 3; ++k) {
        WorkingCurve& curve = out.before[k];
        curve.low = domain.min[k];
        curve.high = domain.max[k];
        curve.entries.resize(static_cast<std::size_t>(entries));
        for (int i = 0; i < entries; ++i) {
            const double x = std::lerp(curve.low, curve.high, i / (entries - 1.0));
            curve.entries[static_cast<std::size_t>(i)] = from.input ? from.input->decode(x) : x;
        }
        const double low = curve.entries.front(), width = curve.entries.back() - low;
        for (double& entry : curve.entries) {
            entry = width != 0 ? (entry - low) / width : 0;
        }
        out.after[k].entries.resize(static_cast<std::size_t>(entries));
        out.after[k].by_root = from.output != nullptr;
    }
    begin_matrix(out, from.output, samples);
    fit_after(out, samples);
    return out;
}

InlineCurve rounded(const WorkingCurve& curve) {
    InlineCurve out{static_cast<float>(held(curve.low)),
                    static_cast<float>(held(curve.high)),
                    {},
                    curve.by_root};
    for (const double entry : curve.entries) {
        out.entries.push_back(static_cast<float>(held(entry)));
    }
    return out;
}

InlineCurves rounded(const WorkingCurves& curves, const Domain& domain) {
    InlineCurves out{domain, true, {}, {}, {}};
    for (std::size_t c = 0; c < 3; ++c) {
        out.before[c] = rounded(curves.before[c]);
        out.after[c] = rounded(curves.after[c]);
        out.matrix[c] = to_float(curves.matrix[c]);
    }
    return out;
}

} // namespace

std::vector<InlineCurves> fit_curves(const Transform& look, const Domain& domain,
                                     const LookEncodings& encodings, int entries) {
    const CurveSamples samples = curve_samples(look, domain);
    std::vector<std::pair<double, WorkingCurves>> found;
    const Encoding input = encodings.input.value_or(srgb()),
                   output = encodings.output.value_or(srgb());
    for (const Beginning& from : {Beginning{nullptr, nullptr}, Beginning{&input, &output}}) {
        WorkingCurves curves = beginning(domain, entries, from, samples);
        found.emplace_back(squares(curves, samples), curves);
        for (int round = 0; round < rounds; ++round) {
            fit_matrix(curves, samples);
            fit_after(curves, samples);
            fit_before(curves, samples);
            fit_after(curves, samples);
            if (const double error = squares(curves, samples); error < found.back().first) {
                found.back() = {error, curves};
            }
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<InlineCurves> out;
    for (const auto& [error, curves] : found) {
        out.push_back(rounded(curves, domain));
    }
    return out;
}

InlineCurves sampled_curves(const Transform& look, const Domain& domain, int entries) {
    InlineCurves out{domain, false, {}, {}, {}};
    for (std::size_t c = 0; c < 3; ++c) {
        out.after[c].low = domain.min[c];
        out.after[c].high = domain.max[c];
    }
    for (int i = 0; i < entries; ++i) {
        RgbD in;
        for (std::size_t c = 0; c < 3; ++c) {
            in[c] = std::lerp(double{domain.min[c]}, double{domain.max[c]}, i / (entries - 1.0));
        }
        const Rgb image = to_float(look(in));
        for (std::size_t c = 0; c < 3; ++c) {
            out.after[c].entries.push_back(image[c]);
        }
    }
    return out;
}

bool keeps_channels_apart(const Transform& look, const Domain& domain) {
    const std::vector<Rgb> colors =
        over_domain(sample_colors(2, {.neutral = 2, .random = 300, .lattice = false}), domain);
    for (const Rgb& color : colors) {
        const RgbD image = look(to_double(color));
        for (std::size_t c = 0; c < 3; ++c) {
            const double v = color[c];
            if (std::abs(look(RgbD{v, v, v})[c] - image[c]) > 1e-6) {
                return false;
            }
        }
    }
    return true;
}

} // namespace lutlib
