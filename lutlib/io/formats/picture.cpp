#include "lutlib/io/formats/picture.h"

#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/io/formats/all.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/io/picture_types.h"
#include "lutlib/io/png.h"
#include "lutlib/limits.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib::formats {
namespace {

using io::PngImage;

constexpr int recognised_score = 60;
constexpr int made_size = 65;

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

// A table weighs codes between its nodes, where this engine weighs light; most in mid-cell.
Loss filtering_loss(const Engine& engine, const Picture& picture, const Lut& look) {
    const int size = look.cube->size;
    double most = 0;
    const auto centre = [size](int i) {
        return (static_cast<float>(i) + 0.5F) / static_cast<float>(size - 1);
    };
    for (int b = 0; b + 1 < size; ++b) {
        for (int g = 0; g + 1 < size; ++g) {
            for (int r = 0; r + 1 < size; ++r) {
                const Rgb in{centre(r), centre(g), centre(b)};
                most = std::max(
                    most, largest_magnitude(to_double(engine.lookup(picture, size, in)) -
                                            to_double(evaluate(look, in, engine.interpolation))));
            }
        }
    }
    return {std::string(engine.name) + " filters light between nodes and a table codes, largest "
                                       "difference in mid-cell",
            most, ""};
}

Reading reading_of(const io::LutPicture& source, const Layout& layout, int size,
                   const ReadOptions& options) {
    const Engine* const engine = options.engine ? options.engine : source.engine;
    Reading out;
    out.remarks = source.remarks;
    out.lut.title = source.title;
    out.lut.encodings = source.encodings;
    out.lut.cube = from_picture(source.picture, layout, size, options.row);
    out.layout = &layout;
    out.engine = source.engine;
    if (engine && engine->layout == layout.name) {
        out.lut.shaper = shaper_of(*engine, size);
        if (engine->filtering == Filtering::light && options.row == 0) {
            out.losses.push_back(filtering_loss(*engine, source.picture, out.lut));
        }
    }
    return out;
}

[[noreturn]] void refuse_row(int row, int rows) {
    throw UsageError("--row " + std::to_string(row) + ": the picture has " + std::to_string(rows) +
                     " lattice" + (rows == 1 ? "" : "s, 0 to " + std::to_string(rows - 1)));
}

Reading read_in(const io::LutPicture& source, const Layout& layout, const std::string& file,
                const ReadOptions& options) {
    const std::optional<Arrangement> held = arrangement_in(layout, source.picture.size());
    if (!held) {
        refuse_size(source.picture, layout, file);
    }
    if (options.row < 0 || options.row >= held->rows) {
        refuse_row(options.row, held->rows);
    }
    Reading out = reading_of(source, layout, held->size, options);
    if (held->rows > 1) {
        out.losses.push_back({"only one of the picture's stacked lattices is read (row " +
                                  std::to_string(options.row) + "), of",
                              static_cast<double>(held->rows), "lattices"});
    }
    return out;
}

std::string write_picture(const FileFormat& format, const Lut& lut, const WriteOptions& options) {
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
    codes.text = {{"Title", title}, {"Source", lut.provenance}, {"Software", "lutconv"}};
    io::append_tones(codes, *format.layout, lut.cube->size);
    io::append_encodings(codes, lut.encodings);
    return io::write_png(codes);
}

Reading read_picture(const FileFormat& format, std::string_view bytes, const std::string& file,
                     const ReadOptions& options) {
    return read_in(io::read_lut_picture(bytes, file), *format.layout, file, options);
}

Reading read_recognised(const FileFormat& /*format*/, std::string_view bytes,
                        const std::string& file, const ReadOptions& options) {
    const io::LutPicture source = io::read_lut_picture(bytes, file);
    if (options.layout) {
        return read_in(source, *options.layout, file, options);
    }
    const auto [found, contradiction, doubt] = layout_of(source, file, options.engine);
    Reading out = read_in(source, *found.layout, file, options);
    for (const std::string& remark : {contradiction, doubt}) {
        if (!remark.empty()) {
            out.remarks.push_back(remark);
        }
    }
    return out;
}

int is_other_picture(std::string_view bytes) {
    return io::begins_as_picture(bytes) && !io::is_png(bytes) ? recognised_score : 0;
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
                .holds = {.cube = true, .title = true, .encodings = true, .integer_bits = 16},
                .read = read_picture,
                .write = write_picture,
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

constinit const FileFormat picture{
    .name = "picture",
    .label = "TGA, TIFF, BMP, JPEG, EXR, DPX, WebP, GIF, PPM, Radiance HDR or PSD picture, its "
             "layout recognised",
    // Of the others the content tells.
    .extensions = {"tga", "tif", "tiff", "bmp", "jpg", "jpeg", "exr", "dpx", "webp"},
    .holds = {},
    .recognise = is_other_picture,
    .read = read_recognised,
    .picture = true,
};

} // namespace lutlib::formats
