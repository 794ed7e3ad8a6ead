// What a picture's file holds besides the picture's colours, kept so that it can be written again.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace lutlib::io {

struct PictureSource {
    PictureSource() = default;
    PictureSource(const PictureSource&) = default;
    PictureSource& operator=(const PictureSource&) = default;
    virtual ~PictureSource() = default;

    /// What a file that holds a picture, a profile and texts alone loses, a phrase each.
    virtual std::vector<std::string> beyond_text() const { return {}; }

    std::string type;        ///< "png", or OpenImageIO's name: "openexr", "tiff"
    std::string icc_profile; ///< its bytes; empty: none
    std::vector<std::pair<std::string, std::string>> text;
    /// Which way up the stored rows are, 1..8 as TIFF and Exif count (TIFF 6.0, "Orientation").
    int orientation = 1;
    bool premultiplied = false;         ///< as FloatImage::premultiplied
    std::vector<std::string> remarks{}; ///< of the choice of channels, a sentence each
};

} // namespace lutlib::io
