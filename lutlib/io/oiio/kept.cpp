#include "lutlib/io/oiio/kept.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace lutlib::io {
namespace {

constexpr const char* icc_name = "ICCProfile";

bool about_color(std::string_view name) {
    constexpr std::array<std::string_view, 5> names{
        "chromaticities", "oiio:ColorSpace", "oiio:Gamma", "Exif:ColorSpace", "whiteLuminance"};
    return name.substr(0, std::strlen(icc_name)) == icc_name ||
           std::find(names.begin(), names.end(), name) != names.end();
}

// Of the file's own making, with no meaning in a file of another type.
bool about_file(std::string_view name) {
    constexpr std::array<std::string_view, 14> names{"compression",
                                                     "CompressionLevel",
                                                     "Orientation",
                                                     "screenWindowCenter",
                                                     "screenWindowWidth",
                                                     "name",
                                                     "type",
                                                     "tiles",
                                                     "planarconfig",
                                                     "oiio:subimages",
                                                     "oiio:subimagename",
                                                     "oiio:BitsPerSample",
                                                     "oiio:UnassociatedAlpha",
                                                     "worldtocamera"};
    constexpr std::array<std::string_view, 10> prefixes{
        "openexr:", "tiff:", "jpeg:", "png:", "dpx:", "targa:", "webp:", "bmp:", "psd:", "oiio:"};
    return std::find(names.begin(), names.end(), name) != names.end() ||
           std::any_of(prefixes.begin(), prefixes.end(), [&](std::string_view prefix) {
               return name.substr(0, prefix.size()) == prefix;
           });
}

void erase_color(OIIO::ImageSpec& spec) {
    std::vector<std::string> names;
    for (const auto& attribute : spec.extra_attribs) {
        if (about_color(attribute.name().string())) {
            names.push_back(attribute.name().string());
        }
    }
    for (const std::string& name : names) {
        spec.erase_attribute(name);
    }
}

bool holds_profile(const OIIO::ImageOutput& output) {
    constexpr std::array<std::string_view, 4> types{"jpeg", "tiff", "png", "webp"};
    return std::find(types.begin(), types.end(), output.format_name()) != types.end();
}

std::string joined(const std::vector<std::string>& names) {
    constexpr std::size_t most = 6;
    std::string out;
    for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
        out += (i == 0 ? "" : ", ") + names[i];
    }
    return names.size() > most ? out + " and " + std::to_string(names.size() - most) + " more"
                               : out;
}

bool has_display_window(const OIIO::ImageSpec& spec) {
    return spec.x != 0 || spec.y != 0 || spec.full_x != 0 || spec.full_y != 0 ||
           spec.full_width != spec.width || spec.full_height != spec.height;
}

std::string window_text(const OIIO::ImageSpec& spec) {
    return "the display window, " + std::to_string(spec.full_width) + "x" +
           std::to_string(spec.full_height) + " at " + std::to_string(spec.full_x - spec.x) + "," +
           std::to_string(spec.full_y - spec.y) + " of the picture";
}

// Where channel c of a pixel begins, and where the next pixel does.
std::size_t offset_of(const OIIO::ImageSpec& spec, int channel) {
    std::size_t out = 0;
    for (int c = 0; c < channel; ++c) {
        out += spec.channelformat(c).size();
    }
    return out;
}

} // namespace

std::vector<std::string> OiioSource::beside_picture() const {
    std::vector<std::string> out, channels;
    const OIIO::ImageSpec& spec = picture_spec();
    for (int c = 0; c < spec.nchannels; ++c) {
        if (std::find(picture.at.begin(), picture.at.end(), c) == picture.at.end()) {
            channels.push_back(spec.channel_name(c));
        }
    }
    if (!channels.empty()) {
        out.push_back("the channels " + joined(channels));
    }
    if (parts.size() > 1) {
        out.push_back(std::to_string(parts.size() - 1) + " other part" +
                      (parts.size() > 2 ? "s" : ""));
    }
    return out;
}

std::vector<std::string> OiioSource::beyond_text() const {
    std::vector<std::string> out = beside_picture(), names;
    const OIIO::ImageSpec& spec = picture_spec();
    if (has_display_window(spec)) {
        out.push_back(window_text(spec));
    }
    for (const auto& attribute : spec.extra_attribs) {
        const std::string name = attribute.name().string();
        const bool is_text = attribute.type() == OIIO::TypeDesc::STRING;
        if (!is_text && !about_file(name) && !about_color(name) && name != "PixelAspectRatio") {
            names.push_back(name);
        }
    }
    if (!names.empty()) {
        out.push_back("what it says of " + joined(names));
    }
    return out;
}

const OiioSource* kept_whole(const PictureSource* keep, std::string_view type,
                             const ImageInfo& image) {
    const auto* const source = dynamic_cast<const OiioSource*>(keep);
    if (!source || source->type != type || source->picture.grey() ||
        source->picture.has_alpha() != image.alpha) {
        return nullptr;
    }
    const OIIO::ImageSpec& spec = source->picture_spec();
    return spec.width == image.width && spec.height == image.height ? source : nullptr;
}

std::vector<OIIO::ImageSpec> specs_of(const OiioSource& keep, OIIO::TypeDesc type,
                                      bool keep_color) {
    std::vector<OIIO::ImageSpec> out;
    for (const KeptPart& part : keep.parts) {
        out.push_back(part.spec);
    }
    OIIO::ImageSpec& spec = out[keep.picture.part];
    std::vector<OIIO::TypeDesc> types;
    for (int c = 0; c < spec.nchannels; ++c) {
        types.push_back(spec.channelformat(c));
    }
    for (const int c : keep.picture.at) {
        if (c >= 0) {
            types[static_cast<std::size_t>(c)] = type;
        }
    }
    const bool alike = std::all_of(types.begin(), types.end(),
                                   [&](OIIO::TypeDesc t) { return t == types.front(); });
    spec.format = alike ? types.front() : type;
    spec.channelformats = alike ? std::vector<OIIO::TypeDesc>{} : types;
    if (!keep_color) {
        erase_color(spec);
    }
    return out;
}

std::vector<std::byte> pixels_of(const OiioSource& keep, const OIIO::ImageSpec& spec,
                                 const SampleImage& image) {
    const KeptPart& part = keep.parts[keep.picture.part];
    const auto& at = keep.picture.at;
    const auto in_order = [&](int c) { return c < 0 || at[static_cast<std::size_t>(c)] == c; };
    const bool is_whole = part.pixels.empty() && in_order(0) && in_order(1) && in_order(2) &&
                          (at[3] < 0 || at[3] == 3);
    if (is_whole) {
        return {};
    }
    const std::size_t count = image.pixels(), size = bytes_of(image.depth);
    const std::size_t own_stride = image.samples_a_pixel() * size;
    const std::size_t stride = offset_of(spec, spec.nchannels);
    const std::size_t kept_stride = offset_of(part.spec, part.spec.nchannels);
    std::vector<std::byte> out(count * stride);
    for (int c = 0; c < spec.nchannels; ++c) {
        const auto* const place = std::find(at.begin(), at.end(), c);
        const bool is_own = place != at.end();
        const std::byte* from =
            is_own ? image.samples.data() + static_cast<std::size_t>(place - at.begin()) * size
                   : part.pixels.data() + offset_of(part.spec, c);
        std::byte* to = &out[offset_of(spec, c)];
        const std::size_t bytes = spec.channelformat(c).size();
        for (std::size_t i = 0; i < count; ++i) {
            std::memcpy(to, from, bytes);
            from += is_own ? own_stride : kept_stride;
            to += stride;
        }
    }
    return out;
}

namespace {

void give_profile(OIIO::ImageSpec& spec, const OIIO::ImageOutput& output, const PictureSource& keep,
                  bool keep_color, std::vector<std::string>& lost) {
    if (keep.icc_profile.empty()) {
        return;
    }
    if (!keep_color) {
        lost.emplace_back("the colour profile, which is not true of the result");
    } else if (!holds_profile(output)) {
        lost.emplace_back("the colour profile");
    } else {
        spec.attribute(
            icc_name,
            OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(keep.icc_profile.size())),
            keep.icc_profile.data());
    }
}

void give_window(OIIO::ImageSpec& spec, const OIIO::ImageOutput& output,
                 const OIIO::ImageSpec& from, std::vector<std::string>& lost) {
    if (has_display_window(from)) {
        const bool is_negative = from.x < 0 || from.y < 0;
        if (output.supports("displaywindow") && output.supports("origin") &&
            (!is_negative || output.supports("negativeorigin"))) {
            spec.x = from.x;
            spec.y = from.y;
            spec.full_x = from.full_x;
            spec.full_y = from.full_y;
            spec.full_width = from.full_width;
            spec.full_height = from.full_height;
        } else {
            lost.push_back(window_text(from));
        }
    }
}

/// What can be given of the numbers and texts of a file; the names of the others to `names`.
void give_attributes(OIIO::ImageSpec& spec, const OIIO::ImageOutput& output,
                     const OiioSource& source, bool keep_color, std::vector<std::string>& names) {
    const bool any_text = output.supports("arbitrary_metadata") != 0;
    const bool is_same_type = source.type == output.format_name();
    for (const auto& attribute : source.picture_spec().extra_attribs) {
        const std::string name = attribute.name().string();
        if ((!is_same_type && about_file(name)) || (!keep_color && about_color(name)) ||
            name.substr(0, std::strlen(icc_name)) == icc_name || name == "oiio:ColorSpace") {
            continue;
        }
        const bool is_exif = name.substr(0, 5) == "Exif:" || name.substr(0, 4) == "GPS:";
        if (name == "PixelAspectRatio" && attribute.get_float() == 1) {
            continue;
        }
        if (any_text || (is_exif && output.supports("exif"))) {
            spec.extra_attribs.add_or_replace(attribute);
        } else if (attribute.type() != OIIO::TypeDesc::STRING) {
            names.push_back(name);
        }
    }
}

} // namespace

std::vector<std::string> give_metadata(OIIO::ImageSpec& spec, const OIIO::ImageOutput& output,
                                       const PictureSource& keep, bool keep_color) {
    std::vector<std::string> lost, names;
    const auto* const source = dynamic_cast<const OiioSource*>(&keep);
    give_profile(spec, output, keep, keep_color, lost);
    const bool any_text = output.supports("arbitrary_metadata") != 0;
    for (const auto& [key, value] : keep.text) {
        if (any_text || output.supports("exif")) {
            spec.attribute(key, value);
        } else {
            names.push_back(key);
        }
    }
    if (!source) {
        if (!names.empty()) {
            lost.push_back("what it says of " + joined(names));
        }
        return lost;
    }
    give_window(spec, output, source->picture_spec(), lost);
    give_attributes(spec, output, *source, keep_color, names);
    const std::vector<std::string> others = source->beside_picture();
    lost.insert(lost.end(), others.begin(), others.end());
    if (!names.empty()) {
        lost.push_back("what it says of " + joined(names));
    }
    return lost;
}

} // namespace lutlib::io
