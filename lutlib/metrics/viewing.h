// What makes two code values differ, in numbers and to the eye.
#pragma once

#include "lutlib/color/encoding.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace lutlib {

/// Of graphics white and of a diffuse white of 100 % reflectance, in cd/m2: ITU-R BT.2408, table 1.
inline constexpr double reference_white_nits = 203;

/// What results are shown on. Light of 1 has `reference_white` cd/m2, but in PQ, whose codes say
/// how much they are themselves. L* of 100 is `reference_white` in every encoding.
struct Viewing {
    Encoding output = srgb();
    double reference_white = reference_white_nits;

    Viewing() = default;
    Viewing(const Encoding& encoding, double white = reference_white_nits)
        : output(encoding), reference_white(white) {}
};

/// Light of the output to linear Rec.709 light of which 1 is diffuse white.
Matrix3 light_to_rec709(const Viewing& viewing);

/// Whether codes go far beyond diffuse white, where dE2000 means little: PQ and HLG.
bool is_hdr(const Encoding& encoding);

/// code: the largest channel difference of code values.
enum class Metric : std::uint8_t { code, delta_e_2000, delta_e_itp };
inline constexpr std::size_t metric_count = 3;

struct MetricInfo {
    Metric kind;
    std::string_view name, label;
};
/// In the order of the enumeration.
std::span<const MetricInfo, metric_count> metrics();

/// Errors of many colours by a metric. A colour with a channel that is not finite has an infinite
/// one.
class Eye {
  public:
    explicit Eye(const Viewing& viewing);

    /// Of every pair, into spans of the same length.
    void operator()(Metric metric, std::span<const RgbD> a, std::span<const RgbD> b,
                    std::span<double> errors) const;
    /// By both measures of the eye, which share their way to light.
    void both(std::span<const RgbD> a, std::span<const RgbD> b, std::span<double> delta_e_2000,
              std::span<double> delta_e_itp) const;

  private:
    Encoding output_;
    Matrix3 to_rec709_, to_rec2020_nits_;
};

} // namespace lutlib
