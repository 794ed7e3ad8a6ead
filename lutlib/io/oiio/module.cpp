// OpenImageIO behind oiio.h.

#include "lutlib/io/oiio.h"

#include "lutlib/error.h"
#include "lutlib/limits.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

namespace lutlib::io {
namespace {

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

// OpenImageIO's text, whose lines may be many, after `message`.
[[noreturn]] void fail(const std::string& message, std::string reason, const std::string& path,
                       const std::string& file) {
    for (std::size_t at = reason.find(path); at != std::string::npos; at = reason.find(path, at)) {
        reason.replace(at, path.size(), file);
        at += file.size();
    }
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw Error(message + ": OpenImageIO: " + (reason.empty() ? "no reason given" : reason),
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

// Channel c of the file's first four, moved to its place among red, green, blue, alpha.
void spread(FloatImage& image, const std::vector<float>& samples, std::size_t channels) {
    const bool grey = channels < 3;
    const std::size_t colors = grey ? 1 : 3;
    const std::size_t pixels = samples.size() / channels;
    image.rgba.assign(pixels * 4, 1.0F);
    for (std::size_t i = 0; i < pixels; ++i) {
        const float* const in = &samples[i * channels];
        float* const out = &image.rgba[i * 4];
        for (std::size_t c = 0; c < 3; ++c) {
            out[c] = in[grey ? 0 : c];
        }
        if (image.alpha) {
            out[3] = in[colors];
        }
    }
}

class Library final : public Oiio {
  public:
    std::string version() const override { return OIIO_VERSION_STRING; }

    FloatImage read(const std::string& path, const std::string& file) const override {
        OIIO::ImageSpec config;
        // Without this, alpha would be multiplied into the colours of PNG, TIFF and others.
        config.attribute("oiio:UnassociatedAlpha", 1);
        const auto input = OIIO::ImageInput::open(path, &config);
        if (!input) {
            fail("cannot read the picture", OIIO::geterror(), path, file);
        }
        const OIIO::ImageSpec& spec = input->spec();
        check_size(spec, file);
        FloatImage image;
        image.width = spec.width;
        image.height = spec.height;
        image.channels = std::min(spec.nchannels, 4);
        image.alpha = image.channels == 2 || image.channels == 4;
        image.depth = depth_of(spec.format);
        const std::string_view type = input->format_name();
        image.holds_light = type == "openexr" || type == "hdr";
        std::array<float, 8> chromaticities{};
        if (spec.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8),
                              chromaticities.data())) {
            image.chromaticities = chromaticities;
        }
        const auto channels = static_cast<std::size_t>(image.channels);
        std::vector<float> samples(static_cast<std::size_t>(spec.width) *
                                   static_cast<std::size_t>(spec.height) * channels);
        if (!input->read_image(0, 0, 0, image.channels, OIIO::TypeDesc::FLOAT, samples.data())) {
            fail("cannot read the pixels", input->geterror(), path, file);
        }
        input->close();
        spread(image, samples, channels);
        return image;
    }

    bool writes(const std::string& path) const override {
        const bool known = OIIO::ImageOutput::create(path) != nullptr;
        OIIO::geterror(); // else it is printed when the program ends
        return known;
    }

    std::vector<std::string> written_extensions() const override {
        // "tiff:tif,tiff,tx;openexr:exr,sxr": of types that are read or written.
        std::vector<std::string> out;
        std::istringstream types(OIIO::get_string_attribute("extension_list"));
        for (std::string type; std::getline(types, type, ';');) {
            const std::size_t first = type.find(':') + 1;
            const std::string extension = type.substr(first, type.find(',') - first);
            const bool makes_file = extension != "null" && extension != "term"; // a terminal
            if (makes_file && writes("picture." + extension)) {
                out.push_back(extension);
            }
        }
        std::sort(out.begin(), out.end());
        return out;
    }

    Depth written_depth(const std::string& path, const std::string& file,
                        Depth depth) const override {
        // Large enough for every type; JPEG 2000 wants several resolutions.
        FloatImage image;
        image.width = image.height = 64;
        image.rgba.assign(64 * 64 * 4, 0.0F);
        write(path, file, image, {depth, false, {}});
        // What the library says of a file that it writes is not always what it then wrote.
        const auto written = OIIO::ImageInput::open(path);
        if (!written) {
            fail("cannot read back a picture of this type", OIIO::geterror(), path, file);
        }
        return depth_of(written->spec().format);
    }

    void write(const std::string& path, const std::string& file, const FloatImage& image,
               const ImageWriteOptions& options) const override {
        const auto output = OIIO::ImageOutput::create(path);
        if (!output) {
            fail("cannot write a picture of this type", OIIO::geterror(), path, file);
        }
        const std::size_t channels = options.alpha ? 4 : 3;
        OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(channels),
                             type_of(options.depth));
        spec.attribute("oiio:UnassociatedAlpha", 1);
        for (const auto& [key, value] : options.text) {
            spec.attribute(key, value);
        }
        if (!output->open(path, spec)) {
            fail("cannot write the picture", output->geterror(), path, file);
        }
        const auto stride = static_cast<OIIO::stride_t>(4 * sizeof(float));
        if (!output->write_image(OIIO::TypeDesc::FLOAT, image.rgba.data(), stride) ||
            !output->close()) {
            fail("cannot write the pixels", output->geterror(), path, file);
        }
    }
};

} // namespace
} // namespace lutlib::io

extern "C" __attribute__((visibility("default"))) const lutlib::io::Oiio* lutlib_oiio();

extern "C" const lutlib::io::Oiio* lutlib_oiio() {
    static const lutlib::io::Library library;
    return &library;
}
