// What a file read by OpenImageIO holds besides its picture, and its way into another file.
#pragma once

#include "lutlib/io/image.h"
#include "lutlib/io/picture_channels.h"

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <vector>

namespace lutlib::io {

struct KeptPart {
    OIIO::ImageSpec spec;
    /// Its channels in the file's own types, pixel by pixel; empty for a part whose channels are
    /// all the picture's.
    std::vector<std::byte> pixels;
};

struct OiioSource final : PictureSource {
    std::vector<KeptPart> parts;
    PictureChannels picture;

    const OIIO::ImageSpec& picture_spec() const { return parts[picture.part].spec; }
    /// Channels that are not the picture's, and other parts; a phrase each.
    std::vector<std::string> beside_picture() const;
    std::vector<std::string> beyond_text() const override;
};

/// Whether the parts of `keep` go into a file of this type as they are, beside `image`: it is of
/// the same type and size, and the picture has its own channels there. Else null.
const OiioSource* kept_whole(const PictureSource* keep, std::string_view type,
                             const ImageInfo& image);

/// The parts to write: those of `keep`, the picture's with channels of `type`.
std::vector<OIIO::ImageSpec> specs_of(const OiioSource& keep, OIIO::TypeDesc type, bool keep_color);

/// The picture's part as specs_of() says of its depth, with the picture's samples in their
/// channels; empty where they are all of it as they are.
std::vector<std::byte> pixels_of(const OiioSource& keep, const OIIO::ImageSpec& spec,
                                 const SampleImage& image);

/// Gives `spec`, of a file of another type, what `keep` says and that type holds; the answer is
/// what it does not.
std::vector<std::string> give_metadata(OIIO::ImageSpec& spec, const OIIO::ImageOutput& output,
                                       const PictureSource& keep, bool keep_color);

} // namespace lutlib::io
