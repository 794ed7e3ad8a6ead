#include "converter/raster_file.h"

#include "lutlib/error.h"
#include "lutlib/io/extension.h"
#include "lutlib/io/image.h"

#include <algorithm>

namespace converter {

namespace io = lutlib::io;

void require_raster_name(const std::string& path, const std::string& what) {
    const std::vector<io::Depth> held = io::depths_of(path);
    if (std::find(held.begin(), held.end(), io::Depth::uint8) == held.end()) {
        throw lutlib::UsageError(what + " is a picture of 8 bits, which ." +
                                 io::extension_of(path) +
                                 " files do not hold: name a .png to write");
    }
}

void write_raster(const std::string& path, const plot::Raster& raster, const std::string& source) {
    io::FloatImage image;
    image.width = raster.width();
    image.height = raster.height();
    image.rgba.reserve(4 * image.pixels());
    for (const plot::Rgb8& pixel : raster.pixels()) {
        for (const std::uint8_t code : pixel) {
            image.rgba.push_back(static_cast<float>(code) / 255);
        }
        image.rgba.push_back(1);
    }
    io::write_image(path, image, {.depth = io::Depth::uint8, .text = {{"Source", source}}});
}

} // namespace converter
