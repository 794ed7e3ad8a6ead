#include "converter/unused.h"

#include "converter/report.h"
#include "lutlib/io/file.h"

#include <fmt/core.h>

namespace converter {
namespace {

bool changes_white(const lutlib::Encoding& from, const lutlib::Encoding& to) {
    return from.primaries().white != to.primaries().white;
}

bool changes_white(const std::optional<lutlib::Conversion>& conversion) {
    return conversion && changes_white(conversion->from, conversion->to);
}

Part adaptation(bool has_part) {
    return {"--adaptation", has_part, "nothing is converted between gamuts of different whites"};
}

} // namespace

void tell_unused(const Verb& verb, std::initializer_list<Part> parts) {
    for (const Part& part : parts) {
        if (!part.has_part && verb.given(part.option)) {
            print(fmt::format("lutconv: {} changes nothing here: {}\n", part.option, part.why_not),
                  std::string(lutlib::io::standard_stream));
        }
    }
}

Part interpolation_part(bool has_lattice) {
    return {"--interpolation", has_lattice, "no look has a lattice, which alone it is about"};
}

bool has_lattice(const lutlib::io::Look& look) {
    return look.is_interpolated() && (!look.is_table() || look.table().lut->cube);
}

Part adaptation_part(const lutlib::Placement& placement) {
    return adaptation(changes_white(placement.before) || changes_white(placement.after));
}

Part adaptation_part(const lutlib::Encoding& from, const lutlib::Encoding& to) {
    return adaptation(changes_white(from, to));
}

Part no_convert_part(bool would_convert) {
    return {"--no-convert", would_convert, "nothing would be converted"};
}

Part no_convert_part(const lutlib::LookPlace& place) {
    return no_convert_part(place.needed().converts());
}

Part shaper_part(const lutlib::Lut& result) {
    return {"--shaper", result.cube.has_value(),
            "the result is a curve, which has no table before it"};
}

} // namespace converter
