// Pixels out of OpenImageIO: a picture's, and those of its file's other channels and parts.
#pragma once

#include "lutlib/io/oiio/kept.h"
#include "lutlib/io/oiio/part_reader.h"

#include <string>
#include <vector>

namespace lutlib::io {

/// How the file stores a picture's colours; where it stores them in several ways, as floats.
Depth picture_depth(const OIIO::ImageSpec& spec, const PictureChannels& picture);

/// Whether the picture's part has channels that are not the picture's.
bool has_others(const OIIO::ImageSpec& spec, const PictureChannels& picture);

/// The picture alone into `image`, whose samples are as large as image.bytes(). Throws Error about
/// `file`.
void decode(const PartReader& reader, const PictureChannels& picture, const std::string& file,
            SampleImage& image);

/// All parts, each with its pixels where the picture's are not all of them; of the picture's part,
/// how many are missing, to `missing`. Throws Error.
std::vector<KeptPart> kept_parts(const PartReader& reader, std::vector<OIIO::ImageSpec> specs,
                                 const PictureChannels& picture, const std::string& file,
                                 std::size_t& missing);

/// The picture out of a part that kept_parts() has read.
void gather(const KeptPart& part, const PictureChannels& picture, SampleImage& image);

} // namespace lutlib::io
