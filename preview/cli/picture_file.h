// Rendered pictures as files.
#pragma once

#include "lutlib/io/png.h"
#include "preview/cli/headless.h"

#include <string>

namespace preview {

/// The output without its alpha, tagged as sRGB.
lutlib::io::PngImage code_image(const Rendered& rendered);

/// PNG, or what OpenImageIO writes by that extension, in 8 bits. Throws lutlib::Error.
void write_picture(const std::string& path, const Rendered& rendered);

/// Whether a file of that name gets the light before tone mapping: OpenEXR and Radiance.
bool holds_light(const std::string& path);
/// The light before tone mapping, in half floats. Throws lutlib::Error.
void write_light(const std::string& path, const Rendered& rendered);

} // namespace preview
