#include "converter/sheet_look.h"

#include "converter/look_files.h"
#include "converter/side_by_side.h"
#include "lutlib/bake/bake.h"
#include "lutlib/error.h"
#include "lutlib/io/bake_report.h"

#include <fmt/core.h>

#include <optional>
#include <utility>

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
    SheetLook out{look.path(), {}, look.encodings(), whole.applied(), whole.needed().converts()};
    if (!place.engine) {
        out.shown = out.placement.around(look.exact());
        return out;
    }
    const lutlib::Engine& engine = *place.engine;
    lutlib::LookPlace in_engine = io::place_in(engine, out.said, place.converts);
    in_engine.adaptation = &place.adaptation;
    out.placement = in_engine.applied();
    out.would_convert = in_engine.needed().converts();
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

struct Opened {
    std::optional<io::Look> look; ///< none: no look, or a failure
    std::optional<SheetLook> placed;
    std::optional<lutlib::Error> failure;
};

Opened opened_of(const SheetSource& source, const SheetPlace& place) {
    Opened out;
    try {
        const io::LookOptions options{.encodings = place.look};
        out.look = source.in_folder ? open_if_look_quietly(source.path, options)
                                    : open_quietly(source.path, options);
        if (out.look) {
            out.placed = placed(*out.look, place);
        }
    } catch (const lutlib::UsageError&) {
        throw;
    } catch (const lutlib::Error& error) {
        out.failure = error;
    }
    return out;
}

void refuse(const std::vector<lutlib::Error>& failures, std::size_t looks) {
    if (failures.size() == 1) {
        throw failures.front();
    }
    if (failures.empty()) {
        return;
    }
    std::string reasons;
    for (const lutlib::Error& failure : failures) {
        reasons += (reasons.empty() ? "" : "; ") + std::string(failure.what());
    }
    throw lutlib::Error(fmt::format("{} of {} looks cannot be read, and no sheet is made: {}",
                                    failures.size(), looks, reasons));
}

} // namespace

lutlib::Transform shown_without_look(const SheetPlace& place) {
    const lutlib::LookPlace none{
        {lutlib::srgb(), lutlib::srgb()}, place.picture, lutlib::srgb(), true, &place.adaptation};
    return none.applied().around({});
}

SheetLooks open_sheet_looks(std::span<const SheetSource> sources, const SheetPlace& place,
                            std::size_t at_once) {
    std::vector<Opened> opened(sources.size());
    do_side_by_side(sources.size(), at_once,
                    [&](std::size_t i) { opened[i] = opened_of(sources[i], place); });
    SheetLooks out;
    std::vector<lutlib::Error> failures;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        Opened& one = opened[i];
        if (one.failure) {
            failures.push_back(*one.failure);
        } else if (one.look) {
            tell_of(*one.look);
            out.looks.push_back(std::move(*one.placed));
        } else {
            out.left_out.push_back(sources[i].path);
        }
    }
    refuse(failures, sources.size() - out.left_out.size());
    if (out.looks.empty()) {
        throw lutlib::Error("none of these files is a look", {sources.front().path, 0, {}});
    }
    return out;
}

} // namespace converter
