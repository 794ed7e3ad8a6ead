#include "lutlib/io/bake_report.h"

#include "lutlib/metrics/samples.h"

#include <fmt/format.h>

#include <algorithm>

namespace lutlib::io {

namespace {

constexpr SampleCounts quick_samples{.neutral = 256, .random = 2048, .lattice = false};

} // namespace

std::string figures_text(const ErrorStats& stats) {
    return fmt::format("max {:.4g}, p99 {:.4g}, p95 {:.4g}, mean {:.4g}", stats.max, stats.p99,
                       stats.p95, stats.mean);
}

std::string domain_text(const Domain& domain) {
    const auto channel = [&](std::size_t c) {
        return fmt::format("{:.6g}..{:.6g}", domain.min[c], domain.max[c]);
    };
    const std::string r = channel(0), g = channel(1), b = channel(2);
    return r == g && g == b ? r : r + ", " + g + ", " + b;
}

double reachable_share(const Domain& domain) {
    double share = 1;
    for (std::size_t c = 0; c < 3; ++c) {
        const double low = std::max(0.0, static_cast<double>(domain.min[c]));
        const double high = std::min(1.0, static_cast<double>(domain.max[c]));
        const double width =
            static_cast<double>(domain.max[c]) - static_cast<double>(domain.min[c]);
        share = std::min(share, std::max(0.0, high - low) / width);
    }
    return share;
}

double clamped_share(const Domain& domain) {
    double share = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const double low = std::clamp(static_cast<double>(domain.min[c]), 0.0, 1.0);
        const double high = std::clamp(static_cast<double>(domain.max[c]), 0.0, 1.0);
        share = std::max(share, 1 - (high - low));
    }
    return share;
}

LookupError measure_bake(const Bake& bake, const Transform& look) {
    const std::vector<Rgb> inputs = sample_colors(bake.size, quick_samples);
    return lookup_error(*bake.engine, decoded(bake.picture), bake.size, inputs,
                        images_of(look, inputs));
}

std::string bake_report(const std::string& input, const std::string& output, const Bake& bake,
                        const Domain& domain, const LookupError& error) {
    const Engine& engine = *bake.engine;
    std::string out = fmt::format(
        "{} -> {}\n  {}x{} pixels, {} nodes per axis, {} bits, layout {}, {} sRGB tag: {}\n", input,
        output, bake.picture.width, bake.picture.height, bake.size, bake.picture.depth.bits,
        engine.layout, engine.srgb_tag == SrgbTag::present ? "with" : "no", engine.label);
    out += fmt::format("  input: {}\n  import: {}\n", engine.input, engine.import);
    const auto values = static_cast<std::size_t>(bake.size) * static_cast<std::size_t>(bake.size) *
                        static_cast<std::size_t>(bake.size) * 3;
    if (bake.loss.clamped_values > 0) {
        out += fmt::format("  lost: {} of {} values lie outside 0..1 and were clamped, by {:.4g} "
                           "at most\n",
                           bake.loss.clamped_values, values, bake.loss.most_clamped);
    }
    if (reachable_share(domain) < 1) {
        out += fmt::format("  lost: the engine reaches {:.3g} % of the look's input domain "
                           "({}); it feeds 0..1\n",
                           100 * reachable_share(domain), domain_text(domain));
    }
    if (clamped_share(domain) > 0) {
        out += fmt::format("  lost: {:.3g} % of the engine's inputs lie outside the look's domain "
                           "({}) and are clamped to it\n",
                           100 * clamped_share(domain), domain_text(domain));
    }
    if (bake.loss.max_rounding > 0) {
        out +=
            fmt::format("  lost: rounding to {} bits, max {:.4g}, mean {:.4g}\n",
                        bake.picture.depth.bits, bake.loss.max_rounding, bake.loss.mean_rounding);
    }
    out += fmt::format("  error of {}'s lookup against the look, {} colours: {}\n", engine.name,
                       error.absolute.count, figures_text(error.absolute));
    out += fmt::format("  as dE2000: {}\n", figures_text(error.delta_e));
    return out;
}

} // namespace lutlib::io
