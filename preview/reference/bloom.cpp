#include "preview/reference/bloom.h"

namespace preview::reference {

namespace {

using lutlib::RgbD;

double largest(RgbD c) {
    return std::max({c.r, c.g, c.b});
}

RgbD fetch(const BloomPlan& plan, const BloomStep& step, const Image& from, int x, int y, double dx,
           double dy) {
    const double scale = static_cast<double>(step.scale);
    const RgbD light = from.sample(scale * (x + 0.5) + dx, scale * (y + 0.5) + dy);
    return step.prefilter ? prefiltered(plan, light) : light;
}

RgbD filter(const BloomPlan& plan, const BloomStep& step, const Image& from, int x, int y) {
    RgbD sum;
    double karis_total = 0;
    RgbD group;
    double group_weight = 0;
    for (std::size_t i = 0; i < step.taps.size(); ++i) {
        const BloomTap& tap = step.taps[i];
        const double w = static_cast<double>(tap.weight);
        const double a = static_cast<double>(tap.x), b = static_cast<double>(tap.y);
        if (step.axis == BloomStep::Axis::both) {
            const RgbD light = fetch(plan, step, from, x, y, a, b) * w;
            (step.karis ? group : sum) = (step.karis ? group : sum) + light;
        } else {
            const bool along_x = step.axis == BloomStep::Axis::x;
            sum = sum + fetch(plan, step, from, x, y, along_x ? a : 0, along_x ? 0 : a) * w;
            if (i > 0) {
                sum = sum + fetch(plan, step, from, x, y, along_x ? -a : 0, along_x ? 0 : -a) * w;
            }
        }
        if (!step.karis) {
            continue;
        }
        group_weight += w;
        if (i % 4 == 3) {
            const double mean = largest(group) / group_weight;
            sum = sum + group * (1 / (1 + mean));
            karis_total += group_weight / (1 + mean);
            group = {};
            group_weight = 0;
        }
    }
    return step.karis ? sum * (1 / karis_total) : sum;
}

} // namespace

RgbD prefiltered(const BloomPlan& plan, RgbD light) {
    return light * bloom_share(largest(light), static_cast<double>(plan.threshold),
                               static_cast<double>(plan.knee));
}

Image bloom(const BloomPlan& plan, const Image& hdr) {
    std::vector<Image> images;
    for (const BloomExtent& extent : plan.images) {
        images.emplace_back(extent.width, extent.height);
    }
    const auto image = [&](int i) -> const Image& {
        return i == BloomPlan::picture_image ? hdr : images[static_cast<std::size_t>(i)];
    };
    for (const BloomStep& step : plan.steps) {
        Image& target = images[static_cast<std::size_t>(step.target)];
        for (int y = 0; y < target.height; ++y) {
            for (int x = 0; x < target.width; ++x) {
                RgbD light = filter(plan, step, image(step.source), x, y);
                if (step.own >= 0) {
                    const double scale = static_cast<double>(step.own_scale);
                    light = light + image(step.own).sample(scale * (x + 0.5), scale * (y + 0.5)) *
                                        static_cast<double>(step.keep);
                }
                target.at(x, y) = light;
            }
        }
    }
    Image out(hdr.width, hdr.height);
    const Image& glow = image(plan.last.image);
    const double scale = static_cast<double>(plan.last.scale);
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            for (const BloomTap& tap : plan.last.taps) {
                out.at(x, y) =
                    out.at(x, y) + glow.sample(scale * (x + 0.5) + static_cast<double>(tap.x),
                                               scale * (y + 0.5) + static_cast<double>(tap.y)) *
                                       static_cast<double>(tap.weight);
            }
        }
    }
    return out;
}

Image with_bloom(const BloomPlan& plan, const Image& hdr) {
    Image out = plan.empty() ? hdr : bloom(plan, hdr);
    if (plan.empty()) {
        return out;
    }
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        const RgbD light = hdr.pixels[i];
        out.pixels[i] =
            light + (out.pixels[i] - prefiltered(plan, light)) * static_cast<double>(plan.strength);
    }
    return out;
}

} // namespace preview::reference
