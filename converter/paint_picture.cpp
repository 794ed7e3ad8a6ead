#include "converter/paint_picture.h"

#include "lutlib/error.h"
#include "lutlib/io/alpha.h"
#include "lutlib/io/file.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/io/picture_types.h"

#include <filesystem>

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

void require_replaceable(const std::string& path, const std::vector<std::string>& inputs,
                         bool force) {
    std::error_code none;
    if (force || path.empty() || path == io::standard_stream ||
        !std::filesystem::is_regular_file(path, none)) {
        return;
    }
    for (const std::string& input : inputs) {
        if (!input.empty() && std::filesystem::equivalent(path, input, none)) {
            throw lutlib::Error("it is what this run reads; name another file, or add --force to "
                                "overwrite it",
                                {path, 0, {}});
        }
    }
    if (io::is_picture_extension(io::extension_of(path)) && !io::is_own_picture(path)) {
        throw lutlib::Error("it is a picture that lutconv did not make; name another file, or add "
                            "--force to overwrite it",
                            {path, 0, {}});
    }
}

} // namespace converter
