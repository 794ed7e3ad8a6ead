#include "preview/cli/picture_file.h"

#include "lutlib/io/file.h"
#include "lutlib/io/image.h"

namespace preview {

lutlib::io::PngImage code_image(const Rendered& rendered) {
    lutlib::io::PngImage image;
    image.width = static_cast<int>(rendered.size.width);
    image.height = static_cast<int>(rendered.size.height);
    image.srgb_tag = true;
    for (std::size_t at = 0; at < rendered.rgba.size(); at += 4) {
        image.samples.insert(image.samples.end(), rendered.rgba.begin() + static_cast<long>(at),
                             rendered.rgba.begin() + static_cast<long>(at) + 3);
    }
    return image;
}

void write_picture(const std::string& path, const Rendered& rendered) {
    const lutlib::io::PngImage image = code_image(rendered);
    if (path == lutlib::io::standard_stream || lutlib::io::extension_of(path) == "png") {
        lutlib::io::write_file(path, lutlib::io::write_png(image));
        return;
    }
    lutlib::io::FloatImage floats{image.width, image.height, {}, 3, false, {}};
    for (const std::uint8_t code : rendered.rgba) {
        floats.rgba.push_back(static_cast<float>(code) / 255);
    }
    lutlib::io::write_image(path, floats, {lutlib::io::Depth::uint8, false, {}});
}

bool holds_light(const std::string& path) {
    const std::string extension = lutlib::io::extension_of(path);
    return extension == "exr" || extension == "hdr";
}

void write_light(const std::string& path, const Rendered& rendered) {
    const lutlib::io::FloatImage image{static_cast<int>(rendered.hdr_size.width),
                                       static_cast<int>(rendered.hdr_size.height),
                                       rendered.hdr,
                                       3,
                                       false,
                                       lutlib::io::Depth::half};
    lutlib::io::write_image(path, image, {lutlib::io::Depth::half, false, {}});
}

} // namespace preview
