#include "preview/reference/convolution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <fftw3.h>
#include <numbers>
#include <tbb/parallel_for.h>

namespace preview::reference {

namespace {

using lutlib::RgbD;

// A real plane of so many columns and rows with its forward and backward transforms.
class Plane {
  public:
    Plane(int width, int height)
        : width_(width), height_(height), real_(fftw_alloc_real(count(width, height))),
          spectrum_(fftw_alloc_complex(count(width / 2 + 1, height))),
          forward_(fftw_plan_dft_r2c_2d(height, width, real_, spectrum_, FFTW_ESTIMATE)),
          backward_(fftw_plan_dft_c2r_2d(height, width, spectrum_, real_, FFTW_ESTIMATE)) {}
    Plane(const Plane&) = delete;
    Plane& operator=(const Plane&) = delete;
    ~Plane() {
        fftw_destroy_plan(forward_);
        fftw_destroy_plan(backward_);
        fftw_free(real_);
        fftw_free(spectrum_);
    }

    double& at(int x, int y) {
        return real_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                     static_cast<std::size_t>(x)];
    }
    void clear() { std::fill_n(real_, count(width_, height_), 0.0); }
    void to_spectrum() { fftw_execute(forward_); }
    // Multiplies by another plane's spectrum, which is divided by `total`, and transforms back.
    void convolve_with(const Plane& kernel, double total) {
        const double scale = 1 / (total * static_cast<double>(count(width_, height_)));
        for (std::size_t i = 0; i < count(width_ / 2 + 1, height_); ++i) {
            const std::complex<double> a(spectrum_[i][0], spectrum_[i][1]);
            const std::complex<double> b(kernel.spectrum_[i][0], kernel.spectrum_[i][1]);
            const std::complex<double> c = a * b * scale;
            spectrum_[i][0] = c.real();
            spectrum_[i][1] = c.imag();
        }
        fftw_execute(backward_);
    }

  private:
    static std::size_t count(int w, int h) {
        return static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
    }

    int width_, height_;
    double* real_;
    fftw_complex* spectrum_;
    fftw_plan forward_, backward_;
};

/// The next length without prime factors above 7, of which transforms are fast.
int fast_length(int length) {
    for (;; ++length) {
        int rest = length;
        for (const int factor : {2, 3, 5, 7}) {
            while (rest % factor == 0) {
                rest /= factor;
            }
        }
        if (rest == 1) {
            return length;
        }
    }
}

} // namespace

double gaussian(double dx, double dy, double sigma) {
    return std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma)) /
           (2 * std::numbers::pi * sigma * sigma);
}

Image convolved(const Image& picture, int margin,
                const std::function<double(double, double)>& kernel) {
    // The picture with its margins, and the kernel's reach of zeros, over which nothing wraps
    // around.
    const int width = fast_length(picture.width + 3 * margin),
              height = fast_length(picture.height + 3 * margin);
    Plane filter(width, height);
    filter.clear();
    double total = 0;
    for (int dy = -margin; dy <= margin; ++dy) {
        for (int dx = -margin; dx <= margin; ++dx) {
            const double value = kernel(dx, dy);
            total += value;
            filter.at((dx + width) % width, (dy + height) % height) = value;
        }
    }
    filter.to_spectrum();

    // FFTW makes plans on one thread and may carry them out on several.
    std::array<Plane, 3> planes{{Plane(width, height), Plane(width, height), Plane(width, height)}};
    Image out(picture.width, picture.height);
    tbb::parallel_for(std::size_t{0}, planes.size(), [&](std::size_t channel) {
        Plane& plane = planes[channel];
        plane.clear();
        for (int y = -margin; y < picture.height + margin; ++y) {
            for (int x = -margin; x < picture.width + margin; ++x) {
                plane.at(x + margin, y + margin) = picture.clamped(x, y)[channel];
            }
        }
        plane.to_spectrum();
        plane.convolve_with(filter, total);
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 0; x < picture.width; ++x) {
                out.at(x, y)[channel] = plane.at(x + margin, y + margin);
            }
        }
    });
    return out;
}

} // namespace preview::reference
