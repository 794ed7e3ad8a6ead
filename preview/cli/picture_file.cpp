#include "preview/cli/picture_file.h"

#include "lutlib/color/encoding.h"
#include "lutlib/error.h"
#include "lutlib/io/alpha.h"
#include "lutlib/io/file.h"
#include "lutlib/named.h"

#include <algorithm>
#include <cmath>

namespace preview {

namespace io = lutlib::io;

namespace {

bool is_png(const std::string& path) {
    return path == io::standard_stream || io::extension_of(path) == "png";
}

io::PngImage png_of(const io::FloatImage& image, int bits) {
    io::PngImage out;
    out.width = image.width;
    out.height = image.height;
    out.channels = image.channels;
    out.depth = {bits};
    out.srgb_tag = true;
    for (std::size_t at = 0; at < image.rgba.size(); at += 4) {
        for (std::size_t c = 0; c < static_cast<std::size_t>(image.channels); ++c) {
            out.samples.push_back(out.depth.code(image.rgba[at + c]));
        }
    }
    return out;
}

io::FloatImage float_image(const Rendered& rendered) {
    io::FloatImage out;
    out.width = static_cast<int>(rendered.size.width);
    out.height = static_cast<int>(rendered.size.height);
    out.channels = 3;
    out.rgba = rendered.values;
    for (const std::uint8_t code : rendered.rgba) {
        out.rgba.push_back(static_cast<float>(code) / 255);
    }
    return out;
}

void decode(std::vector<float>& rgba) {
    for (std::size_t at = 0; at < rgba.size(); ++at) {
        if (at % 4 != 3) {
            rgba[at] = static_cast<float>(lutlib::srgb().decode(static_cast<double>(rgba[at])));
        }
    }
}

/// The mean of a picture's alpha over one texel's area of `size`.
float mean_alpha(const ShownPicture& picture, Size size, std::uint32_t x, std::uint32_t y) {
    const auto ends = [](std::uint32_t at, std::uint32_t texels, std::uint32_t length) {
        const double scale = static_cast<double>(length) / texels;
        return std::pair{at * scale, (at + 1) * scale};
    };
    const auto [left, right] = ends(x, size.width, picture.size.width);
    const auto [top, bottom] = ends(y, size.height, picture.size.height);
    const auto share = [](double low, double high, std::uint32_t at) {
        return std::min(high, at + 1.0) - std::max(low, static_cast<double>(at));
    };
    double sum = 0, area = 0;
    for (auto v = static_cast<std::uint32_t>(top); v < bottom && v < picture.size.height; ++v) {
        for (auto u = static_cast<std::uint32_t>(left); u < right && u < picture.size.width; ++u) {
            const double weight = share(left, right, u) * share(top, bottom, v);
            const std::size_t texel = std::size_t{v} * picture.size.width + u;
            sum += weight * static_cast<double>(picture.rgba[4 * texel + 3]);
            area += weight;
        }
    }
    return static_cast<float>(area > 0 ? sum / area : 1);
}

void set_alpha(io::FloatImage& image, const std::vector<float>& alpha) {
    for (std::size_t i = 0; i < alpha.size(); ++i) {
        image.rgba[4 * i + 3] = alpha[i];
    }
    image.channels = alpha.empty() ? 3 : 4;
    image.alpha = !alpha.empty();
}

/// Colours multiplied by alpha where files of that type hold them so.
std::vector<std::string> write_as_stored(const std::string& path, io::FloatImage& image,
                                         const FileFormat& format) {
    if (image.alpha && io::stores_premultiplied(path, nullptr)) {
        io::premultiply(image);
    }
    return io::write_image(path, image, {format.depth, image.alpha, {}});
}

} // namespace

FileFormat file_format(const std::string& path, const std::string& depth) {
    FileFormat out;
    const std::string extension = io::extension_of(path);
    out.holds_light = extension == "exr" || extension == "hdr";
    if (depth.empty()) {
        if (!is_png(path)) {
            io::depths_of(path); // refuses names of no type
        }
        out.depth = out.holds_light ? io::Depth::half : io::Depth::uint8;
        return out;
    }
    const io::DepthInfo& row = lutlib::require_named(io::depths(), "depth", depth);
    const std::vector<io::Depth> held = io::depths_of(path);
    if (std::find(held.begin(), held.end(), row.depth) == held.end()) {
        std::string names;
        for (const io::Depth one : held) {
            names += (names.empty() ? "" : ", ") + std::string(io::info_of(one).name);
        }
        throw lutlib::UsageError("--depth " + depth + ": '" + path + "' can have " + names);
    }
    out.depth = row.depth;
    return out;
}

std::vector<float> alpha_for(const ShownPicture& picture, Size rendered) {
    std::vector<float> out;
    if (!picture.has_alpha) {
        return out;
    }
    const bool is_doubled =
        rendered.width / 2 >= 1 && static_cast<double>(rendered.width) / rendered.height >
                                       1.5 * picture.size.width / picture.size.height;
    const Size side{is_doubled ? rendered.width / 2 : rendered.width, rendered.height};
    for (std::uint32_t y = 0; y < rendered.height; ++y) {
        for (std::uint32_t x = 0; x < rendered.width; ++x) {
            out.push_back(mean_alpha(picture, side, x % side.width, y));
        }
    }
    return out;
}

io::PngImage code_image(const Rendered& rendered) {
    return png_of(float_image(rendered), 8);
}

std::vector<std::string> write_picture(const std::string& path, const Rendered& rendered,
                                       const FileFormat& format, Content content,
                                       const std::vector<float>& alpha) {
    io::FloatImage image = float_image(rendered);
    if (format.holds_light && content == Content::codes) {
        decode(image.rgba);
    }
    set_alpha(image, alpha);
    if (is_png(path)) {
        io::write_file(path,
                       io::write_png(png_of(image, format.depth == io::Depth::uint8 ? 8 : 16)));
        return {};
    }
    return write_as_stored(path, image, format);
}

std::vector<std::string> write_light(const std::string& path, const Rendered& rendered,
                                     const FileFormat& format, const std::vector<float>& alpha) {
    io::FloatImage image;
    image.width = static_cast<int>(rendered.hdr_size.width);
    image.height = static_cast<int>(rendered.hdr_size.height);
    image.rgba = rendered.hdr;
    image.depth = format.depth;
    set_alpha(image, alpha);
    return write_as_stored(path, image, format);
}

} // namespace preview
