// OpenImageIO behind oiio.h.

#include "lutlib/io/oiio.h"

#include "lutlib/error.h"
#include "lutlib/io/oiio/kept.h"
#include "lutlib/io/oiio/packed.h"
#include "lutlib/io/oiio/packing.h"
#include "lutlib/io/picture_channels.h"
#include "lutlib/io/picture_types.h"
#include "lutlib/limits.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
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

// Some channels of a part, a pixel's one after the other.
struct Channels {
    const std::byte* first = nullptr;
    std::size_t stride = 0;           ///< bytes from a pixel to the next
    std::vector<std::size_t> offset;  ///< of each channel in a pixel
    std::vector<OIIO::TypeDesc> type; ///< of each channel
};

// Those that the picture has, to their places, as `image.depth`; grey three times.
void gather(const Channels& all, const PictureChannels& picture, int first, SampleImage& image) {
    const std::size_t size = bytes_of(image.depth), channels = image.samples_a_pixel();
    const OIIO::TypeDesc wanted = type_of(image.depth);
    for (std::size_t c = 0; c < channels; ++c) {
        const auto at = static_cast<std::size_t>(picture.at[c] - first);
        const std::byte* from = all.first + all.offset[at];
        std::byte* to = image.samples.data() + c * size;
        for (std::size_t i = 0; i < image.pixels(); ++i) {
            if (all.type[at] == wanted) {
                std::memcpy(to, from, size);
            } else {
                OIIO::convert_pixel_values(all.type[at], from, wanted, to, 1);
            }
            from += all.stride;
            to += channels * size;
        }
    }
}

// Pages and frames beyond these are not looked at.
constexpr int most_parts = 256;

std::vector<OIIO::ImageSpec> parts_of(OIIO::ImageInput& input, const std::string& file) {
    std::vector<OIIO::ImageSpec> out;
    for (int i = 0; i < most_parts && input.seek_subimage(i, 0); ++i) {
        out.push_back(input.spec());
        if (out.back().deep) {
            throw Error("the picture is deep; flatten it first", {file, 0, {}});
        }
    }
    input.geterror(); // that there is no further part
    return out;
}

std::vector<PicturePart> named_parts(const std::vector<OIIO::ImageSpec>& specs,
                                     std::string_view type) {
    std::vector<PicturePart> out;
    for (const OIIO::ImageSpec& spec : specs) {
        out.push_back({std::string(spec.get_string_attribute("oiio:subimagename")),
                       spec.channelnames, spec.alpha_channel, type != "openexr"});
    }
    return out;
}

// How the file stores a picture's colours; where it stores them in several ways, as floats.
Depth picture_depth(const OIIO::ImageSpec& spec, const PictureChannels& picture) {
    const Depth first = depth_of(spec.channelformat(picture.at[0]));
    const bool are_alike = std::all_of(picture.at.begin(), picture.at.end(), [&](int c) {
        return c < 0 || depth_of(spec.channelformat(c)) == first;
    });
    return are_alike ? first : Depth::float32;
}

bool is_premultiplied(const OIIO::ImageSpec& spec, std::string_view type) {
    return type == "openexr" ||
           (type == "tiff" && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0);
}

bool has_others(const OIIO::ImageSpec& spec, const PictureChannels& picture) {
    return spec.nchannels > (picture.has_alpha() ? 4 : 3);
}

// Texts and numbers of a file.
std::shared_ptr<OiioSource> source_of(OIIO::ImageInput& input, const OIIO::ImageSpec& spec,
                                      const PictureChannels& picture) {
    auto out = std::make_shared<OiioSource>();
    out->type = input.format_name();
    out->picture = picture;
    out->orientation = spec.get_int_attribute("Orientation", 1);
    if (const auto* const icc = spec.find_attribute("ICCProfile")) {
        out->icc_profile.assign(static_cast<const char*>(icc->data()), icc->type().size());
    }
    for (const auto& attribute : spec.extra_attribs) {
        const std::string name = attribute.name().string();
        const bool is_derived = name.find(':') != std::string::npos;
        if (attribute.type() == OIIO::TypeDesc::STRING && !is_derived && name != "compression") {
            out->text.emplace_back(name, attribute.get_string());
        }
    }
    return out;
}

// Its parts, each with its pixels where the picture's are not all of them.
std::vector<KeptPart> kept_parts(OIIO::ImageInput& input, std::vector<OIIO::ImageSpec> specs,
                                 const PictureChannels& picture, const std::string& path,
                                 const std::string& file) {
    std::vector<KeptPart> out;
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < specs.size(); ++i) {
        KeptPart part{std::move(specs[i]), {}};
        if (i != picture.part || has_others(part.spec, picture)) {
            const std::size_t own = part.spec.image_bytes(true);
            check_size(part.spec, file);
            bytes += own;
            if (bytes > limits::max_file_bytes) {
                throw Error("its other channels and parts are larger than " +
                                std::to_string(limits::max_file_bytes >> 20) + " MB",
                            {file, 0, {}});
            }
            part.pixels.resize(own);
            if (!input.read_image(static_cast<int>(i), 0, 0, part.spec.nchannels,
                                  OIIO::TypeDesc::UNKNOWN, part.pixels.data()) ||
                input.has_error()) {
                fail("cannot read the other channels", input.geterror(), path, file);
            }
        }
        out.push_back(std::move(part));
    }
    return out;
}

// The picture out of a part that has been read whole.
void gather(const KeptPart& part, const PictureChannels& picture, SampleImage& image) {
    Channels all{part.pixels.data(), 0, {}, {}};
    for (int c = 0; c < part.spec.nchannels; ++c) {
        all.offset.push_back(all.stride);
        all.type.push_back(part.spec.channelformat(c));
        all.stride += all.type.back().size();
    }
    gather(all, picture, 0, image);
}

// The picture alone.
void decode(OIIO::ImageInput& input, const PictureChannels& picture, const std::string& path,
            const std::string& file, SampleImage& image) {
    const auto [least, most] =
        std::minmax_element(picture.at.begin(), picture.at.end() - (image.alpha ? 0 : 1));
    const int first = *least, last = *most + 1;
    const auto count = static_cast<std::size_t>(last - first);
    const std::size_t size = bytes_of(image.depth);
    const bool is_in_place = picture.at[1] == first + 1 && picture.at[2] == first + 2 &&
                             (!image.alpha || picture.at[3] == first + 3);
    SampleBuffer apart = is_in_place ? SampleBuffer() : SampleBuffer(image.pixels() * count * size);
    std::byte* const to = is_in_place ? image.samples.data() : apart.data();
    const bool is_read =
        input.read_image(static_cast<int>(picture.part), 0, first, last, type_of(image.depth), to);
    // Of a file that ends early some readers tell so only here. WebP's complains whenever it goes
    // back to the first frame, which it has decoded by then.
    if (!is_read || (input.has_error() && std::string_view(input.format_name()) != "webp")) {
        fail("cannot read the pixels", input.geterror(), path, file);
    }
    if (!is_in_place) {
        Channels all{apart.data(), count * size, {}, {count, type_of(image.depth)}};
        for (std::size_t c = 0; c < count; ++c) {
            all.offset.push_back(c * size);
        }
        gather(all, picture, first, image);
    }
}

std::string head_of(const std::string& path) {
    std::string out(enough_to_tell_type, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(out.data(), static_cast<std::streamsize>(out.size()));
    out.resize(static_cast<std::size_t>(file.gcount()));
    return out;
}

// By the one reader that the bytes call for: OpenImageIO itself would try all that it has.
std::unique_ptr<OIIO::ImageInput> opened(const std::string& path, const std::string& file) {
    auto input = OIIO::ImageInput::create(std::string(reader_of(head_of(path), file)));
    if (!input) {
        fail("cannot read a picture of this type", OIIO::geterror(), path, file);
    }
    OIIO::ImageSpec found, config;
    // Without this, alpha would be multiplied into the colours of PNG, TIFF and others.
    config.attribute("oiio:UnassociatedAlpha", 1);
    if (!input->open(path, found, config)) {
        fail("cannot read the picture", input->geterror(), path, file);
    }
    return input;
}

class Library final : public Oiio {
  public:
    Library() { OIIO::attribute("plugin_searchpath", ""); }

    std::string version() const override { return OIIO_VERSION_STRING; }

    SampleImage read(const std::string& path, const std::string& file, const std::string& layer,
                     const Allocate& allocate) const override {
        const auto input = opened(path, file);
        check_size(input->spec(), file);
        const std::string_view type = input->format_name();
        const std::vector<OIIO::ImageSpec> specs = parts_of(*input, file);
        const std::vector<PicturePart> parts = named_parts(specs, type);
        const std::vector<PictureChannels> pictures = pictures_among(parts, file);
        const PictureChannels picture = require_picture(pictures, parts, layer, file);
        const OIIO::ImageSpec& spec = specs[picture.part];
        check_size(spec, file);
        check_packing(spec, type, std::filesystem::file_size(path), file);

        SampleImage image;
        image.width = spec.width;
        image.height = spec.height;
        image.alpha = picture.has_alpha();
        image.premultiplied = image.alpha && is_premultiplied(spec, type);
        image.channels = (picture.grey() ? 1 : 3) + (image.alpha ? 1 : 0);
        image.depth = picture_depth(spec, picture);
        image.holds_light = type == "openexr" || type == "hdr";
        std::array<float, 8> chromaticities{};
        if (spec.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8),
                              chromaticities.data())) {
            image.chromaticities = chromaticities;
        }
        // Not filled before it is read: of a file that ends early most is never touched.
        image.samples = allocate ? allocate(image.bytes()) : SampleBuffer(image.bytes());
        const auto source = source_of(*input, spec, picture);
        source->premultiplied = image.premultiplied;
        source->remarks = channel_remarks(picture, pictures, parts);
        if (!has_others(spec, picture)) {
            decode(*input, picture, path, file, image);
        }
        source->parts = kept_parts(*input, specs, picture, path, file);
        if (has_others(spec, picture)) {
            gather(source->parts[picture.part], picture, image);
        }
        image.source = source;
        input->close();
        return image;
    }

    Size size(const std::string& path) const override {
        Size out;
        for (const OIIO::ImageSpec& spec : parts_of(*opened(path, path), path)) {
            out.pixels += spec.image_pixels();
            out.bytes += spec.image_bytes(true);
        }
        return out;
    }

    bool writes(const std::string& path) const override {
        const auto output = OIIO::ImageOutput::create(path);
        OIIO::geterror(); // else it is printed when the program ends
        return output && is_read_by(output->format_name());
    }

    std::vector<std::string> written_extensions() const override {
        // "tiff:tif,tiff,tx;openexr:exr,sxr": of types that are read or written.
        std::vector<std::string> out;
        std::istringstream types(OIIO::get_string_attribute("extension_list"));
        for (std::string type; std::getline(types, type, ';');) {
            const std::size_t first = type.find(':') + 1;
            const std::string extension = type.substr(first, type.find(',') - first);
            if (writes("picture." + extension)) {
                out.push_back(extension);
            }
        }
        std::sort(out.begin(), out.end());
        return out;
    }

    Depth written_depth(const std::string& path, const std::string& name, const std::string& file,
                        Depth depth) const override {
        // Large enough for every type; JPEG 2000 wants several resolutions.
        SampleImage image;
        image.width = image.height = 64;
        image.depth = depth;
        image.samples = SampleBuffer(image.bytes());
        std::memset(image.samples.data(), 0, image.bytes());
        write(path, name, file, image, {.text = {}});
        // What the library says of a file that it writes is not always what it then wrote.
        return depth_of(opened(path, file)->spec().format);
    }

    std::vector<std::string> write(const std::string& path, const std::string& name,
                                   const std::string& file, const SampleImage& image,
                                   const ImageWriteOptions& options) const override {
        const auto output = OIIO::ImageOutput::create(name);
        if (!output || !is_read_by(output->format_name())) {
            fail("cannot write a picture of this type", OIIO::geterror(), path, file);
        }
        if (const OiioSource* const keep = kept_whole(options.keep, output->format_name(), image)) {
            write_parts(*output, *keep, path, file, image, options);
            return {};
        }
        OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.samples_a_pixel()),
                             type_of(image.depth));
        if (!image.premultiplied) {
            spec.attribute("oiio:UnassociatedAlpha", 1);
        }
        for (const auto& [key, value] : options.text) {
            spec.attribute(key, value);
        }
        std::vector<std::string> lost;
        if (image.alpha && !output->supports("alpha")) {
            lost.emplace_back("the alpha");
        }
        if (options.keep) {
            const std::vector<std::string> others =
                give_metadata(spec, *output, *options.keep, options.keep_color);
            lost.insert(lost.end(), others.begin(), others.end());
        }
        if (!output->open(path, spec)) {
            fail("cannot write the picture", output->geterror(), path, file);
        }
        if (!output->write_image(type_of(image.depth), image.samples.data()) || !output->close()) {
            fail("cannot write the pixels", output->geterror(), path, file);
        }
        return lost;
    }

    std::string packed(const PictureSource& source) const override {
        const auto* const own = dynamic_cast<const OiioSource*>(&source);
        return own ? packed_source(*own) : std::string();
    }

    std::shared_ptr<const PictureSource> unpacked(std::string_view bytes) const override {
        return unpacked_source(bytes);
    }

  private:
    // All parts of a file of the same type, the picture's with other colours.
    static void write_parts(OIIO::ImageOutput& output, const OiioSource& keep,
                            const std::string& path, const std::string& file,
                            const SampleImage& image, const ImageWriteOptions& options) {
        std::vector<OIIO::ImageSpec> specs =
            specs_of(keep, type_of(image.depth), options.keep_color);
        OIIO::ImageSpec& own = specs[keep.picture.part];
        if (image.alpha && !image.premultiplied) {
            own.attribute("oiio:UnassociatedAlpha", 1);
        } else {
            own.erase_attribute("oiio:UnassociatedAlpha");
        }
        for (const auto& [key, value] : options.text) {
            own.attribute(key, value);
        }
        const bool are_several = specs.size() > 1;
        for (std::size_t i = 0; i < specs.size(); ++i) {
            const bool is_open =
                i == 0 && are_several && output.supports("multiimage")
                    ? output.open(path, static_cast<int>(specs.size()), specs.data())
                    : output.open(path, specs[i],
                                  i == 0 ? OIIO::ImageOutput::Create
                                         : OIIO::ImageOutput::AppendSubimage);
            if (!is_open) {
                fail("cannot write the picture", output.geterror(), path, file);
            }
            const bool is_picture = i == keep.picture.part;
            const std::vector<std::byte> merged =
                is_picture ? pixels_of(keep, specs[i], image) : std::vector<std::byte>{};
            const std::byte* const pixels = !is_picture      ? keep.parts[i].pixels.data()
                                            : merged.empty() ? image.samples.data()
                                                             : merged.data();
            if (!output.write_image(OIIO::TypeDesc::UNKNOWN, pixels)) {
                fail("cannot write the pixels", output.geterror(), path, file);
            }
        }
        if (!output.close()) {
            fail("cannot write the pixels", output.geterror(), path, file);
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
