// lutconv identity: a LUT that changes nothing, as a file of any kind or an engine's picture.
#include "converter/command.h"
#include "converter/options.h"
#include "converter/usage.h"
#include "lutlib/bake/bake.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/lut_picture.h"

#include <memory>

namespace converter {
namespace {

struct Options {
    std::string output;
    EngineOption engine;
    int size = 0, bits = 0;
};

constexpr int usual_size = 33;

std::string bytes_of(const Options& o) {
    if (lutlib::io::extension_of(o.output) == "png" || o.engine.given()) {
        require_png_name(o.output, "--engine");
        const lutlib::Engine& engine =
            o.engine.given() ? o.engine.get() : *lutlib::engine_named("piccolo");
        const lutlib::Bake picture = lutlib::bake({}, engine, o.size ? o.size : engine.default_size,
                                                  o.bits ? o.bits : engine.default_bits);
        return lutlib::io::picture_bytes(picture, {"identity", "Identity", {}});
    }
    if (o.bits) {
        throw lutlib::UsageError("--bits is for pictures: give -o a .png name, or add --engine");
    }
    lutlib::Lut lut;
    lut.cube = lutlib::identity_cube(o.size ? o.size : usual_size);
    lut.title = "Identity";
    return lutlib::io::encode_lut(lut, lutlib::io::format_for_writing(o.output, lut)).bytes;
}

} // namespace

Run declare_identity(Verb& verb) {
    const auto o = std::make_shared<Options>();
    verb.add_option("-o,--output", o->output,
                    "a LUT file of any extension, or - for a .cube to standard output")
        .required();
    verb.add_option("--size", o->size,
                    "lattice size: nodes per axis (default: the engine's, or 33)")
        .takes(Takes::cube_size);
    verb.add_option("--bits", o->bits, "bits per sample of a picture: 8 or 16")
        .takes(Takes::picture_bits);
    o->engine.declare(verb, "");
    return [o] {
        lutlib::io::write_file(o->output, bytes_of(*o));
        return static_cast<int>(ok);
    };
}

} // namespace converter
