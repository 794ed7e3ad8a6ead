#include "preview/finish/blooms.h"

#include "lutlib/named.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace preview {

namespace {

constexpr float nominal_height = bloom_nominal_height;

class Planner {
  public:
    Planner(BloomExtent picture, const BloomSettings& settings)
        : picture_(picture), prefilters_(settings.threshold > 0) {
        plan_.strength = settings.strength;
        plan_.threshold = settings.threshold;
        plan_.knee = std::min(settings.knee, settings.threshold);
    }

    BloomExtent extent(int image) const {
        return image == BloomPlan::picture_image ? picture_
                                                 : plan_.images[static_cast<std::size_t>(image)];
    }

    int halve(int source, std::vector<BloomTap> taps, bool karis = false) {
        const BloomExtent from = extent(source);
        BloomStep step{source, 0, 2, std::move(taps)};
        step.karis = karis;
        step.prefilter = prefilters_ && source == BloomPlan::picture_image;
        // What pre() does to single texels is lost when it sees averages of four; and the whole
        // picture is halved fastest by single texels (shaders/bloom_halve.comp).
        if (source == BloomPlan::picture_image && !karis) {
            step.taps = texel_taps(step.taps);
        }
        return add(std::move(step), {(from.width + 1) / 2, (from.height + 1) / 2});
    }

    int enlarge(int source, std::vector<BloomTap> taps, int own, float keep) {
        for (BloomTap& tap : taps) {
            tap.weight *= 1 - keep;
        }
        BloomStep step{source, 0, 0.5F, std::move(taps), own};
        step.keep = keep;
        return add(std::move(step), extent(own));
    }

    int blur(int source, float sigma) {
        for (const auto axis : {BloomStep::Axis::x, BloomStep::Axis::y}) {
            BloomStep step{source, 0, 1, gaussian_taps(sigma)};
            step.axis = axis;
            source = add(std::move(step), extent(source));
        }
        return source;
    }

    /// Blends the coarser image `own` into the image that the last step made.
    void blend(int own, float own_scale, float keep) {
        BloomStep& step = plan_.steps.back();
        step.own = own;
        step.own_scale = own_scale;
        step.keep = keep;
        for (BloomTap& tap : step.taps) {
            tap.weight *= 1 - keep;
        }
    }

    void finish(int image, float scale, std::vector<BloomTap> taps) {
        plan_.last = {image, scale, std::move(taps)};
    }

    BloomPlan take() { return std::move(plan_); }

  private:
    int add(BloomStep step, BloomExtent extent) {
        step.target = static_cast<int>(plan_.images.size());
        plan_.images.push_back(extent);
        plan_.steps.push_back(std::move(step));
        return plan_.steps.back().target;
    }

    BloomExtent picture_;
    bool prefilters_;
    BloomPlan plan_;
};

std::vector<BloomTap> corners(float distance, float weight) {
    return {{-distance, -distance, weight},
            {distance, -distance, weight},
            {-distance, distance, weight},
            {distance, distance, weight}};
}

// [1 3 3 1] / 8 along each axis: unlike the mean of 2x2 it keeps the centre of mass of a source
// wherever it sits, so that a slow pan does not jitter. Adds the variance 3/4 in source texels.
std::vector<BloomTap> cubic_down() {
    return corners(0.75F, 0.25F);
}

// Variance, in target texels of the picture, of k halvings by cubic_down() and one bilinear
// enlargement: (4^k - 1) / 4 + 4^k / 6.
float pyramid_variance(int k) {
    const float area = std::ldexp(1.0F, 2 * k);
    return (area - 1) / 4 + area / 6;
}

// Each Gaussian, from narrow to wide, on the coarsest level on which its sigma, less what the
// pyramid itself adds, is still so wide that samples of it sum up evenly. Then from the coarsest
// level on each sum is enlarged into the next finer level: an enlargement adds the same variance in
// one step or in several, and whoever reads the glow reads one image.
BloomPlan gaussians_plan(BloomExtent picture, const BloomSettings& settings,
                         std::span<const BloomGaussian> gaussians) {
    constexpr float least_sigma = 1.4F;
    struct Placed {
        int level, image;
        float sigma, weight; ///< sigma in texels of its level
    };
    Planner planner(picture, settings);
    std::vector<Placed> placed;
    int level = 0, image = BloomPlan::picture_image;
    const float scale = settings.radius * static_cast<float>(picture.height) / nominal_height;
    for (const BloomGaussian& gaussian : gaussians) {
        const float sigma = std::max(gaussian.sigma * scale, 0.1F);
        const auto sigma_on = [&](int k) {
            const float left = sigma * sigma - pyramid_variance(k);
            return left > 0 ? std::ldexp(std::sqrt(left), -k) : 0;
        };
        while (level == 0 || sigma_on(level + 1) >= least_sigma) {
            image = planner.halve(image, cubic_down());
            ++level;
        }
        placed.push_back({level, image, std::max(sigma_on(level), 0.05F), gaussian.weight});
    }
    Placed sum{};
    for (auto next = placed.rbegin(); next != placed.rend(); ++next) {
        const int blurred = planner.blur(next->image, next->sigma);
        const float total = sum.weight + next->weight;
        if (sum.weight > 0) {
            planner.blend(sum.image, std::ldexp(1.0F, next->level - sum.level), sum.weight / total);
        }
        sum = {next->level, blurred, 0, total};
    }
    planner.finish(sum.image, std::ldexp(1.0F, -sum.level), {{0, 0, 1}});
    return planner.take();
}

// The eye's veiling glare as a sum: .8843 delta + .1 g(6.2) + .012 g(24.9) + .0027 g(81) +
// .001 g(263). The delta is what strength leaves.
constexpr float glare_share = 0.1157F;
constexpr std::array<BloomGaussian, 4> glare{{{6.2F, 0.1F / glare_share},
                                              {24.9F, 0.012F / glare_share},
                                              {81, 0.0027F / glare_share},
                                              {263, 0.001F / glare_share}}};
BloomPlan glare_plan(BloomExtent picture, const BloomSettings& settings) {
    return gaussians_plan(picture, settings, glare);
}

constexpr std::array<BloomGaussian, 1> one{{{14, 1}}};
BloomPlan gaussian_plan(BloomExtent picture, const BloomSettings& settings) {
    Planner planner(picture, settings);
    const float sigma =
        one[0].sigma * settings.radius * static_cast<float>(picture.height) / nominal_height;
    const int half = planner.halve(BloomPlan::picture_image, cubic_down());
    const float left = std::max(sigma * sigma - pyramid_variance(1), 0.01F);
    planner.finish(planner.blur(half, std::sqrt(left) / 2), 0.5F, {{0, 0, 1}});
    return planner.take();
}

// How often a picture halves until it is about `lines` high, at least once.
int halvings(BloomExtent picture, const BloomSettings& settings, float lines) {
    const float ratio = settings.radius * static_cast<float>(picture.height) / lines;
    return std::clamp(static_cast<int>(std::lround(std::log2(std::max(ratio, 1.0F)))), 1, 8);
}

// Bjorge 2015, "Bandwidth-efficient rendering".
BloomPlan dual_kawase_plan(BloomExtent picture, const BloomSettings& settings) {
    std::vector<BloomTap> down{{0, 0, 4.0F / 8}}, up;
    for (const BloomTap& tap : corners(1, 1.0F / 8)) {
        down.push_back(tap);
    }
    for (const BloomTap& tap : corners(0.5F, 2.0F / 12)) {
        up.push_back(tap);
    }
    for (const auto& [x, y] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
        up.push_back({static_cast<float>(x), static_cast<float>(y), 1.0F / 12});
    }

    Planner planner(picture, settings);
    std::vector<int> levels;
    int image = BloomPlan::picture_image;
    for (int i = halvings(picture, settings, 34); i > 0; --i) {
        levels.push_back(image = planner.halve(image, down));
    }
    for (std::size_t i = levels.size() - 1; i > 0; --i) {
        image = planner.enlarge(image, up, levels[i - 1], 0);
    }
    planner.finish(image, 0.5F, up);
    return planner.take();
}

// Jimenez 2014, "Next generation post processing in Call of Duty: Advanced Warfare". Five boxes of
// four taps, of which nine places are shared; written out by box for the Karis average, which
// keeps single bright texels from flickering and costs the conservation of energy.
std::vector<BloomTap> jimenez_down() {
    std::vector<BloomTap> taps;
    for (const BloomTap& tap : corners(1, 0.5F / 4)) {
        taps.push_back(tap);
    }
    for (const BloomTap& centre : corners(1, 0.125F)) {
        for (const BloomTap& tap : corners(1, centre.weight / 4)) {
            taps.push_back({centre.x + tap.x, centre.y + tap.y, tap.weight});
        }
    }
    return taps;
}

std::vector<BloomTap> merged(const std::vector<BloomTap>& taps) {
    std::map<std::pair<float, float>, float> weights;
    for (const BloomTap& tap : taps) {
        weights[{tap.y, tap.x}] += tap.weight;
    }
    std::vector<BloomTap> out;
    for (const auto& [place, weight] : weights) {
        out.push_back({place.second, place.first, weight});
    }
    return out;
}

BloomPlan jimenez_plan(BloomExtent picture, const BloomSettings& settings) {
    constexpr float scatter = 0.7F;
    std::vector<BloomTap> tent;
    for (const int y : {-1, 0, 1}) {
        for (const int x : {-1, 0, 1}) {
            tent.push_back({static_cast<float>(x), static_cast<float>(y),
                            static_cast<float>((2 - std::abs(x)) * (2 - std::abs(y))) / 16});
        }
    }

    Planner planner(picture, settings);
    int image = planner.halve(BloomPlan::picture_image, jimenez_down(), true);
    std::vector<int> levels{image};
    const std::vector<BloomTap> down = merged(jimenez_down());
    for (int i = halvings(picture, settings, 17); i > 1; --i) {
        levels.push_back(image = planner.halve(image, down));
    }
    for (std::size_t i = levels.size() - 1; i > 0; --i) {
        image = planner.enlarge(image, tent, levels[i - 1], 1 - scatter);
    }
    planner.finish(image, 0.5F, tent);
    return planner.take();
}

BloomPlan no_plan(BloomExtent, const BloomSettings&) {
    return {};
}

constexpr std::array<Bloom, 5> bloom_rows{{
    {"glare", "sum of Gaussians, the eye's veiling glare", true, glare_share, glare_plan, glare},
    {"dual-kawase", "dual Kawase", true, 0.12F, dual_kawase_plan},
    {"jimenez", "Jimenez, 13 taps down and a tent up", false, 0.12F, jimenez_plan},
    {"gaussian", "one separable Gaussian", true, 0.12F, gaussian_plan, one},
    {"none", "no bloom", true, 0, no_plan},
}};

} // namespace

std::span<const Bloom> blooms() {
    return bloom_rows;
}

const Bloom* bloom_named(std::string_view name) {
    return lutlib::find_named(bloom_rows, name);
}

BloomPlan bloom_plan(const Bloom& bloom, BloomExtent picture, const BloomSettings& settings) {
    BloomSettings full = settings;
    if (full.strength < 0) {
        full.strength = bloom.strength;
    }
    full.strength = std::min(full.strength, 1.0F);
    return full.strength > 0 ? bloom.plan(picture, full) : BloomPlan{};
}

double bloom_share(double brightness, double threshold, double knee) {
    if (threshold <= 0) {
        return 1;
    }
    const double over = brightness - threshold;
    if (!(over > -knee)) {
        return 0;
    }
    const double soft = knee > 0 ? std::min(over + knee, 2 * knee) : 0;
    const double light = over < knee ? soft * soft / (4 * knee) : over;
    return light / brightness;
}

double bloom_onset(const BloomSettings& settings) {
    return std::max(0.0F, settings.threshold - std::min(settings.knee, settings.threshold));
}

std::vector<BloomTap> texel_taps(const std::vector<BloomTap>& taps) {
    std::map<std::pair<float, float>, float> weights;
    for (const BloomTap& tap : taps) {
        const float x = std::floor(tap.x - 0.5F), y = std::floor(tap.y - 0.5F);
        const float fx = tap.x - 0.5F - x, fy = tap.y - 0.5F - y;
        for (const auto& [dx, wx] : {std::pair{0.5F, 1 - fx}, std::pair{1.5F, fx}}) {
            for (const auto& [dy, wy] : {std::pair{0.5F, 1 - fy}, std::pair{1.5F, fy}}) {
                if (wx * wy > 0) {
                    weights[{y + dy, x + dx}] += wx * wy * tap.weight;
                }
            }
        }
    }
    std::vector<BloomTap> out;
    for (const auto& [place, weight] : weights) {
        out.push_back({place.second, place.first, weight});
    }
    return out;
}

std::vector<BloomTap> gaussian_taps(float sigma) {
    constexpr int most = 2 * (BloomPlan::max_taps - 1);
    const int radius = std::clamp(static_cast<int>(std::ceil(3.5F * sigma)), 1, most);
    std::vector<double> weights;
    double total = 0;
    for (int i = 0; i <= radius; ++i) {
        const double x = i / static_cast<double>(sigma);
        weights.push_back(std::exp(-0.5 * x * x));
        total += (i == 0 ? 1 : 2) * weights.back();
    }
    weights.push_back(0);
    std::vector<BloomTap> taps{{0, 0, static_cast<float>(weights[0] / total)}};
    for (std::size_t i = 1; i <= static_cast<std::size_t>(radius); i += 2) {
        const double pair = weights[i] + weights[i + 1];
        if (pair / total < 1e-9) {
            break;
        }
        // Most texture units know 8 bits of a fraction; a place that they have gives the same
        // picture everywhere.
        const double fraction = std::round(256 * weights[i + 1] / pair) / 256;
        taps.push_back({static_cast<float>(static_cast<double>(i) + fraction), 0,
                        static_cast<float>(pair / total)});
    }
    return taps;
}

} // namespace preview
