#include "converter/reference.h"

#include "converter/options.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/formats/opencolorio.h"
#include "lutlib/io/png.h"
#include "lutlib/io/recipe_file.h"

namespace converter {
namespace {

namespace io = lutlib::io;
using lutlib::Interpolation;

} // namespace

bool is_opencolorios(const std::string& bytes, const std::string& path) {
    return io::recognise_format(bytes, io::input_name(path)).opencolorio;
}

lutlib::Transform in_opencolorio(const std::string& bytes, const std::string& path,
                                 Interpolation how) {
    const std::string name = io::input_name(path);
    const lutlib::FileFormat& format = io::recognise_format(bytes, name);
    return io::ocio().parse(bytes, lutlib::formats::opencolorio_extension(format, path), name,
                            {.interpolation = how});
}

Reference::Reference(const std::string& path) : bytes_(io::read_file(path)), path_(path) {
    if (io::is_recipe(bytes_)) {
        recipe_ = lutlib::Transform::of(io::recipe_from(bytes_, path, read_lut));
    } else {
        lut_ =
            std::make_shared<const lutlib::Lut>(io::decode_lut(bytes_, io::input_name(path)).lut);
    }
}

lutlib::Transform Reference::oracle(Interpolation how) {
    if (recipe_) {
        return *recipe_;
    }
    if (how == Interpolation::nearest) {
        return lutlib::Transform::of(lut_, how);
    }
    const auto known = transforms_.find(how);
    return known != transforms_.end() ? known->second
                                      : transforms_.emplace(how, evaluator(how)).first->second;
}

std::string Reference::name(Interpolation how) const {
    if (recipe_) {
        return "the recipe, evaluated exactly";
    }
    return how == Interpolation::nearest
               ? "lutlib, exactly, as OpenColorIO has no nearest interpolation"
               : "OpenColorIO " + io::ocio().version();
}

lutlib::Transform Reference::evaluator(Interpolation how) {
    if (!io::is_png(bytes_) && refusal_.empty()) {
        try {
            return in_opencolorio(bytes_, path_, how);
        } catch (const lutlib::Error& error) {
            refusal_ = error.message();
        }
    }
    return io::ocio().from_lut(*lut_, {.interpolation = how});
}

} // namespace converter
