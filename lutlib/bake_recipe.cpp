#include "lutlib/bake_recipe.h"

#include "lutlib/edit.h"
#include "lutlib/error.h"
#include "lutlib/interpolation.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace lutlib {
namespace {

constexpr int usual_size = 33;
// Colours that stages pass to each other through the first-level cache.
constexpr std::size_t block = 512;

// Fills nodes with a transform of the colour at (x[r], x[g], x[b]), per channel.
using Axis = std::array<std::vector<double>, 3>;

std::vector<Rgb> sampled(const Axis& axis, const Transform& transform) {
    const std::size_t n = axis[0].size();
    std::vector<Rgb> nodes(n * n * n);
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, nodes.size(), 4 * block), [&](const auto& range) {
            std::array<RgbD, block> colours;
            for (std::size_t first = range.begin(); first < range.end(); first += block) {
                const std::size_t count = std::min(block, range.end() - first);
                for (std::size_t i = 0; i < count; ++i) {
                    const std::size_t k = first + i;
                    colours[i] = {axis[0][k % n], axis[1][k / n % n], axis[2][k / (n * n)]};
                }
                transform(std::span(colours).first(count));
                for (std::size_t i = 0; i < count; ++i) {
                    nodes[first + i] = to_float(colours[i]);
                }
            }
        });
    return nodes;
}

double between(float min, float max, int i, int size) {
    return static_cast<double>(min) +
           (static_cast<double>(max) - static_cast<double>(min)) * i / (size - 1);
}

Axis even_axis(const Domain& domain, int size) {
    Axis axis;
    for (std::size_t c = 0; c < 3; ++c) {
        for (int i = 0; i < size; ++i) {
            axis[c].push_back(between(domain.min[c], domain.max[c], i, size));
        }
    }
    return axis;
}

// Where a rising table reaches each of `size` even steps from 0 to 1.
Axis inverted_axis(const Lut1D& table, int size) {
    Axis axis;
    for (std::size_t c = 0; c < 3; ++c) {
        std::size_t k = 0;
        for (int i = 0; i < size; ++i) {
            const double wanted = static_cast<double>(i) / (size - 1);
            while (k + 2 < table.entries.size() &&
                   static_cast<double>(table.entries[k + 1][c]) < wanted) {
                ++k;
            }
            const double low = table.entries[k][c], high = table.entries[k + 1][c];
            const double t = std::clamp((wanted - low) / (high - low), 0.0, 1.0);
            const double step = 1.0 / (table.size() - 1);
            const double width =
                static_cast<double>(table.domain.max[c]) - static_cast<double>(table.domain.min[c]);
            axis[c].push_back(static_cast<double>(table.domain.min[c]) +
                              (static_cast<double>(k) + t) * step * width);
        }
    }
    return axis;
}

// A table of the given rising function of each channel, scaled to 0..1.
Lut1D make_shaper(const Domain& domain, int size,
                  const std::function<double(double, std::size_t)>& f) {
    Lut1D table{domain, std::vector<Rgb>(static_cast<std::size_t>(size))};
    for (std::size_t c = 0; c < 3; ++c) {
        const double low = f(domain.min[c], c), high = f(domain.max[c], c);
        for (int i = 0; i < size; ++i) {
            const double y =
                (f(between(domain.min[c], domain.max[c], i, size), c) - low) / (high - low);
            table.entries[static_cast<std::size_t>(i)][c] = static_cast<float>(y);
        }
        for (std::size_t i = 0; i + 1 < table.entries.size(); ++i) {
            if (!(table.entries[i][c] < table.entries[i + 1][c])) {
                throw Error("the shaper does not rise over the whole domain; choose another "
                            "domain, fewer shaper entries, or no shaper");
            }
        }
    }
    return table;
}

Lut1D tone_shaper(const Edit& edit, const Domain& domain, int size) {
    const auto n = static_cast<std::size_t>(size);
    std::vector<RgbD> neutrals(n);
    for (int i = 0; i < size; ++i) {
        const std::size_t k = static_cast<std::size_t>(i);
        for (std::size_t c = 0; c < 3; ++c) {
            neutrals[k][c] = between(domain.min[c], domain.max[c], i, size);
        }
    }
    edit(neutrals);
    // The mean of the channels, which must not fall.
    std::vector<double> rise(n);
    double highest = -INFINITY;
    for (std::size_t i = 0; i < n; ++i) {
        highest = std::max(highest, (neutrals[i].r + neutrals[i].g + neutrals[i].b) / 3);
        rise[i] = highest;
    }
    const double span = rise.back() - rise.front();
    Lut1D table{domain, {}};
    for (std::size_t i = 0; i < n; ++i) {
        const double line = static_cast<double>(i) / static_cast<double>(n - 1);
        const double tone = span > 0 ? (rise[i] - rise.front()) / span : line;
        const auto y = static_cast<float>((tone + line) / 2);
        table.entries.push_back({y, y, y});
    }
    return table;
}

// The base's table as it is, and a cube over whatever the table can give.
void bake_after_base_shaper(const Recipe& recipe, const Edit& edit, Lut& out) {
    if (!recipe.base_lut || !recipe.base_lut->shaper) {
        throw Error("the shaper is to be the base's, but the recipe has no base with one");
    }
    const Lut& base = *recipe.base_lut;
    out.shaper = base.shaper;
    Domain domain;
    if (base.cube) {
        domain = base.cube->domain;
    } else {
        for (std::size_t c = 0; c < 3; ++c) {
            const auto [low, high] =
                std::minmax_element(base.shaper->entries.begin(), base.shaper->entries.end(),
                                    [c](const Rgb& a, const Rgb& b) { return a[c] < b[c]; });
            domain.min[c] = (*low)[c];
            domain.max[c] = std::max((*high)[c], std::nextafter((*low)[c], INFINITY));
        }
    }
    const int size = recipe.bake.size.value_or(base.cube ? base.cube->size : usual_size);
    const Transform after_shaper = [&](std::span<RgbD> colours) {
        if (base.cube) {
            for (RgbD& c : colours) {
                c = evaluate_exact(*base.cube, c, Interpolation::tetrahedral);
            }
        }
        edit.after_base(colours);
    };
    out.cube = Lut3D{domain, size, sampled(even_axis(domain, size), after_shaper)};
}

} // namespace

Lut bake_recipe(const Recipe& recipe) {
    const Edit edit(recipe);
    const Lut* const base = recipe.base_lut.get();
    const BakeSettings& settings = recipe.bake;
    Lut out;
    out.title = recipe.title;
    const std::string shaper = !settings.shaper.empty()                   ? settings.shaper
                               : base && base->shaper && !settings.domain ? "base"
                                                                          : "none";
    if (shaper == "base") {
        bake_after_base_shaper(recipe, edit, out);
        return out;
    }
    const int size = settings.size.value_or(base && base->cube ? base->cube->size : usual_size);
    const Domain domain = settings.domain.value_or(base ? base->domain() : Domain{});
    check_cube_size(size);
    check_domain(domain);
    const Transform all = [&edit](std::span<RgbD> colours) { edit(colours); };
    if (shaper == "none") {
        out.cube = Lut3D{domain, size, sampled(even_axis(domain, size), all)};
        return out;
    }
    if (shaper == "tone") {
        out.shaper = tone_shaper(edit, domain, settings.shaper_size);
    } else {
        const Encoding* const encoding = encoding_named(shaper);
        if (!encoding) {
            throw Error("there is no shaper '" + shaper + "'");
        }
        out.shaper = make_shaper(domain, settings.shaper_size, [&](double x, std::size_t) {
            return encoding->encode(recipe.input->decode(x));
        });
    }
    out.cube = Lut3D{{}, size, sampled(inverted_axis(*out.shaper, size), all)};
    return out;
}

} // namespace lutlib
