// Which channels of a file are the picture: by their names, never by their place.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib::io {

/// A part of a file: a part of an OpenEXR file, a page of a TIFF.
struct PicturePart {
    std::string name; ///< empty where it has none
    std::vector<std::string> channels;
    int alpha = -1;        ///< the channel that the file type itself calls alpha
    bool by_place = false; ///< its type has no names: red, green, blue, alpha stand in this order
};

struct PictureChannels {
    std::size_t part = 0;
    std::string layer; ///< "" or what stands before the last point: "diffuse" of diffuse.R
    /// Red, green, blue and alpha among the part's channels; alpha -1: none. Grey: all three alike.
    std::array<int, 4> at{-1, -1, -1, -1};

    bool grey() const { return at[0] == at[1]; }
    bool has_alpha() const { return at[3] >= 0; }
};

/// Every picture in the parts, R, G and B (or one grey channel: Y, else the only one of R, G and B)
/// of one layer, with A where it is there. In the order in which one is taken: plain R, G, B first,
/// then layers called Combined, beauty or rgba, then in the file's order. Throws Error for Y with
/// RY and BY.
std::vector<PictureChannels> pictures_among(const std::vector<PicturePart>& parts,
                                            const std::string& file);

/// The name that `--layer` takes for it: the layer, else the part.
std::string layer_name(const PictureChannels& picture, const std::vector<PicturePart>& parts);

/// The one that `layer` names, the first where it is empty. Throws Error where there is none, and
/// lists what there is.
const PictureChannels& require_picture(const std::vector<PictureChannels>& pictures,
                                       const std::vector<PicturePart>& parts,
                                       std::string_view layer, const std::string& file);

/// What the user should know of the choice, a sentence each: channels and parts that pass through,
/// other pictures that could have been meant.
std::vector<std::string> channel_remarks(const PictureChannels& taken,
                                         const std::vector<PictureChannels>& pictures,
                                         const std::vector<PicturePart>& parts);

} // namespace lutlib::io
