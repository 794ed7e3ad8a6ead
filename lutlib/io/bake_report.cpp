#include "lutlib/io/bake_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace lutlib::io {

std::string figures_text(const ErrorStats& stats) {
    return fmt::format("p99 {:.4g}, mean {:.4g}, p95 {:.4g}; {} {:.4g}{}", stats.p99, stats.mean,
                       stats.p95, stats.largest_seen ? "largest seen" : "max", stats.max,
                       stats.at ? fmt::format(" at ({:.4g}, {:.4g}, {:.4g})", stats.at->r,
                                              stats.at->g, stats.at->b)
                                : "");
}

std::string domain_text(const Domain& domain) {
    const auto channel = [&](std::size_t c) {
        return fmt::format("{:.6g}..{:.6g}", domain.min[c], domain.max[c]);
    };
    const std::string r = channel(0), g = channel(1), b = channel(2);
    return r == g && g == b ? r : r + ", " + g + ", " + b;
}

namespace {

// The codes that a look gets of a lattice of 0..1.
std::vector<RgbD> fed_codes(const Placement& placement) {
    constexpr int lattice = 33;
    return images_of(conversion(*placement.before, *placement.adaptation),
                     identity_cube(lattice).nodes);
}

double share_outside(const std::vector<RgbD>& codes, std::size_t c, double low, double high) {
    const auto outside = std::count_if(codes.begin(), codes.end(), [&](const RgbD& code) {
        return code[c] < low || code[c] > high;
    });
    return static_cast<double>(outside) / static_cast<double>(codes.size());
}

} // namespace

Reach reach_of(const Domain& domain, const Placement& placement) {
    Reach out{domain, placement.fed()};
    const std::vector<RgbD> codes = placement.before ? fed_codes(placement) : std::vector<RgbD>{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double low = domain.min[c], high = domain.max[c];
        const double fed_low = std::clamp<double>(out.fed.min[c], low, high);
        const double fed_high = std::clamp<double>(out.fed.max[c], low, high);
        out.reached = std::min(out.reached, (fed_high - fed_low) / (high - low));
        out.clamped = std::max(out.clamped, codes.empty() ? 1 - (fed_high - fed_low)
                                                          : share_outside(codes, c, low, high));
    }
    return out;
}

LookPlace place_in(const Engine& engine, const LookEncodings& look, bool convert) {
    const std::optional<Encoding> codes = encoding_named(engine.encoding);
    return {look, codes, codes, convert};
}

Breaks placed(const Breaks& look, const Placement& placement) {
    if (!placement.before) {
        return look;
    }
    const auto& [from, to] = *placement.before;
    if (from.primaries() != to.primaries()) {
        return no_breaks();
    }
    Breaks out = look;
    out.all = false; // the curves bend between them
    for (std::vector<double>& channel : out.at) {
        for (double& x : channel) {
            x = from.encode(to.decode(x));
        }
    }
    return out;
}

Viewing viewing_of(const LookPlace& place, double reference_white) {
    return {place.shown().output.value_or(srgb()), reference_white};
}

std::string text_of(const Viewing& viewing) {
    return fmt::format("{}, reference white {:g} cd/m2{}", viewing.output.name(),
                       viewing.reference_white,
                       viewing.reference_white == reference_white_nits ? " (BT.2408)" : "");
}

std::string figures_text(const Difference& error, const Viewing& viewing,
                         const std::string& indent) {
    std::string out = fmt::format("{0}code values: {1}\n{0}dE2000: {2}\n", indent,
                                  figures_text(error.absolute), figures_text(error.delta_e_2000));
    if (is_hdr(viewing.output)) {
        out += fmt::format("{}dE-ITP: {}\n", indent, figures_text(error.delta_e_itp));
    }
    return out + fmt::format("{}as colours of {}\n", indent, text_of(viewing));
}

std::string bake_report(const std::string& input, const std::string& output, const Bake& bake,
                        const Domain& domain, const LookPlace& place,
                        const std::optional<Difference>& error, const Viewing& viewing) {
    const Engine& engine = *bake.engine;
    std::string out = fmt::format(
        "{} -> {}\n  {}x{} pixels, {} nodes per axis, {} bits, layout {}, {} sRGB tag: {}\n", input,
        output, bake.picture.width, bake.picture.height, bake.size, bake.picture.depth.bits,
        engine.layout, engine.srgb_tag == SrgbTag::present ? "with" : "no", engine.label);
    out += fmt::format("  input: {}\n  import: {}\n", engine.input, engine.import);
    if (const std::string encodings = sentence_of(place, engine.name); !encodings.empty()) {
        out += "  encodings: " + encodings + '\n';
    }
    const auto values = static_cast<std::size_t>(bake.size) * static_cast<std::size_t>(bake.size) *
                        static_cast<std::size_t>(bake.size) * 3;
    if (bake.loss.clamped_values > 0) {
        out += fmt::format("  lost: {} of {} values lie outside 0..1 and were clamped, by {:.4g} "
                           "at most\n",
                           bake.loss.clamped_values, values, bake.loss.most_clamped);
    }
    const Reach reach = reach_of(domain, place.applied());
    if (reach.reached < 1) {
        out +=
            fmt::format("  lost: the engine reaches {:.3g} % of the look's input domain ({}); it "
                        "feeds {}\n",
                        100 * reach.reached, domain_text(domain), domain_text(reach.fed));
    }
    if (reach.clamped > 0) {
        out += fmt::format("  lost: {:.3g} % of the engine's inputs lie outside the look's domain "
                           "({}) and are clamped to it\n",
                           100 * reach.clamped, domain_text(domain));
    }
    if (bake.loss.max_rounding > 0) {
        out +=
            fmt::format("  lost: rounding to {} bits, max {:.4g}, mean {:.4g}\n",
                        bake.picture.depth.bits, bake.loss.max_rounding, bake.loss.mean_rounding);
    }
    if (error) {
        out += fmt::format(
            "  error of {}'s lookup against the look{}; p99 and mean over {} colours "
            "spread evenly:\n{}",
            engine.name, bake.loss.clamped_values > 0 ? ", clamped to 0..1 as the codes are" : "",
            error->absolute.count, figures_text(*error, viewing, "    "));
    }
    return out;
}

} // namespace lutlib::io
