#include "lutlib/io/ocio/write.h"

#include <sstream>

namespace lutlib::io {
namespace {

bool writes_operators(const std::string& ocio_name) {
    for (int i = 0; i < OCIO::GroupTransform::GetNumWriteFormats(); ++i) {
        if (ocio_name == OCIO::GroupTransform::GetFormatNameByIndex(i)) {
            return true;
        }
    }
    return false;
}

OCIO::ColorSpaceRcPtr color_space(const char* name) {
    const OCIO::ColorSpaceRcPtr out = OCIO::ColorSpace::Create();
    out->setName(name);
    return out;
}

void bake(const Lut& lut, const OCIO::GroupTransformRcPtr& group, const std::string& ocio_name,
          const std::string& title, std::ostream& out) {
    const OCIO::ConfigRcPtr config = plain_config()->createEditableCopy();
    const OCIO::ColorSpaceRcPtr look = color_space("look");
    look->setTransform(group, OCIO::COLORSPACE_DIR_FROM_REFERENCE);
    config->addColorSpace(color_space("input"));
    config->addColorSpace(look);
    const OCIO::BakerRcPtr baker = OCIO::Baker::Create();
    baker->setConfig(config);
    baker->setFormat(ocio_name.c_str());
    baker->setInputSpace("input");
    baker->setTargetSpace("look");
    if (lut.cube) {
        baker->setCubeSize(lut.cube->size);
    }
    if (!title.empty()) {
        baker->getFormatMetadata().addChildElement(OCIO::METADATA_DESCRIPTION, title.c_str());
    }
    baker->bake(out);
}

} // namespace

std::string write_with_ocio(const Lut& lut, const std::string& ocio_name,
                            const WriteOptions& options) {
    const std::string& title = options.title.empty() ? lut.title : options.title;
    const OCIO::GroupTransformRcPtr group = group_of_lut(lut, usual_interpolation(lut));
    std::ostringstream out;
    guarded({}, [&] {
        if (writes_operators(ocio_name)) {
            if (!title.empty()) {
                group->getFormatMetadata().setName(title.c_str());
            }
            for (const std::string& comment : lut.comments) {
                group->getFormatMetadata().addChildElement(OCIO::METADATA_DESCRIPTION,
                                                           comment.c_str());
            }
            const auto describe = [&](const char* element, const std::string& name) {
                if (!name.empty()) {
                    group->getFormatMetadata().addChildElement(element, name.c_str());
                }
            };
            describe(OCIO::METADATA_INPUT_DESCRIPTOR, lut.encodings.input);
            describe(OCIO::METADATA_OUTPUT_DESCRIPTOR, lut.encodings.output);
            group->write(plain_config(), ocio_name.c_str(), out);
        } else {
            bake(lut, group, ocio_name, title, out);
        }
    });
    return std::move(out).str();
}

} // namespace lutlib::io
