// A look becomes the strip that an engine loads, in its codes: strip LOOK ENGINE STRIP.png
#include <lutlib/io/bake_report.h>
#include <lutlib/io/file.h>
#include <lutlib/io/look.h>
#include <lutlib/io/lut_picture.h>
#include <lutlib/named.h>

int main(int argc, char** argv) {
    if (argc != 4) {
        return 3;
    }
    const auto look = lutlib::io::Look::open(argv[1]);
    const auto& engine = lutlib::require_named(lutlib::engines(), "engine", argv[2]);
    const auto place = lutlib::io::place_in(engine, look.encodings());
    const auto strip = lutlib::bake(place.applied().around(look.exact()), engine,
                                    engine.default_size, engine.default_bits);
    lutlib::io::write_file(argv[3], lutlib::io::picture_bytes(
                                        strip, {.source = argv[1],
                                                .title = look.title(),
                                                .interpolation = name_of(look.interpolation())}));
}
