// Options that were given and change nothing in this run: said once, on standard error.
#pragma once

#include "converter/verb.h"
#include "lutlib/io/look.h"
#include "lutlib/recipe/placement.h"

#include <initializer_list>
#include <string>
#include <string_view>

namespace converter {

struct Part {
    std::string_view option;
    bool has_part; ///< the option can change this run
    std::string why_not;
};

/// Says which of those were given and have no part.
void tell_unused(const Verb& verb, std::initializer_list<Part> parts);

/// --interpolation, of looks of which one has a lattice.
Part interpolation_part(bool has_lattice);
bool has_lattice(const lutlib::io::Look& look);

/// --adaptation, where it is between different whites.
Part adaptation_part(const lutlib::Placement& placement);
Part adaptation_part(const lutlib::Encoding& from, const lutlib::Encoding& to);

/// --no-convert, where a look is made for other codes than it gets or than its results are read as.
Part no_convert_part(bool would_convert);
Part no_convert_part(const lutlib::LookPlace& place);

/// --shaper, of a result that is a cube.
Part shaper_part(const lutlib::Lut& result);

} // namespace converter
