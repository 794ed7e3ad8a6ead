#include "lutlib/io/formats/picture.h"

#include "lutlib/engine/recognise.h"
#include "lutlib/error.h"
#include "lutlib/io/formats/all.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/io/png.h"
#include "lutlib/limits.h"

#include <algorithm>
#include <cmath>

namespace lutlib::formats {
namespace {

using io::PngImage;

constexpr int recognised_score = 60;
constexpr int made_size = 65;

struct LutPicture {
    Picture picture;
    std::string title;
    const Engine* engine = nullptr; ///< the one it was baked for, where its text says so
};

LutPicture picture_of(std::string_view bytes, const std::string& file) {
    const PngImage image = io::read_png(bytes, file);
    return {decoded(io::code_picture(image)), io::text_entry(image, "Title").value_or(""),
            engine_named(io::text_entry(image, "Engine").value_or(""))};
}

// The one lattice size whose picture in this layout has these dimensions, if there is one.
std::optional<int> size_in_layout(const Picture& picture, const Layout& layout) {
    for (int n = limits::min_cube_size; n <= limits::max_cube_size; ++n) {
        if (layout.picture(n) == PictureSize{picture.width, picture.height}) {
            return n;
        }
    }
    return std::nullopt;
}

[[noreturn]] void refuse_size(const Picture& picture, const Layout& layout,
                              const std::string& file) {
    throw Error("no lattice has a picture of " + std::to_string(picture.width) + "x" +
                    std::to_string(picture.height) + " pixels in the layout '" +
                    std::string(layout.name) + "'",
                {file, 0, {}});
}

// An engine that finds its inputs elsewhere than at i/(N-1) does so along straight lines that bend
// at multiples of half a node: a shaper with an entry at each says the same.
std::optional<Lut1D> shaper_of(const Engine& engine, int size) {
    Lut1D out;
    bool straight = true;
    for (int i = 0; i <= 2 * size; ++i) {
        const double in = i / (2.0 * size), place = engine.place(in, size) / (size - 1);
        straight = straight && std::abs(place - in) < 1e-9;
        const auto entry = static_cast<float>(place);
        out.entries.push_back({entry, entry, entry});
    }
    return straight ? std::nullopt : std::optional(std::move(out));
}

Reading reading_of(const LutPicture& source, const Layout& layout, int size, int row = 0) {
    Reading out;
    out.lut.title = source.title;
    out.lut.cube = from_picture(source.picture, layout, size, row);
    out.layout = &layout;
    out.engine = source.engine;
    if (source.engine && source.engine->layout == layout.name) {
        out.lut.shaper = shaper_of(*source.engine, size);
    }
    return out;
}

std::string write(const FileFormat& format, const Lut& lut, const WriteOptions& options) {
    const Picture picture = to_picture(*lut.cube, *format.layout);
    PngImage codes;
    codes.width = picture.width;
    codes.height = picture.height;
    codes.depth = {options.bits};
    codes.samples.reserve(picture.pixels.size() * 3);
    for (const Rgb& pixel : picture.pixels) {
        for (std::size_t c = 0; c < 3; ++c) {
            codes.samples.push_back(codes.depth.code(pixel[c]));
        }
    }
    const std::string& title = options.title.empty() ? lut.title : options.title;
    codes.text = {{"Title", title}, {"Source", lut.provenance}};
    return io::write_png(codes);
}

Reading read(const FileFormat& format, std::string_view bytes, const std::string& file,
             const ReadOptions& /*options*/) {
    const LutPicture source = picture_of(bytes, file);
    const std::optional<int> size = size_in_layout(source.picture, *format.layout);
    if (!size) {
        refuse_size(source.picture, *format.layout, file);
    }
    return reading_of(source, *format.layout, *size);
}

Reading read_recognised(const FileFormat& /*format*/, std::string_view bytes,
                        const std::string& file, const ReadOptions& options) {
    const LutPicture source = picture_of(bytes, file);
    if (source.engine && options.row == 0) {
        const Layout& layout = *layout_named(source.engine->layout);
        if (const std::optional<int> size = size_in_layout(source.picture, layout)) {
            return reading_of(source, layout, *size);
        }
    }
    const Recognition found = recognise_one(source.picture, file);
    if (options.row < 0 || options.row >= found.rows) {
        throw UsageError("--row " + std::to_string(options.row) + ": the picture has " +
                         std::to_string(found.rows) + " lattice" +
                         (found.rows == 1 ? "" : "s, 0 to " + std::to_string(found.rows - 1)));
    }
    Reading reading = reading_of(source, *found.layout, found.size, options.row);
    if (found.rows > 1) {
        reading.losses.push_back({"only one of the picture's stacked lattices is read (row " +
                                      std::to_string(options.row) + "), of",
                                  static_cast<double>(found.rows), "lattices"});
    }
    return reading;
}

} // namespace

int picture_cube_size(const Layout& layout, const Lut& lut, int wanted) {
    if (wanted != 0) {
        check_cube_size(wanted);
        if (!layout.picture(wanted)) {
            throw UsageError("the layout '" + std::string(layout.name) +
                             "' has no picture of a lattice of " + std::to_string(wanted));
        }
        return wanted;
    }
    const bool plain = lut.cube && !lut.shaper && lut.cube->domain.is_unit();
    const int own = lut.cube ? lut.cube->size : 0;
    int largest = 0;
    for (int n = limits::min_cube_size; n <= limits::max_cube_size; ++n) {
        if (layout.picture(n)) {
            largest = n;
            if (n >= (plain ? own : std::max(own, made_size))) {
                return n;
            }
        }
    }
    return largest;
}

std::span<const FileFormat> pictures() {
    static const std::vector<std::string> labels = [] {
        std::vector<std::string> out;
        for (const Layout& layout : layouts()) {
            out.push_back("PNG picture: " + std::string(layout.help));
        }
        return out;
    }();
    static const std::vector<FileFormat> rows = [] {
        std::vector<FileFormat> out;
        for (const Layout& layout : layouts()) {
            out.push_back({
                .name = layout.name,
                .label = labels[out.size()],
                .extensions = {"png"},
                .holds = {.cube = true, .title = true, .integer_bits = 16},
                .read = read,
                .write = write,
                .picture = true,
                .layout = &layout,
            });
        }
        return out;
    }();
    return rows;
}

constinit const FileFormat png{
    .name = "png",
    .label = "PNG picture whose layout is recognised from its content",
    .extensions = {"png"},
    .holds = {},
    .recognise = [](std::string_view bytes) { return io::is_png(bytes) ? recognised_score : 0; },
    .read = read_recognised,
    .picture = true,
};

} // namespace lutlib::formats
