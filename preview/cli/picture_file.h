// Rendered pictures as files.
#pragma once

#include "lutlib/io/image.h"
#include "lutlib/io/png.h"
#include "preview/cli/headless.h"
#include "preview/frame/shown.h"

#include <string>
#include <vector>

namespace preview {

/// How a file keeps a picture.
struct FileFormat {
    lutlib::io::Depth depth = lutlib::io::Depth::uint8;
    bool holds_light = false; ///< OpenEXR and Radiance: linear light, never codes

    /// Of the frame's picture: of 8 bits where the file needs no more.
    Format frame_format() const {
        return depth == lutlib::io::Depth::uint8 && !holds_light ? Format::rgba8 : Format::rgba32f;
    }
};

/// `depth` is the name of a row of lutlib::io::depths(), or empty: halves for light, else 8 bits.
/// Throws lutlib::UsageError for a depth that files of this name cannot have.
FileFormat file_format(const std::string& path, const std::string& depth);

/// What the numbers of a rendered picture are.
enum class Content : std::uint8_t {
    codes,   ///< of a display in sRGB; a file that holds light gets the light that they stand for
    numbers, ///< light, or any others: written as they are
};

/// The alpha of a picture at the size of what was rendered of it: the mean over each texel's area,
/// repeated for each side; empty where the file has none.
std::vector<float> alpha_for(const ShownPicture& picture, Size rendered);

/// The output in 8 bits without its alpha, tagged as sRGB.
lutlib::io::PngImage code_image(const Rendered& rendered);

/// PNG, or what OpenImageIO writes by that extension. `alpha` may be empty. The answer is what of
/// it the file does not hold, a phrase each. Throws lutlib::Error.
std::vector<std::string> write_picture(const std::string& path, const Rendered& rendered,
                                       const FileFormat& format, Content content = Content::codes,
                                       const std::vector<float>& alpha = {});

/// The same of the light before tone mapping.
std::vector<std::string> write_light(const std::string& path, const Rendered& rendered,
                                     const FileFormat& format,
                                     const std::vector<float>& alpha = {});

} // namespace preview
