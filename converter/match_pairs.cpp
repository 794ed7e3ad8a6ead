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

// Codes of light are far apart where the eye sees most: a lattice wants them spaced as for a
// display.
lutlib::Encoding for_a_lattice(const lutlib::Encoding& pictures) {
    return pictures.curve->name == "linear" ? lutlib::srgb() : pictures;
}

lutlib::Picture colors_of(const io::FloatImage& image, const lutlib::Conversion& to_look) {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    lutlib::Picture out{image.width, image.height, {}};
    out.pixels.reserve(image.pixels());
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const bool is_seen = image.rgba[i + 3] > 0;
        out.pixels.push_back(is_seen
                                 ? lutlib::Rgb{image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]}
                                 : lutlib::Rgb{none, none, none});
    }
    if (to_look.from == to_look.to) {
        return out;
    }
    // NaN reads as 0 in every conversion.
    const lutlib::Transform convert = lutlib::conversion(to_look);
    const std::vector<lutlib::RgbD> converted = images_of(convert, out.pixels);
    for (std::size_t i = 0; i < converted.size(); ++i) {
        lutlib::Rgb& pixel = out.pixels[i];
        const bool is_there = std::isfinite(largest_magnitude(to_double(pixel)));
        pixel = is_there ? to_float(converted[i]) : lutlib::Rgb{none, none, none};
    }
    return out;
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

PicturePair read_pair(const PairPaths& paths, const PairEncodings& encodings) {
    const Read before = read_upright(paths.before), after = read_upright(paths.after);
    if (before.image.width != after.image.width || before.image.height != after.image.height) {
        throw lutlib::Error(
            fmt::format("it has {}x{} pixels and {} {}x{}: give pictures of one size, in which "
                        "each pixel is the other's",
                        after.image.width, after.image.height, input_text(paths.before),
                        before.image.width, before.image.height),
            {io::input_name(paths.after), 0, {}});
    }
    PicturePair out;
    const auto said = [&](const std::optional<lutlib::Encoding>& named, const io::FloatImage& image,
                          const std::string& path, const char* option) {
        const std::optional<lutlib::Encoding> known = named ? named : encoding_of(image);
        if (!known) {
            out.remarks.push_back(
                fmt::format("{}: its encoding is not known and taken for srgb: if "
                            "it is another, name it with {}",
                            input_text(path), option));
        }
        return known.value_or(lutlib::srgb());
    };
    const lutlib::Encoding from =
        said(encodings.pictures.input, before.image, paths.before, "--before-encoding");
    const lutlib::Encoding to =
        said(encodings.pictures.output, after.image, paths.after, "--after-encoding");
    out.look = {encodings.look.input.value_or(for_a_lattice(from)),
                encodings.look.output.value_or(for_a_lattice(to))};
    out.before = colors_of(before.image, {from, *out.look.input});
    out.after = colors_of(after.image, {to, *out.look.output});
    const io::DepthInfo& depth = io::info_of(after.image.depth);
    // Codes that were converted are no longer those of the file.
    out.bits = depth.integer && to == out.look.output
                   ? 8 * static_cast<int>(io::bytes_of(depth.depth))
                   : 0;
    for (const auto& [path, harm] :
         {std::pair(&paths.before, &before.harm), std::pair(&paths.after, &after.harm)}) {
        if (!harm->empty()) {
            out.remarks.push_back(input_text(*path) + ": " + *harm);
        }
    }
    return out;
}

} // namespace converter
