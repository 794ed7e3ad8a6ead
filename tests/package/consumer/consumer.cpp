// Bakes, verifies, has OpenColorIO read a .3dl, and applies a look to a buffer; consumer LOOK
// FOLDER.
#include <lutlib/bake/bake.h>
#include <lutlib/error.h>
#include <lutlib/interpolation/grade.h>
#include <lutlib/io/file.h>
#include <lutlib/io/formats.h>
#include <lutlib/io/look.h>
#include <lutlib/io/lut_picture.h>
#include <lutlib/verify/verify.h>
#include <lutlib/version.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

void require(bool holds, const char* what) {
    std::printf("%s: %s\n", holds ? "ok" : "WRONG", what);
    if (!holds) {
        std::exit(1);
    }
}

// What -Wconversion with -Werror would not let pass.
float narrowed(double value) {
    return value;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        return 3;
    }
    const std::string folder = argv[2];
    try {
        const auto look = lutlib::io::Look::open(argv[1]);
        const lutlib::Engine& unity = *lutlib::engine_named("unity");
        const lutlib::Bake strip = lutlib::bake(look.exact(), unity, 16, 8);
        lutlib::io::write_file(folder + "/strip.png", lutlib::io::picture_bytes(strip, {}));

        const auto back = lutlib::io::Look::open(folder + "/strip.png", {.engine = &unity});
        const lutlib::Verification proof =
            lutlib::verify(back.picture()->codes, unity, 16, look.exact(), look.breaks(), {});
        require(proof.texels.wrong == 0, "the strip that was baked is verified");
        const lutlib::Verification other = lutlib::verify(back.picture()->codes, unity, 16,
                                                          lutlib::Transform(), look.breaks(), {});
        require(other.texels.wrong > 0, "and is not the identity's");

        lutlib::io::write_lut(folder + "/look.3dl", *look.table().lut);
        const auto threedl = lutlib::io::Look::open(folder + "/look.3dl");
        const auto reference = threedl.reference(threedl.interpolation());
        std::printf("%s %s\n", reference.name.c_str(), reference.refusal.c_str());
        require(reference.name.find("OpenColorIO") == 0 && reference.refusal.empty(),
                "OpenColorIO reads the .3dl itself");
        const lutlib::RgbD in{0.2, 0.5, 0.7}, ours = threedl.exact()(in),
                                              theirs = reference.look(in);
        require(std::fabs(ours.r - theirs.r) < 1e-5 && std::fabs(ours.g - theirs.g) < 1e-5 &&
                    std::fabs(ours.b - theirs.b) < 1e-5,
                "and agrees with lutlib");

        float pixel[3] = {narrowed(0.2), narrowed(0.5), narrowed(0.7)};
        const auto view = lutlib::interleaved(pixel, lutlib::Element::float32, 3, 1, 1);
        grade(lutlib::Grading(*look.table().lut), view, view);
        const lutlib::RgbD exact = look.exact()({0.2F, 0.5F, 0.7F});
        require(std::fabs(pixel[0] - exact.r) < 1e-6 && std::fabs(pixel[1] - exact.g) < 1e-6 &&
                    std::fabs(pixel[2] - exact.b) < 1e-6,
                "a buffer is graded where it lies");
    } catch (const lutlib::Error& error) {
        std::fprintf(stderr, "consumer: %s\n", error.what());
        return 2;
    }
}
