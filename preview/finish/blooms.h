// Bloom methods as a table. A method is a plan: a list of linear filter steps over a pyramid of
// images, with every weight computed here, once. passes/bloom.cpp runs a plan on the GPU,
// reference/bloom.cpp in double; a new method is a new row and no new shader.
//
// Bloom moves the share `strength` of the light above the threshold, pre(hdr), to its surroundings:
//     out = hdr + strength * (bloom(pre(hdr)) - pre(hdr))
// where every bloom(...) of constant light is that light. Without light above the threshold the
// picture is unchanged, bit for bit.
//
// Geometry: texel i of a level spans 2i..2i+2 in the level below it, odd sizes round up, and
// positions are in texels and never in shares of the image, so that nothing shifts. Beyond its
// border a picture goes on as its border texels.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace preview {

struct BloomSettings {
    float strength = -1;    ///< 0..1; negative: the method's own
    float threshold = 1.2F; ///< of the largest channel; 0: all light blooms. Its knee ends at white
    float knee = 0.2F;      ///< half width of the quadratic knee about the threshold
    float radius = 1;       ///< scales the Gaussians' sigmas
    friend bool operator==(const BloomSettings&, const BloomSettings&) = default;
};

/// One bilinear fetch at source position scale * (x + 0.5) + offset, in source texels.
struct BloomTap {
    float x = 0, y = 0, weight = 0;
};

/// target(x) = sum of taps over `source` (+ keep * `own` where that is given).
struct BloomStep {
    int source = -1; ///< image number; picture_image is the HDR picture
    int target = 0;  ///< image number, written by this step alone
    float scale = 1; ///< source texels a target texel: 2 down, 0.5 up
    std::vector<BloomTap> taps;
    int own = -1;           ///< image that is blended in, or -1
    float own_scale = 1;    ///< its texels a target texel; it is fetched at own_scale * (x + 0.5)
    float keep = 0;         ///< its weight; the taps' weights sum to 1 - keep
    bool prefilter = false; ///< every tap is taken through pre()
    bool karis = false; ///< groups of four taps are averaged with weights 1 / (1 + largest channel)
    enum class Axis : std::uint8_t { both, x, y } axis = Axis::both; ///< of a separable step
};

struct BloomExtent {
    int width = 0, height = 0;
};

struct BloomPlan {
    static constexpr int picture_image = -1;
    static constexpr int max_taps = 32;      ///< of a step
    static constexpr int max_final_taps = 9; ///< of the composite

    std::vector<BloomExtent> images;
    std::vector<BloomStep> steps;

    /// The last filter, which the finishing pass does: a sum of bilinear fetches of one image at
    /// scale * (x + 0.5) + offset.
    struct Last {
        int image = 0;
        float scale = 1;
        std::vector<BloomTap> taps;
    };
    Last last;
    float strength = 0, threshold = 0, knee = 0;

    bool empty() const { return last.taps.empty(); }
};

/// Sigmas are given for a picture of so many lines, and follow its height: the glare of an eye is
/// an angle, and so is a pixel for a given field of view.
inline constexpr int bloom_nominal_height = 1080;

/// A part of a kernel that is a sum of Gaussians.
struct BloomGaussian {
    float sigma = 0, weight = 0; ///< sigma in texels of a picture of bloom_nominal_height lines
};

struct Bloom {
    std::string_view name;
    std::string_view label;
    bool conserves_energy; ///< a picture's sum stays, away from its border
    float strength;
    BloomPlan (*plan)(BloomExtent picture, const BloomSettings& settings);
    /// Whose sum its kernel stands for; weights sum to 1. Empty: it is what its filters make.
    std::span<const BloomGaussian> gaussians = {};
};

std::span<const Bloom> blooms();
const Bloom* bloom_named(std::string_view name);

/// An empty plan where the method is `none` or the strength 0.
BloomPlan bloom_plan(const Bloom& bloom, BloomExtent picture, const BloomSettings& settings);

/// Share of its light that a colour whose largest channel is `brightness` gives to bloom, 0..1.
double bloom_share(double brightness, double threshold, double knee);

/// No light up to this brightness blooms.
double bloom_onset(const BloomSettings& settings);

/// The filter of a step that halves with one tap a texel.
std::vector<BloomTap> texel_taps(const std::vector<BloomTap>& taps);

/// Half of a normalised, sampled Gaussian as bilinear taps: the single centre, then pairs of
/// neighbours fetched at once. Their mirror images are implied; the weights of all sum to 1.
/// `sigma` in texels, > 0; the radius is 3.5 sigma, at most what 2 * max_taps taps hold.
std::vector<BloomTap> gaussian_taps(float sigma);

} // namespace preview
