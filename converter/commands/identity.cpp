// lutconv identity: a LUT that changes nothing, as a file of any kind or an engine's picture, alone
// or in a screenshot that is to be graded.
#include "converter/command.h"
#include "converter/options.h"
#include "converter/paint_picture.h"
#include "converter/report.h"
#include "converter/unused.h"
#include "converter/usage.h"
#include "lutlib/bake/bake.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/named.h"
#include "lutlib/paint/frame.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>

namespace converter {
namespace {

namespace io = lutlib::io;

struct IdentityOptions {
    std::string output, into, place;
    EngineOption engine;
    int size = 0, bits = 0;
};

constexpr int usual_size = 33;

const lutlib::Engine& engine_of(const IdentityOptions& o) {
    return o.engine.given() ? o.engine.get() : *lutlib::engine_named("piccolo");
}

std::string bytes_of(const IdentityOptions& o) {
    if (io::extension_of(o.output) == "png" || o.engine.given()) {
        require_png_name(o.output, "--engine");
        const lutlib::Engine& engine = engine_of(o);
        const lutlib::Bake picture = lutlib::bake({}, engine, o.size ? o.size : engine.default_size,
                                                  o.bits ? o.bits : engine.default_bits);
        return io::picture_bytes(picture, {"identity", "Identity", {}});
    }
    if (o.bits) {
        throw lutlib::UsageError("--bits is for pictures: give -o a .png name, or add --engine");
    }
    lutlib::Lut lut;
    lut.cube = lutlib::identity_cube(o.size ? o.size : usual_size);
    lut.title = "Identity";
    return io::encode_lut(lut, io::format_for_writing(o.output, lut)).bytes;
}

/// Where a frame goes in a screenshot.
struct Place {
    std::string_view name, help;
    /// The extent of the whole, and where in it the frame lies.
    lutlib::PictureSize (*extent)(lutlib::PictureSize shot, lutlib::PictureSize frame);
    lutlib::Pixel (*at)(lutlib::PictureSize shot, lutlib::PictureSize frame);
};

lutlib::PictureSize shot_alone(lutlib::PictureSize shot, lutlib::PictureSize /*frame*/) {
    return shot;
}

constexpr std::array<Place, 4> places{{
    {.name = "below",
     .help = "under the screenshot, which stays whole",
     .extent =
         [](lutlib::PictureSize shot, lutlib::PictureSize frame) {
             return lutlib::PictureSize{std::max(shot.width, frame.width),
                                        shot.height + frame.height};
         },
     .at =
         [](lutlib::PictureSize shot, lutlib::PictureSize /*frame*/) {
             return lutlib::Pixel{0, shot.height};
         }},
    {.name = "right",
     .help = "beside it",
     .extent =
         [](lutlib::PictureSize shot, lutlib::PictureSize frame) {
             return lutlib::PictureSize{shot.width + frame.width,
                                        std::max(shot.height, frame.height)};
         },
     .at =
         [](lutlib::PictureSize shot, lutlib::PictureSize /*frame*/) {
             return lutlib::Pixel{shot.width, 0};
         }},
    {.name = "top-left",
     .help = "over its corner",
     .extent = shot_alone,
     .at =
         [](lutlib::PictureSize, lutlib::PictureSize) {
             return lutlib::Pixel{0, 0};
         }},
    {.name = "bottom-left",
     .help = "over its other corner",
     .extent = shot_alone,
     .at =
         [](lutlib::PictureSize shot, lutlib::PictureSize frame) {
             return lutlib::Pixel{0, shot.height - frame.height};
         }},
}};

// Of types that keep codes as they are.
void require_exact_type(const std::string& path) {
    constexpr std::array<std::string_view, 5> exact{"png", "tif", "tiff", "tga", "bmp"};
    const std::string extension = io::extension_of(path);
    if (path != io::standard_stream &&
        std::find(exact.begin(), exact.end(), extension) == exact.end()) {
        throw lutlib::UsageError("--into writes codes that must stay as they are: give -o a name "
                                 "that ends in .png, .tif, .tga or .bmp");
    }
}

int frame_bits(const IdentityOptions& o, const io::FloatImage& shot) {
    return o.bits ? o.bits : shot.depth == io::Depth::uint16 ? 16 : 8;
}

// The frame at its place over the screenshot, and quiet around both.
io::FloatImage composed(const PaintPicture& shot, const lutlib::CodeImage& frame,
                        lutlib::PictureSize whole, lutlib::Pixel at) {
    const lutlib::PictureSize shot_size = shot.colors.size(), frame_size{frame.width, frame.height};
    io::FloatImage out;
    static_cast<io::ImageInfo&>(out) = shot.image;
    out.width = whole.width;
    out.height = whole.height;
    out.premultiplied = false;
    const float quiet = lutlib::quiet_code / 255.0F;
    out.rgba.resize(out.pixels() * 4);
    const auto maximum = static_cast<float>(frame.depth.maximum());
    for (int y = 0; y < whole.height; ++y) {
        for (int x = 0; x < whole.width; ++x) {
            float* const pixel =
                &out.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(whole.width) +
                               static_cast<std::size_t>(x))];
            const bool framed_pixel = x >= at.x && y >= at.y && x < at.x + frame_size.width &&
                                      y < at.y + frame_size.height;
            const bool shown = x < shot_size.width && y < shot_size.height;
            for (std::size_t c = 0; c < 3; ++c) {
                pixel[c] = framed_pixel
                               ? static_cast<float>(frame.at({x - at.x, y - at.y}, c)) / maximum
                           : shown ? shot.colors.at(x, y)[c]
                                   : quiet;
            }
            pixel[3] = !framed_pixel && shown && shot.image.alpha
                           ? shot.alpha[static_cast<std::size_t>(y) *
                                            static_cast<std::size_t>(shot_size.width) +
                                        static_cast<std::size_t>(x)]
                           : 1.0F;
        }
    }
    return out;
}

int run_into(const IdentityOptions& o) {
    require_exact_type(o.output);
    const Place& place = lutlib::require_named(places, "place", o.place);
    const lutlib::Engine& engine = engine_of(o);
    const int size = o.size ? o.size : engine.default_size;
    check_contract(engine, size, engine.default_bits);
    const PaintPicture shot = read_paint_picture(o.into);
    const std::string name = io::input_name(o.into);
    if (shot.image.holds_light || !io::info_of(shot.image.depth).integer) {
        throw lutlib::Error("it holds light or floats, and a strip codes of 0..1; save the "
                            "screenshot as the display shows it, as PNG or TIFF",
                            {name, 0, {}});
    }
    const lutlib::Framed framed{lutlib::layout_named(engine.layout), size,
                                frame_bits(o, shot.image)};
    const lutlib::CodeImage frame = neutral_frame(framed);
    const lutlib::PictureSize extent_of_shot = shot.colors.size(),
                              of_frame{frame.width, frame.height};
    const lutlib::PictureSize whole = place.extent(extent_of_shot, of_frame);
    const lutlib::Pixel at = place.at(extent_of_shot, of_frame);
    if (at.y < 0 || at.x + of_frame.width > whole.width || at.y + of_frame.height > whole.height) {
        throw lutlib::Error(
            fmt::format("the strip with its border has {}x{} pixels and this picture {}x{}, and a "
                        "strip must not be scaled; take --place below, a larger screenshot or "
                        "fewer nodes (--size)",
                        of_frame.width, of_frame.height, extent_of_shot.width,
                        extent_of_shot.height),
            {name, 0, {}});
    }
    const io::FloatImage out = composed(shot, frame, whole, at);
    const std::vector<io::Depth> held = io::depths_of(o.output);
    const io::Depth depth = framed.bits == 16 ? io::Depth::uint16 : io::Depth::uint8;
    if (std::find(held.begin(), held.end(), depth) == held.end()) {
        throw lutlib::UsageError(fmt::format("{} holds no {} bits a sample; write a .png or .tif",
                                             io::output_name(o.output), framed.bits));
    }
    const std::vector<std::string> lost = io::write_image(o.output, out,
                                                          {.depth = depth,
                                                           .alpha = shot.image.alpha,
                                                           .text = {{"Software", "lutconv"}},
                                                           .keep = shot.image.source.get()});
    const lutlib::FrameGeometry where = geometry_of(framed);
    std::string text = fmt::format(
        "{} <- {} and the neutral strip for {}\n  {}x{} pixels; the strip, {} of {} nodes and {} "
        "bits, at {},{}, its mark and border around it\n  grade the whole picture alike, save it "
        "as PNG or TIFF of this size, then: lutconv extract GRADED -o look.cube\n",
        output_text(o.output), input_text(o.into), engine.label, whole.width, whole.height,
        engine.layout, size, framed.bits, at.x + where.strip_at.x, at.y + where.strip_at.y);
    for (const std::string& what : lost) {
        text += "  lost: " + one_line(what) + "\n";
    }
    print(text, o.output);
    return ok;
}

} // namespace

Run declare_identity(Verb& verb) {
    const auto o = std::make_shared<IdentityOptions>();
    verb.add_output("-o,--output", o->output,
                    "a LUT file of any extension, or - for a .cube to standard output")
        .required();
    verb.add_option("--size", o->size,
                    "lattice size: nodes per axis (default: the engine's, or 33)")
        .takes(Takes::cube_size);
    verb.add_option("--bits", o->bits, "bits per sample of a picture: 8 or 16")
        .takes(Takes::picture_bits);
    o->engine.declare(verb, "");
    verb.add_option("--into", o->into,
                    "a screenshot to place the neutral strip in, with a border and a mark by "
                    "which extract finds it once both are graded");
    o->place = places.front().name;
    std::string help = "where:";
    for (const Place& place : places) {
        help +=
            fmt::format(" {} ({}){}", place.name, place.help, &place == &places.back() ? "" : ",");
    }
    verb.add_option("--place", o->place, help).capture_default_str();
    return [o, &verb] {
        if (!o->into.empty()) {
            return run_into(*o);
        }
        tell_unused(verb, {{"--place", false, "it says where --into places the strip"}});
        io::write_file(o->output, bytes_of(*o));
        return static_cast<int>(ok);
    };
}

} // namespace converter
