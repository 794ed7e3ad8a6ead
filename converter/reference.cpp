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

template <class F>
lutlib::Oracle each_color(F f) {
    return [f = std::move(f)](std::vector<lutlib::Rgb>& colors) {
        for (lutlib::Rgb& color : colors) {
            color = to_float(f(to_double(color)));
        }
    };
}

} // namespace

bool is_opencolorios(const std::string& bytes, const std::string& path) {
    return io::recognise_format(bytes, io::input_name(path)).opencolorio;
}

std::shared_ptr<const io::OcioTransform>
in_opencolorio(const std::string& bytes, const std::string& path, Interpolation how) {
    const std::string name = io::input_name(path);
    const lutlib::FileFormat& format = io::recognise_format(bytes, name);
    return io::ocio().parse(bytes, lutlib::formats::opencolorio_extension(format, path), name,
                            {.interpolation = how});
}

Reference::Reference(const std::string& path) : bytes_(io::read_file(path)), path_(path) {
    if (io::is_recipe(bytes_)) {
        recipe_.emplace(io::recipe_from(bytes_, path, read_lut));
    } else {
        lut_ = io::decode_lut(bytes_, io::input_name(path)).lut;
    }
}

lutlib::Oracle Reference::oracle(Interpolation how) {
    if (recipe_) {
        return each_color(*recipe_);
    }
    if (how == Interpolation::nearest) {
        return each_color([lut = std::make_shared<const lutlib::Lut>(lut_)](lutlib::RgbD in) {
            return evaluate_exact(*lut, in, Interpolation::nearest);
        });
    }
    auto& transform = transforms_[how];
    if (!transform) {
        transform = evaluator(how);
    }
    return [transform](std::vector<lutlib::Rgb>& colors) { transform->apply(colors); };
}

std::string Reference::name(Interpolation how) const {
    if (recipe_) {
        return "the recipe, evaluated exactly";
    }
    return how == Interpolation::nearest
               ? "lutlib, exactly, as OpenColorIO has no nearest interpolation"
               : "OpenColorIO " + io::ocio().version();
}

std::shared_ptr<const io::OcioTransform> Reference::evaluator(Interpolation how) {
    if (!io::is_png(bytes_) && refusal_.empty()) {
        try {
            return in_opencolorio(bytes_, path_, how);
        } catch (const lutlib::Error& error) {
            refusal_ = error.message();
        }
    }
    return io::ocio().from_lut(lut_, {.interpolation = how});
}

} // namespace converter
