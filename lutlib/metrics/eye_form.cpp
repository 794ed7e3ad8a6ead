#include "lutlib/metrics/eye_form.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace lutlib {
namespace {

constexpr double step = 0.5 / 255;

// Along each channel, then along two at once, whose squares tell the mixed terms.
constexpr std::array<RgbD, 6> steps{
    {{step, 0, 0}, {0, step, 0}, {0, 0, step}, {step, step, 0}, {step, 0, step}, {0, step, step}}};

} // namespace

Metric eye_metric(const Viewing& viewing) {
    return is_hdr(viewing.output) ? Metric::delta_e_itp : Metric::delta_e_2000;
}

std::vector<EyeForm> eye_forms(const std::vector<RgbD>& codes, const Viewing& viewing) {
    const Eye eye(viewing);
    const Metric metric = eye_metric(viewing);
    std::vector<EyeForm> out(codes.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, codes.size(), 1024),
                      [&](const auto& range) {
                          const auto here = std::span(codes).subspan(range.begin(), range.size());
                          std::vector<RgbD> beside(here.size());
                          std::array<std::vector<double>, steps.size()> seen;
                          for (std::size_t k = 0; k < steps.size(); ++k) {
                              std::transform(here.begin(), here.end(), beside.begin(), [k](RgbD c) {
                                  // Into the range of codes, where the curves are those of a
                                  // display.
                                  const auto inward = [](double x, double by) {
                                      return x > 0.5 ? x - by : x + by;
                                  };
                                  return RgbD{inward(c.r, steps[k].r), inward(c.g, steps[k].g),
                                              inward(c.b, steps[k].b)};
                              });
                              seen[k].resize(here.size());
                              eye(metric, here, beside, seen[k]);
                          }
                          for (std::size_t i = 0; i < here.size(); ++i) {
                              const auto square = [&](std::size_t k) {
                                  const double s = seen[k][i] / step;
                                  return std::isfinite(s) ? s * s : 0.0;
                              };
                              const auto sign = [&](double a, double b) {
                                  return (a > 0.5) == (b > 0.5) ? 0.5 : -0.5;
                              };
                              const double r = square(0), g = square(1), b = square(2);
                              const RgbD at = here[i];
                              out[range.begin() + i] = {
                                  static_cast<float>(r),
                                  static_cast<float>(g),
                                  static_cast<float>(b),
                                  static_cast<float>(sign(at.r, at.g) * (square(3) - r - g)),
                                  static_cast<float>(sign(at.r, at.b) * (square(4) - r - b)),
                                  static_cast<float>(sign(at.g, at.b) * (square(5) - g - b))};
                          }
                      });
    return out;
}

} // namespace lutlib
