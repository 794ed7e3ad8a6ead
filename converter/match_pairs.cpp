#include "converter/match_pairs.h"

#include "converter/many.h"
#include "converter/report.h"
#include "lutlib/error.h"
#include "lutlib/io/alpha.h"
#include "lutlib/io/file.h"
#include "lutlib/io/image.h"
#include "lutlib/io/inputs.h"
#include "lutlib/io/orientation.h"
#include "lutlib/io/picture_types.h"
#include "lutlib/recipe/placement.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <utility>

namespace converter {
namespace {

namespace io = lutlib::io;

// By what files of two lists belong together: the number of a frame, else the name.
std::string partner_key(const io::InputFile& file, bool by_frame) {
    if (!by_frame) {
        return std::filesystem::path(file.path).stem().string();
    }
    const std::size_t digit = file.frame.find_first_not_of('0');
    return digit == std::string::npos ? "" : file.frame.substr(digit);
}

std::map<std::string, std::string> keyed(const io::Inputs& inputs, bool by_frame) {
    std::map<std::string, std::string> out;
    for (const io::InputFile& file : inputs.files) {
        const auto [at, is_new] = out.emplace(partner_key(file, by_frame), file.path);
        if (!is_new) {
            throw lutlib::Error("it and " + input_text(at->second) +
                                    " could both be the partner of one picture; name the pairs one "
                                    "by one, BEFORE AFTER",
                                {file.path, 0, {}});
        }
    }
    return out;
}

void append_pairs(const io::Inputs& before, const io::Inputs& after, const std::string& words,
                  std::vector<PairPaths>& out) {
    if (!before.are_listed && !after.are_listed) {
        out.push_back({before.files.front().path, after.files.front().path});
        return;
    }
    const bool by_frame = words.find_first_of("#%") != std::string::npos;
    const std::map<std::string, std::string> of_before = keyed(before, by_frame),
                                             of_after = keyed(after, by_frame);
    for (const auto& [lists, others] :
         {std::pair(&of_before, &of_after), std::pair(&of_after, &of_before)}) {
        for (const auto& [key, path] : *lists) {
            if (!others->contains(key)) {
                throw lutlib::Error(std::string("it has no partner of the same ") +
                                        (by_frame ? "frame" : "name") + " in " + words,
                                    {path, 0, {}});
            }
        }
    }
    for (const auto& [key, path] : of_before) {
        out.push_back({path, of_after.at(key)});
    }
}

struct Read {
    io::FloatImage image; ///< upright and straight
    std::string harm;     ///< what its file type does to codes; empty: it keeps them
};

Read read_upright(const std::string& path) {
    const std::string bytes = io::read_file(path), file = io::input_name(path);
    Read out{io::decode_image(bytes, io::extension_of(path), file), {}};
    make_straight(out.image);
    const int orientation = out.image.source ? out.image.source->orientation : 1;
    if (orientation > 1) {
        out.image = upright(out.image, orientation);
    }
    const io::PictureType* const type = io::picture_type_of(bytes, file);
    if (type && !type->harm.empty() && (!type->harms || type->harms(bytes))) {
        out.harm = type->harm;
    }
    return out;
}

lutlib::Picture colors_of(const io::FloatImage& image) {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    lutlib::Picture out{image.width, image.height, {}};
    out.pixels.reserve(image.pixels());
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const bool is_seen = image.rgba[i + 3] > 0;
        out.pixels.push_back(is_seen
                                 ? lutlib::Rgb{image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]}
                                 : lutlib::Rgb{none, none, none});
    }
    return out;
}

// What is not finite stays so; conversions would read NaN as 0.
void convert(lutlib::Picture& picture, const lutlib::Conversion& to) {
    if (to.from == to.to) {
        return;
    }
    const std::vector<lutlib::RgbD> converted = images_of(lutlib::conversion(to), picture.pixels);
    for (std::size_t i = 0; i < converted.size(); ++i) {
        if (std::isfinite(largest_magnitude(to_double(picture.pixels[i])))) {
            picture.pixels[i] = to_float(converted[i]);
        }
    }
}

struct Taken {
    LonePicture picture;
    int bits = 0; ///< of a sample; 0: floats
    bool is_lossy = false;
};

Taken take(const std::string& path, const std::optional<lutlib::Encoding>& named,
           const char* option) {
    const Read read = read_upright(path);
    const std::optional<lutlib::Encoding> known = named ? named : encoding_of(read.image);
    const io::DepthInfo& depth = io::info_of(read.image.depth);
    Taken out{{colors_of(read.image), known.value_or(lutlib::srgb()), {}},
              depth.integer ? 8 * static_cast<int>(io::bytes_of(depth.depth)) : 0,
              !read.harm.empty()};
    if (!known) {
        out.picture.remarks.push_back(
            fmt::format("{}: its encoding is not known and taken for srgb: if it is another, name "
                        "it with {}",
                        input_text(path), option));
    }
    if (!read.harm.empty()) {
        out.picture.remarks.push_back(input_text(path) + ": " + read.harm);
    }
    return out;
}

void lay_on_each_other(PicturePair& pair, const PairPaths& paths) {
    const lutlib::Where where{io::input_name(paths.after), 0, {}};
    pair.shift = find_shift(pair.before, pair.after);
    const lutlib::Pixel by = pair.shift.by;
    if (const std::optional<lutlib::Pixel> apart = distortion_in(pair.before, pair.after, by)) {
        throw lutlib::Error(
            fmt::format("it was scaled, turned or bent: parts of it have moved by {} pixels "
                        "sideways and {} up or down against each other since {}; give pictures in "
                        "which each pixel is the other's",
                        apart->x, apart->y, input_text(paths.before)),
            where);
    }
    if (by != lutlib::Pixel{}) {
        pair.after = moved_back(pair.after, by);
        pair.remarks.push_back(
            fmt::format("{}: it lies {}, {} pixels beside {}, and was moved back",
                        input_text(paths.after), by.x, by.y, input_text(paths.before)));
    }
    constexpr double seen = 0.25;
    if (std::max(std::abs(pair.shift.x_beyond), std::abs(pair.shift.y_beyond)) > seen) {
        pair.remarks.push_back(
            fmt::format("{}: it lies {:.1f}, {:.1f} pixels beside {} even so, which nothing here "
                        "mends; its edges are learnt from less",
                        input_text(paths.after), pair.shift.x_beyond, pair.shift.y_beyond,
                        input_text(paths.before)));
    }
}

} // namespace

std::vector<PairPaths> pairs_of(std::span<const std::string> words, const std::string& frames) {
    if (words.size() % 2 != 0) {
        throw lutlib::UsageError(
            fmt::format("pictures come in pairs, BEFORE AFTER and again; {} has no partner",
                        input_text(words.back())));
    }
    std::vector<PairPaths> out;
    for (std::size_t i = 0; i < words.size(); i += 2) {
        const auto found = [&](const std::string& word) {
            const io::Inputs inputs =
                io::find_inputs(std::array{word}, frames, [](const std::string& extension) {
                    return io::is_picture_extension(extension);
                });
            tell_remarks(inputs.remarks);
            return inputs;
        };
        append_pairs(found(words[i]), found(words[i + 1]), words[i] + " and " + words[i + 1], out);
    }
    return out;
}

lutlib::Encoding for_a_lattice(const lutlib::Encoding& pictures) {
    return pictures.curve->name == "linear" ? lutlib::srgb() : pictures;
}

LonePicture read_lone(const std::string& path, const std::optional<lutlib::Encoding>& encoding,
                      const char* option) {
    return take(path, encoding, option).picture;
}

PicturePair read_pair(const PairPaths& paths, const PairEncodings& encodings) {
    Taken before = take(paths.before, encodings.pictures.input, "--before-encoding"),
          after = take(paths.after, encodings.pictures.output, "--after-encoding");
    const lutlib::PictureSize was = before.picture.colors.size(), is = after.picture.colors.size();
    if (was != is) {
        throw lutlib::Error(
            fmt::format("it has {}x{} pixels and {} {}x{}: give pictures of one size, in which "
                        "each pixel is the other's",
                        is.width, is.height, input_text(paths.before), was.width, was.height),
            {io::input_name(paths.after), 0, {}});
    }
    PicturePair out;
    const lutlib::Encoding from = before.picture.encoding, to = after.picture.encoding;
    out.look = {encodings.look.input.value_or(for_a_lattice(from)),
                encodings.look.output.value_or(for_a_lattice(to))};
    convert(before.picture.colors, {from, *out.look.input});
    convert(after.picture.colors, {to, *out.look.output});
    out.before = std::move(before.picture.colors);
    out.after = std::move(after.picture.colors);
    // Codes that were converted are no longer those of the file.
    out.bits = to == out.look.output ? after.bits : 0;
    out.is_lossy = after.is_lossy;
    out.remarks = std::move(before.picture.remarks);
    out.remarks.insert(out.remarks.end(), after.picture.remarks.begin(),
                       after.picture.remarks.end());
    lay_on_each_other(out, paths);
    return out;
}

} // namespace converter
