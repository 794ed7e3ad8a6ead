#include "converter/sheet_look.h"

#include "converter/look_files.h"
#include "lutlib/bake/bake.h"
#include "lutlib/error.h"
#include "lutlib/io/bake_report.h"

#include <fmt/core.h>

namespace converter {
namespace {

namespace io = lutlib::io;

// What a sheet is shown on stands in for what is not known.
lutlib::LookEncodings filled(lutlib::LookEncodings said) {
    said.input = said.input.value_or(lutlib::srgb());
    said.output = said.output.value_or(lutlib::srgb());
    return said;
}

SheetLook placed(const io::Look& look, const SheetPlace& place) {
    lutlib::LookPlace whole{filled(look.encodings()), place.picture, lutlib::srgb(), place.converts,
                            &place.adaptation};
    SheetLook out{look.path(), {}, look.encodings(), whole.applied()};
    if (!place.engine) {
        out.shown = out.placement.around(look.exact());
        return out;
    }
    const lutlib::Engine& engine = *place.engine;
    lutlib::LookPlace in_engine = io::place_in(engine, out.said, place.converts);
    in_engine.adaptation = &place.adaptation;
    out.placement = in_engine.applied();
    const lutlib::Bake baked =
        bake(out.placement.around(look.exact()), engine, engine.default_size, engine.default_bits);
    // An engine gets its own codes, whatever is converted for the look in its strip.
    if (in_engine.given) {
        whole.look = {in_engine.given, in_engine.wanted};
        whole.convert = true;
    }
    out.shown = whole.applied().around(read_by(engine, decoded(baked.picture), baked.size));
    return out;
}

} // namespace

lutlib::Transform shown_without_look(const SheetPlace& place) {
    const lutlib::LookPlace none{
        {lutlib::srgb(), lutlib::srgb()}, place.picture, lutlib::srgb(), true, &place.adaptation};
    return none.applied().around({});
}

std::vector<SheetLook> open_sheet_looks(std::span<const std::string> paths,
                                        const SheetPlace& place) {
    std::vector<SheetLook> out;
    std::vector<lutlib::Error> failures;
    for (const std::string& path : paths) {
        try {
            out.push_back(placed(open_look(path, {.encodings = place.look}), place));
        } catch (const lutlib::UsageError&) {
            throw;
        } catch (const lutlib::Error& error) {
            failures.push_back(error);
        }
    }
    if (failures.size() == 1) {
        throw failures.front();
    }
    if (!failures.empty()) {
        std::string reasons;
        for (const lutlib::Error& failure : failures) {
            reasons += (reasons.empty() ? "" : "; ") + std::string(failure.what());
        }
        throw lutlib::Error(fmt::format("{} of {} looks cannot be read, and no sheet is made: {}",
                                        failures.size(), paths.size(), reasons));
    }
    return out;
}

} // namespace converter
