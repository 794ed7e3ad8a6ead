#include "lutlib/paint/find_bare.h"

#include "lutlib/paint/bare_places.h"

#include <algorithm>
#include <optional>

namespace lutlib {
namespace {

constexpr int smallest = 8, largest = 65;
// Of orientation and ownership (recognise.h), 1 at best.
constexpr double alike = 0.3, clearly_own = 0.3;

struct TurnedReading {
    Recognition reading;
    Turn turn;
    Lut3D lattice;
};

// The strip as its content shows it, in whatever turn.
std::optional<TurnedReading> shown(const Picture& strip, const BareSearch& search) {
    std::vector<TurnedReading> all;
    for (const Turn turn : all_turns()) {
        const Picture upright = turned(strip, turn);
        for (const Recognition& reading : recognise(upright)) {
            if (reading.rows > 1 || (search.layout && search.layout != reading.layout) ||
                (search.size && search.size != reading.size)) {
                continue;
            }
            Lut3D lattice = from_picture(upright, *reading.layout, reading.size);
            // Upside down a strip is Unity's: the same look, and no second answer.
            const bool known = std::any_of(all.begin(), all.end(), [&](const TurnedReading& other) {
                return other.lattice == lattice;
            });
            if (!known) {
                all.push_back({reading, turn, std::move(lattice)});
            }
        }
    }
    if (all.empty()) {
        return std::nullopt;
    }
    // Pictures are turned by 180 degrees as rarely as looks are negatives, but strips that an
    // artist pasted are neutral at first, and rise.
    const bool any_rises = std::any_of(all.begin(), all.end(), [](const TurnedReading& one) {
        return !one.reading.falls && one.reading.tones_agree;
    });
    std::vector<Recognition> readings;
    for (const TurnedReading& one : all) {
        if (!(any_rises && one.reading.falls)) {
            readings.push_back(one.reading);
        }
    }
    // Turned, some layouts are another's with the channels exchanged in turn, which leaves hues in
    // order: looks leave channels where they are.
    const std::vector<Recognition> of_all_turns = readings;
    std::erase_if(readings, [&](const Recognition& one) {
        return std::any_of(of_all_turns.begin(), of_all_turns.end(), [&](const Recognition& other) {
            return other.roughness <= 2 * one.roughness &&
                   other.orientation >= one.orientation - alike &&
                   other.ownership >= one.ownership + clearly_own;
        });
    });
    std::stable_sort(readings.begin(), readings.end(),
                     [](const auto& a, const auto& b) { return a.roughness < b.roughness; });
    const Recognition* best = shown_by_content(readings);
    if (!best && search.layout && !readings.empty()) {
        // Who names the layout says that it stands upright, too.
        const auto upright = std::find_if(all.begin(), all.end(), [](const TurnedReading& one) {
            return one.turn == Turn{} && one.reading.roughness < 0.25;
        });
        return upright == all.end() ? std::nullopt : std::optional(*upright);
    }
    if (!best) {
        return std::nullopt;
    }
    return *std::find_if(all.begin(), all.end(), [&](const TurnedReading& one) {
        return one.reading.layout == best->layout && one.reading.size == best->size &&
               one.reading.orientation == best->orientation &&
               one.reading.roughness == best->roughness && one.reading.falls == best->falls &&
               one.reading.ownership == best->ownership;
    });
}

// A rectangle of the picture that was turned by `before`, read as it shows itself.
std::optional<BareStrip> strip_at(const Picture& picture, PictureSize whole, Turn before, Pixel at,
                                  PictureSize size, const BareSearch& search) {
    const std::optional<TurnedReading> found = shown(cut(picture, at, size), search);
    if (!found) {
        return std::nullopt;
    }
    BareStrip out;
    out.layout = found->reading.layout;
    out.size = found->reading.size;
    out.extent = turned(size, found->turn);
    out.falls = found->reading.falls;
    // Turned before and then again: quarters add up, for only the second may mirror.
    out.turn = {(before.quarters + found->turn.quarters) % 4, found->turn.mirrored};
    out.may_be_negative = out.turn.quarters == 2 && !out.falls;
    const Pixel corner = before_turn({0, 0}, size, found->turn);
    out.at = after_turn({at.x + corner.x, at.y + corner.y}, turned(whole, before), found->turn);
    return out;
}

std::vector<BareShape> shapes_of(const BareSearch& search) {
    std::vector<BareShape> out;
    const int from = search.size ? search.size : smallest, to = search.size ? search.size : largest;
    for (int size = from; size <= to; ++size) {
        for (const Layout& layout : layouts()) {
            std::optional<PictureSize> picture = layout.picture(size);
            if (!picture || (search.layout && search.layout != &layout)) {
                continue;
            }
            if (picture->width < picture->height) {
                picture = PictureSize{picture->height, picture->width};
            }
            const BareShape shape{size, *picture};
            const bool has_folds = picture->width % size == 0 && picture->width >= 3 * size;
            if (has_folds && std::find(out.begin(), out.end(), shape) == out.end()) {
                out.push_back(shape);
            }
        }
    }
    return out;
}

struct RankedStrip {
    BarePlace place;
    BareStrip strip;
};

// Of the picture turned by a quarter or not.
void append_strips(const Picture& picture, bool quarter, const BareSearch& search,
                   std::vector<RankedStrip>& found) {
    const Turn before{quarter ? 1 : 0, false};
    const Picture held = turned(picture, before);
    const ColumnSteps steps(held);
    for (const BareShape& shape : shapes_of(search)) {
        if (shape.picture.width > held.width || shape.picture.height > held.height) {
            continue;
        }
        for (const BarePlace& place : bare_places(held, steps, shape, quarter, picture.size())) {
            if (const auto strip =
                    strip_at(held, picture.size(), before, place.at, shape.picture, search)) {
                found.push_back({place, *strip});
            }
        }
    }
}

} // namespace

std::vector<BareStrip> find_bare(const Picture& picture, const BareSearch& search) {
    if (!recognise(picture).empty()) {
        if (const auto whole =
                strip_at(picture, picture.size(), {}, {0, 0}, picture.size(), search)) {
            return {*whole};
        }
    }
    std::vector<RankedStrip> found;
    append_strips(picture, false, search, found);
    append_strips(picture, true, search, found);
    std::stable_sort(found.begin(), found.end(), [](const RankedStrip& a, const RankedStrip& b) {
        return a.place.roughness < b.place.roughness;
    });
    std::vector<BarePlace> kept;
    std::vector<BareStrip> out;
    for (const RankedStrip& one : found) {
        if (std::none_of(kept.begin(), kept.end(), [&](const BarePlace& other) {
                return overlap(one.place, other, picture.size());
            })) {
            kept.push_back(one.place);
            out.push_back(one.strip);
        }
    }
    return out;
}

} // namespace lutlib
