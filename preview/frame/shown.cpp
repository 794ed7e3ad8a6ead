#include "preview/frame/shown.h"

#include "lutlib/color/matrix.h"
#include "lutlib/error.h"
#include "lutlib/io/alpha.h"
#include "lutlib/io/image.h"
#include "lutlib/io/orientation.h"
#include "preview/look/odd_numbers.h"
#include "preview/scene/floor.h"
#include "preview/scene/import.h"

#include <filesystem>

namespace preview {

namespace {

/// Light of other primaries becomes that of Rec.709, which the tone maps take.
void to_rec709(std::vector<float>& rgba, const lutlib::Encoding& from) {
    const lutlib::Matrix3 matrix = lutlib::light_to_light(from, *lutlib::encoding_named("linear"));
    for (std::size_t at = 0; at + 3 < rgba.size(); at += 4) {
        const lutlib::Rgb c = lutlib::to_float(
            matrix * lutlib::to_double(lutlib::Rgb{rgba[at], rgba[at + 1], rgba[at + 2]}));
        rgba[at] = c.r;
        rgba[at + 1] = c.g;
        rgba[at + 2] = c.b;
    }
}

/// Reads a picture file; says of its colours what was made of them, by the name of the file.
/// `profile_is` tells what becomes of a colour profile.
bool has_transparency(const lutlib::io::FloatImage& image) {
    for (std::size_t i = 3; image.alpha && i < image.rgba.size(); i += 4) {
        if (image.rgba[i] != 1) {
            return true;
        }
    }
    return false;
}

ShownPicture read_picture(Shown& shown, const std::string& path, const std::string& profile_is) {
    const auto tell = [&](const std::string& line) { shown.told.push_back(path + ": " + line); };
    lutlib::io::FloatImage image = lutlib::io::read_image(path);
    if (image.source && image.source->orientation > 1) {
        image = upright(image, image.source->orientation);
    }
    const bool has_codes = lutlib::io::info_of(image.depth).integer;
    if (!has_codes) {
        for (const std::string& line : told_of(settle_odd_numbers(image.rgba))) {
            tell(line);
        }
    }
    if (image.premultiplied && has_transparency(image)) {
        make_straight(image);
        tell("its colours are multiplied by its alpha, and shown as they are without it");
    }
    const std::optional<lutlib::Encoding> encoding = encoding_of(image);
    ShownPicture picture;
    picture.display_encoded = has_codes;
    if (image.profile_tag) {
        tell("its colour profile is " + profile_is);
    }
    if (!picture.display_encoded && image.chromaticities && !encoding) {
        tell("its primaries are of no known gamut and taken for Rec.709's");
    } else if (!picture.display_encoded && encoding &&
               *encoding != *lutlib::encoding_named("linear")) {
        to_rec709(image.rgba, *encoding);
        tell("its light is converted from " + std::string(encoding->gamut->label) + " to Rec.709");
    }
    if (image.source) {
        for (const std::string& lost : image.source->beyond_text()) {
            shown.not_written.push_back(lost);
        }
    }
    picture.size = {static_cast<std::uint32_t>(image.width),
                    static_cast<std::uint32_t>(image.height)};
    picture.has_alpha = image.alpha;
    picture.rgba = std::move(image.rgba);
    return picture;
}

/// A name that has an ending or a folder is a file's, and nothing else.
void refuse_missing_file(const std::string& path) {
    const std::filesystem::path file(path);
    if ((file.has_extension() || file.has_parent_path()) && !std::filesystem::exists(file)) {
        throw lutlib::Error("cannot open the file: No such file or directory", {path, 0, {}});
    }
}

} // namespace

Shown load_shown(const std::string& input, double seconds) {
    Shown shown;
    shown.name = input;
    shown.seconds = seconds;
    if (const SceneInfo* info = scene_named(input)) {
        shown.scene = scene_at(*info, seconds);
        return shown;
    }
    refuse_missing_file(input);
    if (!std::filesystem::exists(input)) {
        std::string names;
        for (const SceneInfo& info : scenes()) {
            names += (names.empty() ? "" : ", ") + std::string(info.name);
        }
        throw lutlib::UsageError("'" + input +
                                 "' is neither a file nor a scene; scenes are: " + names);
    }
    if (is_model_file(input)) {
        ImportedScene imported = import_scene(input);
        shown.scene = std::move(imported.scene);
        shown.files = std::move(imported.files);
        if (!has_floor(*shown.scene)) {
            add_floor(*shown.scene);
        }
        shown.left_out = std::move(imported.left_out);
    } else {
        shown.picture = read_picture(shown, input,
                                     "not applied and not written: the codes are taken for those "
                                     "of --picture-encoding");
        shown.files = {input};
    }
    return shown;
}

void load_surroundings(Shown& shown, const std::string& path) {
    if (!shown.scene) {
        throw lutlib::UsageError("--surroundings stand about a scene, and '" + shown.name +
                                 "' is a picture: drop one of them");
    }
    refuse_missing_file(path);
    if (!std::filesystem::exists(path)) {
        throw lutlib::UsageError("--surroundings: '" + path +
                                 "' is neither a file nor one of the kinds of surroundings that "
                                 "--list has");
    }
    ShownPicture picture = read_picture(shown, path, "not applied: the codes are taken for sRGB");
    shown.not_written.clear(); // nobody looks for what this file says in pictures of the scene
    if (picture.display_encoded) {
        const lutlib::Encoding& display = lutlib::srgb();
        for (std::size_t at = 0; at < picture.rgba.size(); ++at) {
            if (at % 4 != 3) {
                picture.rgba[at] =
                    static_cast<float>(display.decode(static_cast<double>(picture.rgba[at])));
            }
        }
        picture.display_encoded = false;
        shown.told.push_back(path + ": it holds no light: its codes are decoded as sRGB");
    }
    shown.surroundings = std::move(picture);
    shown.surroundings_file = path;
    shown.files.push_back(path);
}

std::vector<std::string> told_of_surroundings(const Shown& shown) {
    std::vector<std::string> out;
    for (const std::string& line : shown.told) {
        if (!shown.surroundings_file.empty() && line.starts_with(shown.surroundings_file + ": ")) {
            out.push_back(line);
        }
    }
    return out;
}

Shown load_again(const Shown& shown) {
    Shown out = load_shown(shown.name, shown.seconds);
    if (!shown.surroundings_file.empty()) {
        load_surroundings(out, shown.surroundings_file);
    }
    return out;
}

GpuShown::GpuShown(const gpu::Device& device, std::shared_ptr<const Shown> shown)
    : shown_(std::move(shown)) {
    if (shown_->scene) {
        scene_.emplace(device, *shown_->scene);
    }
    if (shown_->picture) {
        picture_.emplace(device, shown_->picture->size, shown_->picture->rgba,
                         shown_->picture->display_encoded);
    }
    if (shown_->surroundings) {
        surroundings_.emplace(device, shown_->surroundings->size, shown_->surroundings->rgba,
                              false);
    }
}

FrameInputs GpuShown::inputs() const {
    FrameInputs out;
    out.scene = shown_->scene ? &*shown_->scene : nullptr;
    out.gpu_scene = scene_ ? &*scene_ : nullptr;
    out.picture = picture_ ? &*picture_ : nullptr;
    out.surroundings_picture = surroundings_ ? &*surroundings_ : nullptr;
    return out;
}

} // namespace preview
