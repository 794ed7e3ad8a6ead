#include "converter/raster_file.h"

#include "lutlib/error.h"
#include "lutlib/io/extension.h"
#include "lutlib/io/image.h"

#include <algorithm>
#include <cstring>
#include <utility>

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
    io::SampleImage image;
    image.width = raster.width();
    image.height = raster.height();
    image.channels = 3;
    image.depth = io::Depth::uint8;
    image.samples = io::samples_for(path, image);
    if (image.samples.size() < image.bytes()) {
        image.samples = io::SampleBuffer(image.bytes());
    }
    static_assert(sizeof(plot::Rgb8) == 3);
    std::memcpy(image.samples.data(), raster.pixels().data(), image.bytes());
    io::write_samples(
        path, std::move(image),
        {.depth = io::Depth::uint8, .text = {{"Source", source}, {"Software", "lutconv"}}});
}

} // namespace converter
