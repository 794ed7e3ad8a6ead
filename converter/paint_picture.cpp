#include "converter/paint_picture.h"

#include "lutlib/io/alpha.h"
#include "lutlib/io/file.h"
#include "lutlib/io/picture_types.h"
#include "lutlib/io/png.h"

namespace converter {
namespace {

namespace io = lutlib::io;

std::string profile_of(std::string_view bytes, const std::string& file) {
    if (!io::is_png(bytes)) {
        return "";
    }
    const io::PngImage image = io::read_png(bytes, file);
    return image.profile_tag                    ? "a colour profile (iCCP)"
           : image.gamma_tag && !image.srgb_tag ? "a gamma (gAMA)"
                                                : "";
}

} // namespace

PaintPicture read_paint_picture(const std::string& path) {
    const std::string bytes = io::read_file(path), file = io::input_name(path);
    PaintPicture out;
    out.image = io::decode_image(bytes, io::extension_of(path), file);
    io::make_straight(out.image);
    const io::PictureType* const type = io::picture_type_of(bytes, file);
    if (type && !type->harm.empty() && (!type->harms || type->harms(bytes))) {
        out.lossy = type->harm;
    }
    out.profile = profile_of(bytes, file);
    out.colors = {out.image.width, out.image.height, {}};
    out.colors.pixels.reserve(out.image.pixels());
    for (std::size_t i = 0; i < out.image.rgba.size(); i += 4) {
        out.colors.pixels.push_back(
            {out.image.rgba[i], out.image.rgba[i + 1], out.image.rgba[i + 2]});
        if (out.image.alpha) {
            out.alpha.push_back(out.image.rgba[i + 3]);
        }
    }
    return out;
}

std::string png_of(const lutlib::Picture& picture, const std::string& title) {
    io::PngImage out;
    out.width = picture.width;
    out.height = picture.height;
    out.srgb_tag = true;
    out.samples.reserve(picture.pixels.size() * 3);
    for (const lutlib::Rgb& pixel : picture.pixels) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.samples.push_back(out.depth.code(pixel[c]));
        }
    }
    out.text = {{"Title", title}, {"Software", "lutconv"}};
    return io::write_png(out);
}

} // namespace converter
