#include "preview/look/look_file.h"

#include "lutlib/error.h"
#include "lutlib/io/look_text.h"
#include "preview/look/recipe_table.h"

#include <filesystem>

namespace preview {

namespace {

LoadedLook look_for(const lutlib::io::LookPicture& picture,
                    std::shared_ptr<const lutlib::Lut> table, const std::string& path,
                    const GpuLookup& lookup) {
    if (picture.layout->name != lookup.layout) {
        throw lutlib::UsageError(
            "the lookup '" + std::string(lookup.name) + "' reads pictures in the layout '" +
            std::string(lookup.layout) + "' and '" + path + "' is in '" +
            std::string(picture.layout->name) + "': bake it with lutconv for that engine");
    }
    LoadedLook out;
    out.skip_reason = lookup.engine == nullptr ? skip_reason_of(*table) : "";
    out.data = look_data(picture.codes, picture.size, lookup);
    out.table = std::move(table);
    return out;
}

/// What reads a look where nobody says.
const GpuLookup& usual_lookup(const lutlib::io::Look& look, const lutlib::Lut& table) {
    if (const lutlib::Layout* const layout = look.kind().layout) {
        return *gpu_lookup_named(layout->name == "strip" ? "strip" : "trilinear");
    }
    return table_lookup(table);
}

/// A look with the conversions that an engine's picture of it holds.
LoadedLook baked_look(const lutlib::Transform& exact, const GpuLookup& engine) {
    return look_for(std::make_shared<const lutlib::Lut>(quick_table(exact)), exact, engine);
}

LoadedLook own_look(const lutlib::io::Look& look, const GpuLookup* wanted) {
    if (look.recipe() && (wanted == nullptr || wanted->source == GpuLookup::Source::table)) {
        return measured_look(*measured_table(*look.recipe()),
                             wanted ? *wanted : *gpu_lookup_named("tetrahedral"));
    }
    std::shared_ptr<const lutlib::Lut> table = look.table().lut;
    const GpuLookup& lookup = wanted ? *wanted : usual_lookup(look, *table);
    const auto picture = look.picture();
    if (picture && lookup.source == GpuLookup::Source::picture) {
        return look_for(*picture, std::move(table), look.path(), lookup);
    }
    return look_for(std::move(table), look.exact(), lookup);
}

} // namespace

LoadedLook look_for(const lutlib::io::Look& look, const LookUse& use) {
    LookStanding standing = standing_of(look.encodings(), use.lookup, use.picture);
    // An engine reads a picture's texels as they are, right or wrong.
    if (look.kind().layout != nullptr && !standing.is_before() && use.picture.convert) {
        PictureCodes picture = use.picture;
        picture.convert = false;
        standing = standing_of(look.encodings(), use.lookup, picture);
    }
    standing.place.convert = standing.place.convert && look.kind().layout == nullptr;
    const lutlib::Placement placement = standing.place.applied();
    LoadedLook out = placement.converts() ? baked_look(placement.around(look.exact()), *use.lookup)
                                          : own_look(look, use.lookup);
    out.told = told_of(look);
    out.encodings = standing.sentence;
    if (standing.is_told) {
        out.told.push_back(standing.sentence);
    }
    set_standing(out, standing);
    return out;
}

std::string look_title(const std::string& path) {
    return path.empty() || path == "none" ? "no look" : std::filesystem::path(path).stem().string();
}

LoadedLook load_look(const std::string& path, const LookUse& use) {
    if (path.empty() || path == "none") {
        return no_look_of(use.picture);
    }
    const lutlib::Engine* const engine = use.lookup != nullptr ? use.lookup->engine : nullptr;
    return look_for(lutlib::io::Look::open(path, {.engine = engine, .encodings = use.encodings}),
                    use);
}

} // namespace preview
