#include "lutlib/verify/diagnose.h"

#include "lutlib/verify/lossy.h"
#include "lutlib/verify/mistakes.h"
#include "lutlib/verify/moved.h"
#include "lutlib/verify/palette.h"
#include "lutlib/verify/sampled.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace lutlib {
namespace {

// What most texels must agree with before a mistake is named.
constexpr double convincing = 0.98;
// And of those that are wrong without it.
constexpr double telling = 0.9;

constexpr Mistake none{.words = "nothing"};

// The look over the lattice that one set of inputs an axis makes, evaluated once for every mistake
// that has the same.
class Values {
  public:
    explicit Values(const Transform& look) : look_(look) {}

    /// Red fastest.
    const std::vector<RgbD>& over(const std::vector<double>& axis) {
        const auto [at, is_new] = known_.try_emplace(axis);
        std::vector<RgbD>& out = at->second;
        if (is_new) {
            out.reserve(axis.size() * axis.size() * axis.size());
            for (const double b : axis) {
                for (const double g : axis) {
                    for (const double r : axis) {
                        out.push_back({r, g, b});
                    }
                }
            }
            apply_in_parallel(look_, out);
        }
        return out;
    }

    double tolerance() const { return tolerance_of(look_.precision()); }

  private:
    const Transform& look_;
    std::map<std::vector<double>, std::vector<RgbD>> known_;
};

// Which texels agree with the look under a mistake.
struct Agreement {
    std::vector<bool> texels; ///< pixel by pixel
    double share = 0;
};

Agreement agreement(const CodeImage& picture, const Engine& engine, int n, const Mistake& mistake,
                    Values& values) {
    std::vector<double> axis;
    for (int i = 0; i < n; ++i) {
        axis.push_back(mistake.input(engine, i, n));
    }
    const std::vector<RgbD>& looked_up = values.over(axis);
    const auto input = [&axis](int i) { return axis[static_cast<std::size_t>(i)]; };
    const Layout& layout = *layout_named(engine.layout);
    Agreement out;
    out.texels.resize(picture.samples.size() / 3);
    std::size_t agreeing = 0, i = 0;
    for (int b = 0; b < n; ++b) {
        for (int g = 0; g < n; ++g) {
            for (int r = 0; r < n; ++r, ++i) {
                const Pixel p = mistake.pixel(layout, n, picture.width, r, g, b);
                const RgbD value = mistake.value({input(r), input(g), input(b)}, looked_up[i]);
                bool all = true;
                for (std::size_t c = 0; c < 3; ++c) {
                    all = all && mistake.agrees(picture.at(p, c), saturate(value[c]),
                                                picture.depth.maximum(), values.tolerance());
                }
                out.texels[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(picture.width) +
                           static_cast<std::size_t>(p.x)] = all;
                agreeing += all;
            }
        }
    }
    out.share = static_cast<double>(agreeing) / static_cast<double>(looked_up.size());
    return out;
}

// The lattice size of a picture of these dimensions in the engine's layout; 0: none.
int size_for(const Engine& engine, const CodeImage& picture) {
    return layout_named(engine.layout)->lattice({picture.width, picture.height}).value_or(0);
}

} // namespace

RightTexels right_texels(const CodeImage& picture, const Engine& engine, int size,
                         const Transform& look) {
    const Layout& layout = *layout_named(engine.layout);
    RightTexels out;
    for (int b = 0; b < size; ++b) {
        for (int g = 0; g < size; ++g) {
            for (int r = 0; r < size; ++r) {
                out.pixels.push_back(layout.pixel(size, picture.width, r, g, b));
                out.values.push_back({engine.node_input(r, size), engine.node_input(g, size),
                                      engine.node_input(b, size)});
            }
        }
    }
    apply_in_parallel(look, out.values);
    return out;
}

double tolerance_of(Precision precision) {
    // A single-precision evaluation is off by a few units in the last place of 1. A double one is
    // not, but pictures are made from values that were kept in floats on the way, which are off by
    // half a unit.
    return precision == Precision::float32 ? 1e-6 : 1e-7;
}

bool is_rounded(int code, double value, int maximum, double tolerance) {
    return std::abs(code - value * maximum) <= 0.5 + tolerance * maximum;
}

Findings diagnose(const CodeImage& picture, const Engine& engine, int size, const Transform& look,
                  const Breaks& breaks, const Alternatives& alternatives) {
    Values values(look);
    const Agreement plain = agreement(picture, engine, size, none, values);
    Findings out;
    out.nearest = {"the look as it is", plain.share};
    if (plain.share >= convincing) {
        out.nearest = {"single texels differ; the rest is right: the picture was edited or damaged "
                       "in places",
                       plain.share};
        out.diagnosis = out.nearest;
        return out;
    }
    double told = 0; // of the texels that are wrong as they are
    const auto offer = [&](std::string words, const Agreement& found) {
        if (!(found.share > out.nearest.explained)) {
            return;
        }
        std::size_t wrong = 0, explained = 0;
        for (std::size_t i = 0; i < plain.texels.size(); ++i) {
            wrong += !plain.texels[i];
            explained += !plain.texels[i] && found.texels[i];
        }
        out.nearest = {std::move(words), found.share};
        told = static_cast<double>(explained) / static_cast<double>(wrong);
    };
    for (const Mistake& mistake : mistakes()) {
        offer(std::string(mistake.words), agreement(picture, engine, size, mistake, values));
    }
    // Dimensions alone do not tell a layout: another one of the same may be what this is.
    for (const Engine& other : engines()) {
        const int n = size_for(other, picture);
        const bool same = other.layout == engine.layout && other.node_input == engine.node_input;
        if (n > 0 && !same) {
            offer("it is a picture for " + std::string(other.label) + ", of layout " +
                      std::string(other.layout),
                  agreement(picture, other, n, none, values));
        }
    }
    for (const Alternative& alternative :
         alternatives ? alternatives() : std::vector<Alternative>{}) {
        Values others(alternative.look);
        offer(alternative.words, agreement(picture, engine, size, none, others));
    }
    if (out.nearest.explained >= convincing && told >= telling) {
        out.diagnosis = out.nearest;
    } else if (const auto shift = shifted(picture, engine, size, look)) {
        out.diagnosis = *shift;
    } else if (const auto slices = slices_exchanged(picture, engine, size, look)) {
        out.diagnosis = *slices;
    } else if (const auto colors = few_colors(picture, engine, size, look)) {
        out.diagnosis = Diagnosis{*colors, 0};
    } else if (const auto sampled = sampling_between_nodes(picture, engine, size, look, breaks)) {
        out.diagnosis = Diagnosis{*sampled, 0};
    } else if (const auto noise = lossy_noise(picture, engine, size, look)) {
        out.diagnosis = Diagnosis{*noise, 0};
    }
    return out;
}

} // namespace lutlib
