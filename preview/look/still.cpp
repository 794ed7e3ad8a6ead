#include "preview/look/still.h"

#include "lutlib/color/matrix.h"
#include "lutlib/io/alpha.h"
#include "lutlib/io/image.h"
#include "lutlib/io/orientation.h"
#include "preview/look/odd_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace preview {

namespace {

namespace io = lutlib::io;

bool has_transparency(const io::FloatImage& image) {
    for (std::size_t i = 3; image.alpha && i < image.rgba.size(); i += 4) {
        if (image.rgba[i] != 1) {
            return true;
        }
    }
    return false;
}

/// What the file's numbers are decoded by; empty: they are a display's codes and stay.
std::optional<lutlib::Encoding> decoded_by(const io::FloatImage& image, Still& still) {
    if (still.said) {
        still.shown_as =
            fmt::format("decoded as {} and encoded as sRGB, as asked for", still.said->label());
        return still.said;
    }
    const std::optional<lutlib::Encoding> own = encoding_of(image);
    if (io::info_of(image.depth).integer) {
        still.shown_as =
            own ? fmt::format("its codes are shown as they are; its file says that they are {}",
                              own->label())
                : "its codes are shown as they are, a guess: its file does not say what they are";
        return std::nullopt;
    }
    const lutlib::Encoding light = own.value_or(*lutlib::encoding_named("linear"));
    still.shown_as = fmt::format("{}, encoded by sRGB's curve without a tone map",
                                 own ? "its light (" + light.label() + ")"
                                     : "its numbers are taken for light, a guess");
    return light;
}

void to_display(std::vector<float>& rgba, const lutlib::Encoding& from) {
    const lutlib::Encoding& display = lutlib::srgb();
    if (from == display) {
        return;
    }
    const lutlib::Matrix3 matrix = lutlib::light_to_light(from, display);
    std::vector<lutlib::RgbD> row;
    constexpr std::size_t at_once = 4096;
    for (std::size_t begin = 0; begin < rgba.size() / 4; begin += at_once) {
        row.clear();
        const std::size_t end = std::min(begin + at_once, rgba.size() / 4);
        for (std::size_t i = begin; i < end; ++i) {
            row.push_back(
                lutlib::to_double(lutlib::Rgb{rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]}));
        }
        from.decode_all(row);
        for (lutlib::RgbD& color : row) {
            color = matrix * color;
        }
        display.encode_all(row);
        for (std::size_t i = begin; i < end; ++i) {
            const lutlib::Rgb color = lutlib::to_float(row[i - begin]);
            for (std::size_t c = 0; c < 3; ++c) {
                rgba[4 * i + c] = color[c];
            }
        }
    }
}

} // namespace

std::shared_ptr<const Still> load_still(const std::string& path,
                                        const std::optional<lutlib::Encoding>& said) {
    io::FloatImage image = io::read_image(path);
    if (image.source && image.source->orientation > 1) {
        image = upright(image, image.source->orientation);
    }
    Still still;
    still.path = path;
    still.said = said;
    if (!io::info_of(image.depth).integer) {
        still.told = told_of(settle_odd_numbers(image.rgba));
    }
    if (image.premultiplied && has_transparency(image)) {
        make_straight(image);
        still.told.emplace_back(
            "its colours are multiplied by its alpha, and shown as they are without it");
    }
    if (const std::optional<lutlib::Encoding> from = decoded_by(image, still)) {
        to_display(image.rgba, *from);
    }
    for (float& value : image.rgba) {
        value = value >= 0 ? std::min(value, 1.0F) : 0;
    }
    still.size = {static_cast<std::uint32_t>(image.width),
                  static_cast<std::uint32_t>(image.height)};
    still.rgba = std::move(image.rgba);
    return std::make_shared<const Still>(std::move(still));
}

std::string title_of(const Still& still) {
    return std::filesystem::path(still.path).stem().string();
}

} // namespace preview
