#include "lutlib/engine/recognise.h"

#include "lutlib/engine/evidence.h"
#include "lutlib/error.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

// The figures below are chosen on the looks, sizes and layouts of the recogniser's test.

// A right reading stays below a tenth but for false colours and the smallest lattices; wrong ones
// begin at three tenths.
constexpr double roughest = 0.25;
// Steps get smaller with more nodes, the jumps of a wrong geometry only rarer.
constexpr double roughest_node = 4;
// A photograph is as smooth across the borders of tiles as within them, for 1 and less; a look
// begins anew behind each, for 4 to 100 and more.
constexpr double least_fold = 3;
// A reading rougher than the smoothest by this factor is of another geometry.
constexpr double other_geometry = 2.5;
constexpr double least_orientation = 0.1;
constexpr double clear_margin = 0.3;
// Below these a look has no hues to tell an order of.
constexpr double least_color = 0.03;
constexpr double least_hue_order = 0.1;
// Greys that gain colour this fast are not read along the grey axis.
constexpr double grey_axis_missed = 0.6;
constexpr double clearly_own = 0.1, overruling_own = 0.3;

// What a lattice of n nodes per axis cannot fall below while it moves at all: an identity's.
double roughness_of_identity(int n) {
    return 2.0 / ((n - 1.0) * (n + 1.0));
}

bool is_smooth(const Recognition& reading) {
    const double most = std::max(std::min(roughest, roughest_node / reading.size),
                                 1.5 * roughness_of_identity(reading.size));
    return reading.roughness <= most && reading.fold >= least_fold;
}

bool tones_agree(const Evidence& e) {
    const auto [low, high] = std::minmax_element(e.tone.begin(), e.tone.end());
    return *low > -tone_slack || *high < tone_slack;
}

// The mean squared step from the last node of a row of reds to the pixel right of it, against that
// between neighbouring nodes; in a vertical strip, from a slice's last row to the next slice.
double fold_of(const Picture& picture, const Layout& layout, Arrangement held, int row,
               double step) {
    const int n = held.size, top = picture.height / held.rows * row;
    const bool vertical = picture.width == n;
    double sum = 0, pairs = 0;
    for (int i = 0; i < n; ++i) {
        for (int b = 0; b < n; ++b) {
            const Pixel at = vertical ? layout.pixel(n, picture.width, i, n - 1, b)
                                      : layout.pixel(n, picture.width, n - 1, i, b);
            const Pixel next = vertical ? Pixel{at.x, at.y + 1} : Pixel{at.x + 1, at.y};
            if (next.x < picture.width && next.y + top < picture.height) {
                const RgbD jump =
                    to_double(picture.at(next.x, next.y + top) - picture.at(at.x, at.y + top));
                sum += jump.r * jump.r + jump.g * jump.g + jump.b * jump.b;
                ++pairs;
            }
        }
    }
    return pairs > 0 && step > 0 ? sum / pairs / step : 0;
}

Recognition read_as(const Picture& picture, const Layout& layout, Arrangement held) {
    Recognition out{.layout = &layout,
                    .size = held.size,
                    .rows = held.rows,
                    .roughness = 0,
                    .fold = HUGE_VAL,
                    .grey_drift = 0,
                    .orientation = 1,
                    .ownership = 0,
                    .tells_hues = false,
                    .tones_agree = true,
                    .falls = false};
    for (int row = 0; row < held.rows; ++row) {
        const Evidence e = evidence_of(from_picture(picture, layout, held.size, row));
        if (!(e.step > 0)) {
            continue; // one colour says nothing
        }
        const bool colored = e.color >= least_color;
        out.roughness = std::max(out.roughness, e.roughness);
        out.fold = std::min(out.fold, fold_of(picture, layout, held, row, e.step));
        out.ownership += e.ownership / held.rows;
        out.tones_agree = out.tones_agree && tones_agree(e);
        out.falls = out.falls || falls(e);
        out.tells_hues = out.tells_hues || (colored && std::abs(e.hue_order) >= least_hue_order);
        if (colored) {
            out.grey_drift = std::max(out.grey_drift, e.grey_drift);
            out.orientation = std::min(out.orientation, e.hue_order - e.grey_drift);
        }
    }
    if (out.fold == HUGE_VAL) {
        out.roughness = 1;
    }
    if (!out.tells_hues && out.orientation > 0) {
        out.orientation = 0;
    }
    return out;
}

// An ocio picture is a strip of a look with green and blue swapped, whose hues are mirrored. Looks
// that mirror hues (infrared's swapped channels) are as rare as such pictures of looks that turn
// them far, so that reading must also be nearer to a look that leaves channels where they are.
bool is_usual_enough(const Recognition& reading, std::span<const Recognition> readings) {
    return reading.layout->name != "ocio" ||
           std::all_of(readings.begin(), readings.end(), [&](const Recognition& other) {
               return &other == &reading || other.layout->name != "strip" ||
                      std::abs(reading.ownership) >= std::abs(other.ownership) + clearly_own;
           });
}

// The content shows one reading and speaks against another that something else names: another
// geometry, a grey axis that runs elsewhere, or channels that are not where they belong.
bool contradicts(const Recognition& shown, const Recognition& named) {
    return named.roughness > other_geometry * shown.roughness ||
           named.grey_drift >= grey_axis_missed ||
           std::abs(shown.ownership) >= std::abs(named.ownership) + overruling_own;
}

// A picture turned by 180 degrees, in any layout, and a strip that is mirrored hold the negative of
// their look, and nothing in them tells it from a look that is one.
std::string doubt_of(const Recognition& reading) {
    return reading.falls
               ? "it is read as a negative, in which brighter inputs become darker; if the look is "
                 "none, the picture was mirrored or turned by 180 degrees since it was made"
               : "";
}

std::string words_of(const Recognition& reading) {
    return std::string(reading.layout->name) + " of " + std::to_string(reading.size) + " nodes" +
           (reading.rows > 1 ? ", " + std::to_string(reading.rows) + " stacked" : "");
}

std::string listed(std::span<const Recognition> readings) {
    std::string out;
    for (const Recognition& reading : readings) {
        out += (out.empty() ? "" : "; ") + words_of(reading);
    }
    return out;
}

[[noreturn]] void refuse(const Picture& picture, std::span<const Recognition> readings,
                         const std::string& file) {
    const std::string extent =
        std::to_string(picture.width) + "x" + std::to_string(picture.height) + " pixels";
    if (readings.empty()) {
        throw Error("no LUT layout has " + extent +
                        "; strips are N*N x N or N x N*N, HALDs are square, tiles hold N slices of "
                        "N x N",
                    {file, 0, {}});
    }
    const bool any_smooth = std::any_of(readings.begin(), readings.end(), is_smooth);
    throw Error(
        (any_smooth ? "the content does not tell in which layout to read this picture"
                    : "this picture is not like a look in any layout of its dimensions: "
                      "neighbouring nodes differ as if they were shuffled") +
            std::string("; name it (lutconv's --layout), or the engine that it was made for "
                        "(--engine). It could be: ") +
            listed(readings),
        {file, 0, {}});
}

} // namespace

std::vector<Recognition> recognise(const Picture& picture) {
    std::vector<Recognition> out;
    for (const Layout& layout : layouts()) {
        if (const std::optional<Arrangement> held = arrangement_in(layout, picture.size())) {
            out.push_back(read_as(picture, layout, *held));
        }
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const auto& a, const auto& b) { return a.roughness < b.roughness; });
    return out;
}

const Recognition* shown_by_content(std::span<const Recognition> readings) {
    if (readings.empty() || !is_smooth(readings.front())) {
        return nullptr;
    }
    std::vector<const Recognition*> alike;
    for (const Recognition& reading : readings) {
        if (is_smooth(reading) &&
            reading.roughness <= other_geometry * readings.front().roughness) {
            alike.push_back(&reading);
        }
    }
    std::stable_sort(alike.begin(), alike.end(),
                     [](const auto* a, const auto* b) { return a->orientation > b->orientation; });
    const Recognition& best = *alike.front();
    const bool oriented = best.tells_hues && best.orientation >= least_orientation;
    if (alike.size() == 1) {
        // Nothing else has its geometry, so a look that has no hues need only not be upside down.
        return oriented || (!best.tells_hues && best.tones_agree) ? &best : nullptr;
    }
    return oriented && best.orientation >= alike[1]->orientation + clear_margin &&
                   is_usual_enough(best, readings)
               ? &best
               : nullptr;
}

Recognised recognise_one(const Picture& picture, const std::string& file, const LayoutHint& hint) {
    const std::vector<Recognition> readings = recognise(picture);
    const Recognition* const shown = shown_by_content(readings);
    const auto named =
        std::find_if(readings.begin(), readings.end(),
                     [&](const Recognition& reading) { return reading.layout == hint.layout; });
    if (named != readings.end() && (!shown || shown == &*named || !contradicts(*shown, *named))) {
        return {*named, {}, doubt_of(*named)};
    }
    if (!shown) {
        refuse(picture, readings, file);
    }
    Recognised out{*shown, {}, doubt_of(*shown)};
    if (named != readings.end()) {
        out.contradiction = hint.source + ", whose layout is " + std::string(hint.layout->name) +
                            ", but the content is laid out as " + std::string(shown->layout->name) +
                            " and was read so; --layout " + std::string(hint.layout->name) +
                            " reads it the other way";
    }
    return out;
}

} // namespace lutlib
