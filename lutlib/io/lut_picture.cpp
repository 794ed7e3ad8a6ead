#include "lutlib/io/lut_picture.h"

#include <algorithm>

namespace lutlib::io {

std::string picture_bytes(const Bake& bake, const BakeOrigin& origin) {
    PngImage image;
    static_cast<CodeImage&>(image) = bake.picture;
    image.srgb_tag = bake.engine->srgb_tag == SrgbTag::present;
    image.text = {{"Source", origin.source},
                  {"Title", origin.title},
                  {"Engine", std::string(bake.engine->name)},
                  {"Interpolation", std::string(origin.interpolation)},
                  {"Lattice", origin.fitted ? "fitted" : "point-sampled"},
                  {"Software", "lutconv"}};
    return write_png(image);
}

CodeImage code_picture(const PngImage& image) {
    CodeImage out;
    out.width = image.width;
    out.height = image.height;
    out.depth = image.depth;
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t pixels = image.samples.size() / channels;
    out.samples.resize(pixels * 3);
    for (std::size_t i = 0; i < pixels; ++i) {
        std::copy_n(&image.samples[i * channels], 3, &out.samples[i * 3]);
    }
    return out;
}

std::optional<std::string> text_entry(const PngImage& image, std::string_view key) {
    for (const auto& [name, text] : image.text) {
        if (name == key) {
            return text;
        }
    }
    return std::nullopt;
}

} // namespace lutlib::io
