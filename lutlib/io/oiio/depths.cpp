#include "lutlib/io/oiio/depths.h"

#include "lutlib/error.h"
#include "lutlib/io/condensed.h"
#include "lutlib/limits.h"

#include <algorithm>
#include <cstddef>

namespace lutlib::io {

OIIO::TypeDesc type_of(Depth depth) {
    switch (depth) {
    case Depth::uint8:
        return OIIO::TypeDesc::UINT8;
    case Depth::uint16:
        return OIIO::TypeDesc::UINT16;
    case Depth::half:
        return OIIO::TypeDesc::HALF;
    case Depth::float32:
        break;
    }
    return OIIO::TypeDesc::FLOAT;
}

Depth depth_of(const OIIO::TypeDesc& type) {
    switch (type.basetype) {
    case OIIO::TypeDesc::UINT8:
    case OIIO::TypeDesc::INT8:
        return Depth::uint8;
    case OIIO::TypeDesc::UINT16:
    case OIIO::TypeDesc::INT16:
        return Depth::uint16;
    case OIIO::TypeDesc::HALF:
        return Depth::half;
    default:
        return Depth::float32;
    }
}

void fail(const std::string& message, std::string reason, const std::string& path,
          const std::string& file) {
    reason = condensed(std::move(reason), path, file);
    throw Error(message + (reason.empty() ? ": it is damaged or cut; fetch or export it again"
                                          : ": OpenImageIO: " + reason),
                {file, 0, {}});
}

void check_size(const OIIO::ImageSpec& spec, const std::string& file) {
    const auto pixels = static_cast<std::size_t>(std::max(spec.width, 0)) *
                        static_cast<std::size_t>(std::max(spec.height, 0));
    if (pixels == 0 || spec.width > limits::max_image_side ||
        spec.height > limits::max_image_side || pixels > limits::max_image_pixels ||
        spec.depth > 1) {
        throw Error("a picture of " + std::to_string(spec.width) + "x" +
                        std::to_string(spec.height) + "x" + std::to_string(spec.depth) +
                        " pixels is outside the limits of " +
                        std::to_string(limits::max_image_side) + " a side and " +
                        std::to_string(limits::max_image_pixels) + " in all",
                    {file, 0, {}});
    }
    if (spec.nchannels < 1) {
        throw Error("the picture has no channels", {file, 0, {}});
    }
}

} // namespace lutlib::io
