#include "preview/look/look_file.h"

#include "lutlib/engine/recognise.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/io/png.h"
#include "lutlib/io/recipe_file.h"
#include "lutlib/recipe/bake_recipe.h"
#include "preview/look/recipe_table.h"

namespace preview {

namespace {

using lutlib::CodePicture;
using lutlib::Lut;

LoadedLook from_picture_file(const std::string& bytes, const std::string& path,
                             const Lookup* lookup) {
    const CodePicture codes = lutlib::io::code_picture(lutlib::io::read_png(bytes, path));
    const lutlib::Picture picture = lutlib::decoded(codes);
    const lutlib::Recognition found = lutlib::recognise_one(picture, path);
    Lut look;
    look.cube = lutlib::from_picture(picture, *found.layout, found.size);
    if (lookup == nullptr)
        lookup = lookup_named(found.layout->name == "strip" ? "strip" : "trilinear");
    if (lookup->source == Lookup::Source::table)
        return look_for(look, *lookup);
    if (found.layout->name != lookup->layout)
        throw lutlib::UsageError("the lookup '" + std::string(lookup->name) +
                                 "' reads pictures in the layout '" + std::string(lookup->layout) +
                                 "' and '" + path + "' is in '" + std::string(found.layout->name) +
                                 "': bake it with lutconv for that engine");
    LoadedLook out;
    out.skip_reason = lookup->engine == nullptr ? skip_reason_of(look) : "";
    out.data = look_data(codes, found.size, *lookup);
    out.table = std::make_shared<const Lut>(std::move(look));
    return out;
}

LoadedLook look_of_recipe(const lutlib::Recipe& recipe, const Lookup& lookup) {
    if (lookup.source != Lookup::Source::table)
        return look_for(lutlib::bake_recipe(recipe), lookup);
    return measured_look(*measured_table(recipe), lookup);
}

} // namespace

LoadedLook load_look(const std::string& path, const Lookup* lookup) {
    if (path.empty() || path == "none")
        return {no_look(), "there is none", {}, nullptr};
    const std::string bytes = lutlib::io::read_file(path);
    if (lutlib::io::is_png(bytes))
        return from_picture_file(bytes, path, lookup);
    if (lookup == nullptr)
        lookup = lookup_named("tetrahedral");
    if (lutlib::io::is_recipe(bytes)) {
        const auto read_base = [](const std::string& file) {
            return lutlib::io::read_lut(file).lut;
        };
        return look_of_recipe(lutlib::io::recipe_from(bytes, path, read_base), *lookup);
    }
    const lutlib::Reading reading = lutlib::io::decode_lut(bytes, path);
    return look_for(reading.lut, *lookup);
}

} // namespace preview
