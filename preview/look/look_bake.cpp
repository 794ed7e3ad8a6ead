#include "preview/look/look_bake.h"

#include "lutlib/bake/bake.h"
#include "lutlib/engine/layout.h"
#include "lutlib/named.h"
#include "lutlib/resample/simplify.h"

#include <algorithm>
#include <cmath>

namespace preview {

namespace {

using lutlib::CodeImage;
using lutlib::Lut;
using lutlib::Lut3D;

constexpr int general_bits = 16; ///< of pictures that no engine's contract fixes

/// The largest distance of a look from doing nothing. Both are interpolated between the same
/// nodes, so it is found at the nodes. Infinite where a shaper or a domain is in the way.
double distance_from_identity(const Lut& look) {
    if (look.shaper || !look.cube || !look.cube->domain.is_unit()) {
        return HUGE_VAL;
    }
    const Lut3D& cube = *look.cube;
    double furthest = 0;
    for (int b = 0; b < cube.size; ++b) {
        for (int g = 0; g < cube.size; ++g) {
            for (int r = 0; r < cube.size; ++r) {
                const lutlib::RgbD at = lutlib::node_position(cube, r, g, b);
                const lutlib::Rgb node = cube.at(r, g, b);
                for (std::size_t c = 0; c < 3; ++c) {
                    const double distance = std::abs(static_cast<double>(node[c]) - at[c]);
                    if (std::isnan(distance)) {
                        return HUGE_VAL;
                    }
                    furthest = std::max(furthest, distance);
                }
            }
        }
    }
    return furthest;
}

} // namespace

std::string skip_reason_of(const Lut& look) {
    // Half a code of 8 bits; a baked identity is as far as its own rounding.
    constexpr double half_code = 0.5 / 255 + 1e-7;
    return distance_from_identity(look) <= half_code ? "it changes less than half an output code"
                                                     : "";
}

namespace {

/// Nodes of a picture that no engine's contract fixes.
int general_size(const Lut& look, const GpuLookup& lookup) {
    constexpr int shared_size = 16;
    constexpr int without_cube = 33;
    if (lookup.shared()) {
        return shared_size;
    }
    return look.cube ? look.cube->size : without_cube;
}

/// A look as a picture for a lookup of that layout which no engine's contract describes.
CodeImage general_codes(const lutlib::Transform& exact, int size, const GpuLookup& lookup) {
    Lut3D sampled = lutlib::identity_cube(size);
    const std::vector<lutlib::RgbD> values = images_of(exact, sampled.nodes);
    std::transform(values.begin(), values.end(), sampled.nodes.begin(), lutlib::to_float);
    const lutlib::Picture picture =
        lutlib::to_picture(sampled, *lutlib::layout_named(lookup.layout));
    CodeImage codes{picture.width, picture.height, 3, {lookup.shared() ? 8 : general_bits}, {}};
    for (const lutlib::Rgb& pixel : picture.pixels) {
        for (std::size_t c = 0; c < 3; ++c) {
            codes.samples.push_back(codes.depth.code(pixel[c]));
        }
    }
    return codes;
}

} // namespace

Lut without_lattice(Lut look, const GpuLookup& lookup) {
    constexpr double tolerance = 1e-6;
    if (!lookup.filtered && lookup.interpolation != lutlib::Interpolation::nearest) {
        lutlib::find_named(lutlib::simplify_rules(), "separable")->apply(look, tolerance);
    }
    return look;
}

void set_standing(LoadedLook& look, const LookStanding& standing) {
    look.data.conversion = standing.conversion;
    look.shown = standing.shown;
    if (standing.conversion && look.table) {
        look.skip_reason.clear();
    }
}

LoadedLook no_look_of(const PictureCodes& picture) {
    LoadedLook look{no_look(), "there is none", {}, nullptr};
    look.shown = picture.encoding;
    return look;
}

std::shared_ptr<const Lut> table_of(const lutlib::Bake& baked) {
    Lut look;
    look.cube = lutlib::from_picture(lutlib::decoded(baked.picture),
                                     *lutlib::layout_named(baked.engine->layout), baked.size);
    return std::make_shared<const Lut>(std::move(look));
}

LoadedLook look_for(std::shared_ptr<const Lut> table, const lutlib::Transform& exact,
                    const GpuLookup& lookup) {
    LoadedLook out;
    out.skip_reason = skip_reason_of(*table);
    if (lookup.source == GpuLookup::Source::table) {
        out.data = look_data(without_lattice(*table, lookup), lookup);
    } else if (lookup.engine != nullptr) {
        const lutlib::Bake baked = lutlib::bake(exact, *lookup.engine, lookup.engine->default_size,
                                                lookup.engine->default_bits);
        out.data = look_data(baked.picture, baked.size, lookup);
        table = table_of(baked);
    } else {
        const int size = general_size(*table, lookup);
        out.data = look_data(general_codes(exact, size, lookup), size, lookup);
    }
    out.table = std::move(table);
    return out;
}

LoadedLook look_for(std::shared_ptr<const Lut> table, const GpuLookup& lookup) {
    const lutlib::Transform exact = lutlib::Transform::of(table);
    return look_for(std::move(table), exact, lookup);
}

LoadedLook look_for(Lut table, const GpuLookup& lookup) {
    return look_for(std::make_shared<const Lut>(std::move(table)), lookup);
}

const GpuLookup& table_lookup(const Lut& look) {
    return *gpu_lookup_named(lutlib::name_of(lutlib::usual_interpolation(look)));
}

} // namespace preview
