#include "preview/editor/knots.h"

#include <algorithm>
#include <cmath>

namespace preview::editor {

namespace {

using lutlib::Knot;
using lutlib::Knots;
using lutlib::Parameter;

constexpr double neighbourhood = 60; // degrees on which a first knot of a hue curve acts
constexpr double gap_share = 1e-3;   // of the axis, between neighbours

double neutral_at(const Parameter& parameter, double x) {
    return parameter.axis.diagonal ? x : parameter.fallback;
}

bool is_neutral(const Parameter& parameter, const Knots& knots) {
    return std::all_of(knots.begin(), knots.end(), [&](const Knot& knot) {
        return std::abs(knot.y - neutral_at(parameter, knot.x)) < 1e-12;
    });
}

double wrapped(double x, const lutlib::CurveAxis& axis) {
    const double period = axis.max - axis.min;
    return x - period * std::floor((x - axis.min) / period);
}

std::size_t insert(Knots& knots, Knot knot) {
    const auto place =
        std::upper_bound(knots.begin(), knots.end(), knot,
                         [](const Knot& value, const Knot& other) { return value.x < other.x; });
    const auto added = knots.insert(place, knot);
    return static_cast<std::size_t>(added - knots.begin());
}

// Both ends of a periodic axis are one place: a knot at the other end follows.
void join_ends(const lutlib::CurveAxis& axis, Knots& knots, std::size_t index) {
    const auto at_end = [&axis](const Knot& knot) {
        return knot.x == axis.min || knot.x == axis.max;
    };
    if (!axis.periodic || !at_end(knots[index])) {
        return;
    }
    for (Knot& knot : knots) {
        knot.y = at_end(knot) ? knots[index].y : knot.y;
    }
}

Knot held(const Parameter& parameter, Knot knot) {
    return {std::clamp(knot.x, parameter.axis.min, parameter.axis.max),
            std::clamp(knot.y, parameter.min, parameter.max)};
}

} // namespace

CurveView view_of(const Parameter& parameter, const Knots& knots) {
    CurveView view;
    view.x_min = parameter.axis.min;
    view.x_max = parameter.axis.max;
    if (!parameter.axis.periodic) {
        view.x_min = std::max(view.x_min, 0.0);
        view.x_max = std::min(view.x_max, 1.0);
    }
    if (parameter.axis.diagonal) {
        view.y_min = view.x_min;
        view.y_max = view.x_max;
    } else {
        const double reach =
            std::min(parameter.fallback - parameter.min, parameter.max - parameter.fallback);
        view.y_min = parameter.fallback - (reach > 0 ? reach : parameter.max - parameter.fallback);
        view.y_max = parameter.fallback + (reach > 0 ? reach : parameter.max - parameter.fallback);
    }
    for (const Knot& knot : knots) {
        view.x_min = std::min(view.x_min, knot.x);
        view.x_max = std::max(view.x_max, knot.x);
        view.y_min = std::min(view.y_min, knot.y);
        view.y_max = std::max(view.y_max, knot.y);
    }
    return view;
}

std::size_t add_knot(const Parameter& parameter, Knots& knots, Knot knot) {
    knot = held(parameter, knot);
    std::sort(knots.begin(), knots.end(), [](const Knot& a, const Knot& b) { return a.x < b.x; });
    if (knots.empty()) {
        if (parameter.axis.periodic) {
            for (const double away : {-neighbourhood, neighbourhood}) {
                insert(knots, {wrapped(knot.x + away, parameter.axis), parameter.fallback});
            }
        } else {
            const CurveView view = view_of(parameter, {});
            for (const double x : {view.x_min, view.x_max}) {
                insert(knots, {x, neutral_at(parameter, x)});
            }
        }
    }
    const double gap = gap_share * (parameter.axis.max - parameter.axis.min);
    const auto same = std::find_if(knots.begin(), knots.end(), [&](const Knot& other) {
        return std::abs(other.x - knot.x) < gap;
    });
    if (same != knots.end()) {
        same->y = knot.y;
    }
    const std::size_t index =
        same != knots.end() ? static_cast<std::size_t>(same - knots.begin()) : insert(knots, knot);
    join_ends(parameter.axis, knots, index);
    return index;
}

void move_knot(const Parameter& parameter, Knots& knots, std::size_t index, Knot to) {
    to = held(parameter, to);
    const double gap = gap_share * (parameter.axis.max - parameter.axis.min);
    const double low = index > 0 ? knots[index - 1].x + gap : parameter.axis.min;
    const double high = index + 1 < knots.size() ? knots[index + 1].x - gap : parameter.axis.max;
    to.x = low <= high ? std::clamp(to.x, low, high) : knots[index].x;
    knots[index] = to;
    join_ends(parameter.axis, knots, index);
}

void remove_knot(const Parameter& parameter, Knots& knots, std::size_t index) {
    knots.erase(knots.begin() + static_cast<std::ptrdiff_t>(index));
    if (is_neutral(parameter, knots)) {
        knots.clear();
    }
}

std::optional<std::size_t> knot_at(const CurveView& view, const Knots& knots, Knot at, Knot reach) {
    std::optional<std::size_t> nearest;
    double least = 1;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const double dx = (knots[i].x - at.x) / (view.x_max - view.x_min) / reach.x;
        const double dy = (knots[i].y - at.y) / (view.y_max - view.y_min) / reach.y;
        const double distance = std::hypot(dx, dy);
        if (distance <= least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

} // namespace preview::editor
