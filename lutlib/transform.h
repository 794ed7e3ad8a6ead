// A colour transform as a function on many colours at once, in double.
#pragma once

#include "lutlib/rgb.h"

#include <functional>
#include <span>
#include <utility>

namespace lutlib {

/// Replaces every colour by its image. May be called from several threads at once.
using Transform = std::function<void(std::span<RgbD>)>;

/// A transform that applies a function of one colour.
template <class F>
Transform each_colour(F f) {
    return [f = std::move(f)](std::span<RgbD> colours) {
        for (RgbD& c : colours) {
            c = f(c);
        }
    };
}

} // namespace lutlib
