#include "preview/look_file.h"

#include "lutlib/bake.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/io/png.h"
#include "lutlib/recognise.h"

#include <algorithm>
#include <cmath>

namespace preview {

namespace {

using lutlib::CodePicture;
using lutlib::Lut;
using lutlib::Lut3D;

constexpr int general_bits = 16; ///< of pictures that no engine's contract fixes

/// The largest distance of a look from doing nothing. Both are interpolated between the same
/// nodes, so it is found at the nodes. Infinite where a shaper or a domain is in the way.
double distance_from_identity(const Lut& look) {
    if (look.shaper || !look.cube || !look.cube->domain.is_unit())
        return HUGE_VAL;
    const Lut3D& cube = *look.cube;
    double furthest = 0;
    for (int b = 0; b < cube.size; ++b)
        for (int g = 0; g < cube.size; ++g)
            for (int r = 0; r < cube.size; ++r) {
                const lutlib::RgbD at = lutlib::node_position(cube, r, g, b);
                const lutlib::Rgb node = cube.at(r, g, b);
                for (std::size_t c = 0; c < 3; ++c) {
                    const double distance = std::abs(static_cast<double>(node[c]) - at[c]);
                    if (!(distance <= furthest))
                        furthest = distance;
                }
            }
    return furthest;
}

std::string skip_reason_of(const Lut& look) {
    // Half a code of 8 bits; a baked identity is as far as its own rounding.
    constexpr double half_code = 0.5 / 255 + 1e-7;
    return distance_from_identity(look) <= half_code ? "it changes less than half an output code"
                                                     : "";
}

/// A look as a picture for a lookup of that layout which no engine's contract describes.
CodePicture general_codes(const Lut& look, const Lookup& lookup) {
    const int size = lookup.shared ? 16 : look.cube ? look.cube->size : 33;
    Lut3D sampled = lutlib::identity_cube(size);
    for (lutlib::Rgb& node : sampled.nodes)
        node = lutlib::to_float(lutlib::evaluate_exact(look, lutlib::to_double(node)));
    const lutlib::Picture picture =
        lutlib::to_picture(sampled, *lutlib::layout_named(lookup.layout));
    CodePicture codes{picture.width, picture.height, lookup.shared ? 8 : general_bits, {}};
    for (const lutlib::Rgb& pixel : picture.pixels)
        for (std::size_t c = 0; c < 3; ++c) {
            const float value = pixel[c] > 0 ? std::min(pixel[c], 1.0F) : 0.0F;
            codes.codes.push_back(static_cast<std::uint16_t>(
                std::lround(value * static_cast<float>(codes.maximum()))));
        }
    return codes;
}

LoadedLook from_look(const Lut& look, const Lookup& lookup) {
    LoadedLook out;
    out.skip_reason = skip_reason_of(look);
    if (lookup.source == Lookup::Source::table) {
        out.data = look_data(look, lookup);
    } else if (lookup.engine != nullptr) {
        const auto exact = [&](lutlib::RgbD in) { return lutlib::evaluate_exact(look, in); };
        const lutlib::Bake baked = lutlib::bake(exact, *lookup.engine, lookup.engine->default_size,
                                                lookup.engine->default_bits);
        out.data = look_data(baked.picture, baked.size, lookup);
    } else {
        const CodePicture codes = general_codes(look, lookup);
        const int size = lookup.shared ? 16 : look.cube ? look.cube->size : 33;
        out.data = look_data(codes, size, lookup);
    }
    return out;
}

LoadedLook from_picture_file(const std::string& bytes, const std::string& path,
                             const Lookup* lookup) {
    const CodePicture codes = lutlib::io::code_picture(lutlib::io::read_png(bytes, path));
    const lutlib::Picture picture = lutlib::decoded(codes);
    const lutlib::Recognition found = lutlib::recognise_one(picture, path);
    Lut look;
    look.cube = lutlib::from_picture(picture, *found.layout, found.size);
    if (lookup == nullptr)
        lookup = lookup_named(found.layout->name == "strip" ? "strip" : "trilinear");
    if (lookup->source == Lookup::Source::table)
        return from_look(look, *lookup);
    if (found.layout->name != lookup->layout)
        throw lutlib::UsageError("the lookup '" + std::string(lookup->name) +
                                 "' reads pictures in the layout '" + std::string(lookup->layout) +
                                 "' and '" + path + "' is in '" + std::string(found.layout->name) +
                                 "': bake it with lutconv for that engine");
    LoadedLook out;
    out.skip_reason = lookup->engine == nullptr ? skip_reason_of(look) : "";
    out.data = look_data(codes, found.size, *lookup);
    return out;
}

} // namespace

LoadedLook load_look(const std::string& path, const Lookup* lookup) {
    if (path.empty() || path == "none")
        return {no_look(), "there is none"};
    const std::string bytes = lutlib::io::read_file(path);
    if (lutlib::io::is_png(bytes))
        return from_picture_file(bytes, path, lookup);
    const lutlib::io::Reading reading = lutlib::io::decode_lut(bytes, path);
    return from_look(reading.lut, lookup != nullptr ? *lookup : *lookup_named("tetrahedral"));
}

} // namespace preview
