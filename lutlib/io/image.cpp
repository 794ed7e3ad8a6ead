#include "lutlib/io/image.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/icc.h"
#include "lutlib/io/oiio.h"
#include "lutlib/io/pending_file.h"
#include "lutlib/io/picture_types.h"
#include "lutlib/io/png.h"
#include "lutlib/io/samples.h"
#include "lutlib/io/temporary_file.h"
#include "lutlib/limits.h"
#include "lutlib/named.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib::io {
namespace {

constexpr std::array<DepthInfo, 4> depth_rows{{
    {Depth::uint8, "uint8", true},
    {Depth::uint16, "uint16", true},
    {Depth::half, "half", false},
    {Depth::float32, "float", false},
}};

struct PngSource final : PictureSource {
    std::vector<PngChunk> chunks;
};

// All but its pixels.
SampleImage described(const PngPicture& codes) {
    SampleImage out;
    out.width = codes.width;
    out.height = codes.height;
    out.alpha = codes.channels == 4;
    out.channels = (codes.grey ? 1 : 3) + (out.alpha ? 1 : 0);
    out.srgb_tag = codes.srgb_tag;
    out.profile_tag = codes.profile_tag;
    out.depth = codes.bits == 16 ? Depth::uint16 : Depth::uint8;
    out.missing_pixels =
        static_cast<std::size_t>(codes.missing_rows) * static_cast<std::size_t>(codes.width);
    return out;
}

std::shared_ptr<const PictureSource> source_of(PngPicture&& codes, std::string_view bytes) {
    const auto out = std::make_shared<PngSource>();
    out->type = "png";
    out->icc_profile = std::move(codes.icc_profile);
    out->text = std::move(codes.text);
    out->chunks = kept_chunks(bytes);
    return out;
}

// The chunks of a PNG go into a PNG as they are; of other files what a PNG has a place for.
std::vector<std::string> keep_in_png(PngPicture& png, const ImageWriteOptions& options) {
    std::vector<std::string> lost;
    const PictureSource& keep = *options.keep;
    if (const auto* const source = dynamic_cast<const PngSource*>(&keep)) {
        for (const PngChunk& chunk : source->chunks) {
            if (options.keep_color || !chunk.about_color) {
                png.chunks.push_back(chunk);
            } else {
                lost.push_back("the chunk " + chunk.name() + ", which is not true of the result");
            }
        }
        return lost;
    }
    if (!keep.icc_profile.empty() && options.keep_color) {
        png.icc_profile = keep.icc_profile;
    } else if (!keep.icc_profile.empty()) {
        lost.emplace_back("the colour profile, which is not true of the result");
    }
    constexpr std::size_t longest_key = 79;
    for (const auto& [key, value] : keep.text) {
        if (!key.empty() && key.size() <= longest_key) {
            png.text.emplace_back(key, value);
        }
    }
    const std::vector<std::string> others = keep.beyond_text();
    lost.insert(lost.end(), others.begin(), others.end());
    return lost;
}

bool is_png_name(const std::string& path) {
    return path == standard_stream || extension_of(path) == "png";
}

} // namespace

std::optional<Encoding> encoding_of(const ImageInfo& image) {
    if (image.srgb_tag) {
        return srgb();
    }
    if (!image.holds_light) {
        return image.source && info_of(image.depth).integer
                   ? encoding_of_profile(image.source->icc_profile)
                   : std::nullopt;
    }
    const std::optional<Encoding> light = encoding_named("linear");
    if (!image.chromaticities) {
        return light; // OpenEXR's default is Rec.709
    }
    constexpr double rounding = 1e-3;
    for (const Gamut* const gamut : gamuts()) {
        const Primaries& p = gamut->primaries;
        const std::array<double, 8> wanted{p.red.x,  p.red.y,  p.green.x, p.green.y,
                                           p.blue.x, p.blue.y, p.white.x, p.white.y};
        if (std::equal(wanted.begin(), wanted.end(), image.chromaticities->begin(),
                       [](double a, float b) {
                           return std::abs(a - static_cast<double>(b)) < rounding;
                       })) {
            return Encoding{light->curve, gamut};
        }
    }
    return std::nullopt;
}

std::span<const DepthInfo> depths() {
    return depth_rows;
}

const DepthInfo& info_of(Depth depth) {
    return *std::find_if(depth_rows.begin(), depth_rows.end(),
                         [depth](const DepthInfo& row) { return row.depth == depth; });
}

SampleImage decode_samples(std::string_view bytes, const std::string& extension,
                           const std::string& file, const ImageReadOptions& options) {
    if (is_png(bytes)) {
        if (!options.layer.empty()) {
            throw UsageError("a PNG has no layers; leave out --layer", {file, 0, {}});
        }
        PngPicture picture = read_png_picture(bytes, file, options.partial);
        SampleImage out = described(picture);
        out.samples = std::move(picture.samples);
        out.source = source_of(std::move(picture), bytes);
        return out;
    }
    const TemporaryFile copy(bytes, file, extension);
    return oiio().read(copy.path(), file, options);
}

std::size_t bytes_in_work(const std::string& path) {
    // Floats of four channels, the codes read and those to write, and the file's bytes.
    constexpr std::size_t bytes_a_pixel = 48, png_header = 24;
    try {
        const auto head = head_of_regular_file(path, png_header);
        if (head && is_png(*head)) {
            return pixels_of_png(*head) * bytes_a_pixel;
        }
        const Oiio::Size size = head ? oiio().size(path) : Oiio::Size{};
        return size.pixels * bytes_a_pixel + 2 * size.bytes;
    } catch (const Error&) {
        return 0;
    }
}

SampleImage read_samples(const std::string& path, const ImageReadOptions& options) {
    constexpr std::size_t enough_to_tell = 8;
    const auto head = head_of_regular_file(path, enough_to_tell);
    if (!head || is_png(*head)) {
        return decode_samples(read_file(path), extension_of(path), input_name(path), options);
    }
    return oiio().read(path, path, options);
}

FloatImage decode_image(std::string_view bytes, const std::string& extension,
                        const std::string& file, const ImageReadOptions& options) {
    return floats_of(decode_samples(bytes, extension, file, options));
}

FloatImage read_image(const std::string& path, const ImageReadOptions& options) {
    return floats_of(read_samples(path, options));
}

std::vector<Depth> depths_of(const std::string& path) {
    if (is_png_name(path)) {
        return {Depth::uint8, Depth::uint16};
    }
    if (!oiio().writes(path)) {
        const std::string extension = extension_of(path);
        const std::vector<std::string> known = oiio().written_extensions();
        throw UsageError(
            "no type of picture that can be written has the extension '" + extension + "'; " +
                what_there_is(extension, std::vector<std::string_view>(known.begin(), known.end())),
            {path, 0, {}});
    }
    std::vector<Depth> out;
    std::optional<PendingFile> beside; // so that a folder that takes no file is told now
    std::optional<TemporaryFile> elsewhere;
    const std::string& trial = is_special(path)
                                   ? elsewhere.emplace(std::string_view(), path, "").path()
                                   : beside.emplace(path).path();
    for (const DepthInfo& row : depth_rows) {
        const Depth written = oiio().written_depth(trial, path, path, row.depth);
        if (std::find(out.begin(), out.end(), written) == out.end()) {
            out.push_back(written);
        }
    }
    std::sort(out.begin(), out.end());
    return out;
}

Depth nearest_depth(Depth depth, std::span<const Depth> held) {
    // Half holds every 8-bit code apart, 16-bit codes need float.
    constexpr std::array<std::array<Depth, 4>, 4> by_loss{{
        {Depth::uint8, Depth::uint16, Depth::half, Depth::float32},
        {Depth::uint16, Depth::float32, Depth::half, Depth::uint8},
        {Depth::half, Depth::float32, Depth::uint16, Depth::uint8},
        {Depth::float32, Depth::half, Depth::uint16, Depth::uint8},
    }};
    const auto& row = *std::find_if(by_loss.begin(), by_loss.end(),
                                    [depth](const auto& r) { return r.front() == depth; });
    return *std::find_first_of(row.begin(), row.end(), held.begin(), held.end());
}

bool stores_premultiplied(const std::string& path, const PictureSource* keep) {
    const std::string extension = extension_of(path);
    if (extension == "exr" || extension == "sxr") {
        return true;
    }
    const bool is_tiff = extension == "tif" || extension == "tiff";
    return is_tiff && keep && keep->type == "tiff" && keep->premultiplied;
}

bool holds_orientation(const std::string& path, const PictureSource& keep) {
    const PictureType* const type = picture_type_of({}, path);
    return type && (type->reader == "jpeg" || type->reader == "tiff" || type->reader == keep.type);
}

SampleBuffer samples_for(const std::string& path, const SampleImage& image) {
    return is_png_name(path) ? SampleBuffer() : oiio().memory(image.bytes());
}

std::vector<std::string> write_image(const std::string& path, const FloatImage& image,
                                     const ImageWriteOptions& options) {
    const auto memory = [&path](const SampleImage& like) { return samples_for(path, like); };
    return write_samples(path, samples_of(image, options.depth, options.alpha, memory), options);
}

std::vector<std::string> write_samples(const std::string& path, SampleImage image,
                                       const ImageWriteOptions& options) {
    if (is_special(path) && !is_png_name(path)) {
        const TemporaryFile whole({}, path, "");
        std::vector<std::string> lost = oiio().write(whole.path(), path, path, image, options);
        write_file(path, read_file(whole.path()));
        return lost;
    }
    if (!is_png_name(path)) {
        PendingFile pending(path);
        std::vector<std::string> lost = oiio().write(pending.path(), path, path, image, options);
        pending.commit();
        return lost;
    }
    PngPicture png;
    png.width = image.width;
    png.height = image.height;
    png.channels = image.alpha ? 4 : 3;
    png.bits = static_cast<int>(bytes_of(image.depth) * 8);
    png.samples = std::move(image.samples);
    png.text = options.text;
    std::vector<std::string> lost =
        options.keep ? keep_in_png(png, options) : std::vector<std::string>{};
    write_file(path, write_png(png));
    return lost;
}

} // namespace lutlib::io
