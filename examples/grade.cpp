// A picture in memory is graded where it lies, on every core: grade LOOK
#include <lutlib/error.h>
#include <lutlib/interpolation/grade.h>
#include <lutlib/io/look.h>

#include <cstdint>
#include <cstdio>
#include <vector>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("grade LOOK\n", stderr);
        return 3;
    }
    try {
        // Laid out once, used for every frame; may be shared between threads.
        const lutlib::Grading look(*lutlib::io::Look::open(argv[1]).table().lut);

        constexpr std::size_t width = 256, height = 4;
        std::vector<std::uint8_t> frame(width * height * 4);
        for (std::size_t i = 0; i < width * height; ++i) {
            frame[4 * i] = frame[4 * i + 1] = frame[4 * i + 2] =
                static_cast<std::uint8_t>(i % width);
            frame[4 * i + 3] = 255;
        }
        const lutlib::PictureView view =
            lutlib::interleaved(frame.data(), lutlib::Element::uint8, 4, width, height);
        grade(look, view, view);
        std::printf("middle grey 128 became %d %d %d\n", frame[4 * 128], frame[4 * 128 + 1],
                    frame[4 * 128 + 2]);
    } catch (const lutlib::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
