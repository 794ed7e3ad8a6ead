// OpenImageIO behind oiio.h.

#include "lutlib/io/oiio.h"

#include "lutlib/error.h"
#include "lutlib/io/oiio/decode.h"
#include "lutlib/io/oiio/depths.h"
#include "lutlib/io/oiio/packed.h"
#include "lutlib/io/oiio/packing.h"
#include "lutlib/io/picture_channels.h"
#include "lutlib/io/picture_types.h"

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

bool is_premultiplied(const OIIO::ImageSpec& spec, std::string_view type) {
    return type == "openexr" ||
           (type == "tiff" && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0);
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

    SampleImage read(const std::string& path, const std::string& file,
                     const ImageReadOptions& options, const Allocate& allocate) const override {
        const auto input = opened(path, file);
        check_size(input->spec(), file);
        const std::string_view type = input->format_name();
        const std::vector<OIIO::ImageSpec> specs = parts_of(*input, file);
        const std::vector<PicturePart> parts = named_parts(specs, type);
        const std::vector<PictureChannels> pictures = pictures_among(parts, file);
        const PictureChannels picture = require_picture(pictures, parts, options.layer, file);
        const OIIO::ImageSpec& spec = specs[picture.part];
        check_size(spec, file);
        check_packing(spec, type, std::filesystem::file_size(path), file, options.partial);

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
        const PartReader reader(*input, path, options.partial);
        if (!has_others(spec, picture)) {
            decode(reader, picture, file, image);
        }
        source->parts = kept_parts(reader, specs, picture, file, image.missing_pixels);
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
        // JPEG 2000's writer makes nothing under a name without its extension, as boxes have them.
        return output && is_read_by(output->format_name()) &&
               std::string_view(output->format_name()) != "jpeg2000";
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

    SampleBuffer memory(std::size_t bytes) const override { return SampleBuffer(bytes); }

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
        const OIIO::TypeDesc type = type_of(image.depth);
        const bool drops_alpha = image.alpha && !output->supports("alpha");
        OIIO::ImageSpec spec(image.width, image.height, image.alpha && !drops_alpha ? 4 : 3, type);
        if (!image.premultiplied) {
            spec.attribute("oiio:UnassociatedAlpha", 1);
        }
        for (const auto& [key, value] : options.text) {
            spec.attribute(key, value);
        }
        std::vector<std::string> lost;
        if (drops_alpha) {
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
        const auto pixel = static_cast<OIIO::stride_t>(image.samples_a_pixel() * type.size());
        if (!output->write_image(type, image.samples.data(), pixel) || !output->close()) {
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
            if (own.find_attribute(key) == nullptr) {
                own.attribute(key, value);
            }
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
