#include "lutlib/paint/denoise.h"

#include "lutlib/rising.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lutlib {
namespace {

using Matrix = std::vector<std::vector<double>>;

// What a row of n values becomes: the inverse of I + lambda D'D, D the third differences.
Matrix smoother(std::size_t n, double lambda) {
    constexpr std::array<double, 4> difference{-1, 3, -3, 1};
    Matrix a(n, std::vector<double>(n)), out = a;
    for (std::size_t i = 0; i < n; ++i) {
        a[i][i] = out[i][i] = 1;
    }
    for (std::size_t at = 0; at + 3 < n; ++at) {
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t k = 0; k < 4; ++k) {
                a[at + i][at + k] += lambda * difference[i] * difference[k];
            }
        }
    }
    // Gauss and Jordan; positive definite, so that no row need be exchanged.
    for (std::size_t i = 0; i < n; ++i) {
        const double pivot = 1 / a[i][i];
        for (std::size_t k = 0; k < n; ++k) {
            a[i][k] *= pivot;
            out[i][k] *= pivot;
        }
        for (std::size_t row = 0; row < n; ++row) {
            const double factor = row == i ? 0 : a[row][i];
            for (std::size_t k = 0; factor != 0 && k < n; ++k) {
                a[row][k] -= factor * a[i][k];
                out[row][k] -= factor * out[i][k];
            }
        }
    }
    return out;
}

using Values = std::vector<RgbD>;

// change(line) for the values along each line of each axis and each channel.
template <class F>
void for_each_line(Values& values, std::size_t n, F&& change) {
    const std::array<std::size_t, 3> steps{1, n, n * n};
    std::vector<double> line(n);
    for (const std::size_t step : steps) {
        for (std::size_t first = 0; first < values.size(); ++first) {
            if (first / step % n != 0) {
                continue;
            }
            for (std::size_t c = 0; c < 3; ++c) {
                for (std::size_t i = 0; i < n; ++i) {
                    line[i] = values[first + i * step][c];
                }
                change(line);
                for (std::size_t i = 0; i < n; ++i) {
                    values[first + i * step][c] = line[i];
                }
            }
        }
    }
}

Values smoothed(Values values, std::size_t n, double lambda) {
    const Matrix by = smoother(n, lambda);
    std::vector<double> out(n);
    for_each_line(values, n, [&](std::vector<double>& line) {
        for (std::size_t i = 0; i < n; ++i) {
            double sum = 0;
            for (std::size_t k = 0; k < n; ++k) {
                sum += by[i][k] * line[k];
            }
            out[i] = sum;
        }
        line = out;
    });
    return values;
}

double change_between(const Values& a, const Values& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const RgbD d = a[i] - b[i];
        sum += d.r * d.r + d.g * d.g + d.b * d.b;
    }
    return std::sqrt(sum / (3 * static_cast<double>(a.size())));
}

// As much smoothing as takes off the noise: by halving the range of its logarithm.
Values without_noise(const Values& values, std::size_t n, double sigma) {
    double low = -3, high = 5;
    for (int step = 0; step < 9; ++step) {
        const double middle = (low + high) / 2;
        (change_between(smoothed(values, n, std::pow(10, middle)), values) < sigma ? low : high) =
            middle;
    }
    return smoothed(values, n, std::pow(10, low));
}

void make_monotone(Values& values, std::size_t n, double sigma, double limit) {
    for_each_line(values, n, [&](std::vector<double>& line) {
        const double rise = line.back() - line.front();
        if (std::abs(rise) <= 3 * sigma) {
            return;
        }
        std::vector<double> sensed = line;
        const double sense = rise > 0 ? 1 : -1;
        for (double& value : sensed) {
            value *= sense;
        }
        const std::vector<double> fit = rising(sensed);
        double most = 0;
        for (std::size_t i = 0; i < n; ++i) {
            most = std::max(most, std::abs(fit[i] - sensed[i]));
        }
        for (std::size_t i = 0; most <= limit && i < n; ++i) {
            line[i] = sense * fit[i];
        }
    });
}

} // namespace

Denoised denoised(const Lut3D& cube, double noise) {
    Denoised out{.cube = cube};
    const auto n = static_cast<std::size_t>(cube.size);
    const double sigma = noise / 255, limit = std::max(3 * sigma, 0.75 / 255);
    out.limit = 255 * limit;
    Values before;
    for (const Rgb& node : cube.nodes) {
        before.push_back(to_double(node));
    }
    Values after = n >= 4 && noise > 0 ? without_noise(before, n, sigma) : before;
    make_monotone(after, n, sigma, limit);
    double sum = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        bool moved = false;
        for (std::size_t c = 0; c < 3; ++c) {
            const double was = before[i][c];
            if (was <= 0 || was >= 1) {
                continue;
            }
            const double is =
                std::clamp(after[i][c], std::max(0.0, was - limit), std::min(1.0, was + limit));
            out.cube.nodes[i][c] = static_cast<float>(is);
            const double change = 255 * std::abs(is - was);
            moved = moved || change > 1e-4;
            sum += change;
            out.largest = std::max(out.largest, change);
        }
        out.moved += moved ? 1 : 0;
    }
    out.mean = sum / (3 * static_cast<double>(before.size()));
    return out;
}

} // namespace lutlib
