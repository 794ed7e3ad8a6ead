#include "lutlib/io/lut_picture.h"

#include "lutlib/engine/evidence.h"
#include "lutlib/error.h"
#include "lutlib/io/alpha.h"
#include "lutlib/io/file.h"
#include "lutlib/io/image.h"
#include "lutlib/io/picture_types.h"
#include "lutlib/limits.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace lutlib::io {
namespace {

constexpr const char *input_key = "Input encoding", *output_key = "Output encoding",
                     *tones_key = "Tones", *falling_tones = "falling",
                     *look_input_key = "Look input", *look_output_key = "Look output";

void append_known(PngImage& image, const char* key, const std::string& name) {
    if (!name.empty()) {
        image.text.emplace_back(key, name);
    }
}

// Colours under an alpha below 1 are made straight.
std::vector<std::string> remarks_of(FloatImage& image, std::string_view bytes,
                                    const std::string& file) {
    std::vector<std::string> out;
    const PictureType* const type = picture_type_of(bytes, file);
    if (type && !type->harm.empty() && (!type->harms || type->harms(bytes))) {
        out.emplace_back(type->harm);
    }
    std::size_t translucent = 0, lost = 0;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
        translucent += image.rgba[i] != 1.0F;
        lost += image.rgba[i] == 0.0F;
    }
    if (!image.premultiplied || translucent == 0) {
        return out;
    }
    make_straight(image);
    out.push_back(fmt::format(
        "its colours are stored multiplied by alpha, which is not 1 in {} "
        "texels, and were divided by it{}; save it without alpha",
        translucent,
        lost == 0 ? "" : fmt::format("; in {} it is 0, so that their colours are lost", lost)));
    return out;
}

} // namespace

void append_tones(PngImage& image, const Layout& layout, int size) {
    const int last = size - 1;
    const auto tone = [&](int i) {
        const Pixel at = layout.pixel(size, image.width, i, i, i);
        return image.at(at, 0) + image.at(at, 1) + image.at(at, 2);
    };
    const bool may_fall = tone(last) < tone(0); // spares nearly all looks the rest
    if (may_fall && falls(evidence_of(from_picture(decoded(image), layout, size)))) {
        image.text.emplace_back(tones_key, falling_tones);
    }
}

void append_encodings(PngImage& image, const EncodingNames& names) {
    append_known(image, input_key, names.input);
    append_known(image, output_key, names.output);
}

EncodingNames encodings_of(const PngImage& image) {
    return {text_entry(image, input_key).value_or(""), text_entry(image, output_key).value_or("")};
}

EncodingNames look_encodings_of(const PngImage& image) {
    return {text_entry(image, look_input_key).value_or(""),
            text_entry(image, look_output_key).value_or("")};
}

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
    append_tones(image, *layout_named(bake.engine->layout), bake.size);
    append_encodings(image, origin.encodings);
    append_known(image, look_input_key, origin.look.input);
    append_known(image, look_output_key, origin.look.output);
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

bool is_own_picture(const std::string& path) {
    try {
        const std::string bytes = read_file(path);
        return is_png(bytes) && text_entry(read_png(bytes, path), "Software") == "lutconv";
    } catch (const Error&) {
        return false;
    }
}

LutPicture read_lut_picture(std::string_view bytes, const std::string& file) {
    if (is_png(bytes)) {
        if (pixels_of_png(bytes) > limits::max_lut_picture_pixels) {
            throw Error(fmt::format("a picture of more than {} pixels is no LUT",
                                    limits::max_lut_picture_pixels),
                        {file, 0, {}});
        }
        const PngImage image = read_png(bytes, file);
        return {.picture = decoded(code_picture(image)),
                .bits = image.depth.bits,
                .alpha = image.channels == 4,
                .title = text_entry(image, "Title").value_or(""),
                .engine = engine_named(text_entry(image, "Engine").value_or("")),
                .encodings = encodings_of(image),
                .says_negative = text_entry(image, tones_key) == falling_tones};
    }
    FloatImage image = decode_image(bytes, extension_of(file), file);
    LutPicture out;
    out.remarks = remarks_of(image, bytes, file);
    out.bits = image.depth == Depth::uint8 ? 8 : image.depth == Depth::uint16 ? 16 : 0;
    out.alpha = image.alpha;
    out.picture = {image.width, image.height, std::vector<Rgb>(image.rgba.size() / 4)};
    for (std::size_t i = 0; i < out.picture.pixels.size(); ++i) {
        out.picture.pixels[i] = {image.rgba[4 * i], image.rgba[4 * i + 1], image.rgba[4 * i + 2]};
    }
    return out;
}

CodeImage code_picture(const LutPicture& picture) {
    CodeImage out;
    out.width = picture.picture.width;
    out.height = picture.picture.height;
    out.depth.bits = picture.bits == 8 ? 8 : 16;
    out.samples.reserve(picture.picture.pixels.size() * 3);
    for (const Rgb& pixel : picture.picture.pixels) {
        for (const float value : {pixel.r, pixel.g, pixel.b}) {
            out.samples.push_back(out.depth.code(value));
        }
    }
    return out;
}

Recognised layout_of(const LutPicture& picture, const std::string& file, const Engine* named) {
    LayoutHint hint;
    if (const Engine* const engine = named ? named : picture.engine) {
        hint = {layout_named(engine->layout),
                std::string(named ? "it was said to be for" : "its text names") + " the engine " +
                    std::string(engine->name)};
    }
    Recognised out = recognise_one(picture.picture, file, hint);
    if (picture.says_negative) {
        out.doubt = out.reading.falls ? ""
                                      : "its text says that brighter inputs become darker, which "
                                        "they do not: the picture was mirrored or turned by 180 "
                                        "degrees since it was made";
    }
    return out;
}

} // namespace lutlib::io
