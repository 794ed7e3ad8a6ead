// What there is, as lutconv lists it.
#include "converter/listings.h"
#include "python/parts.h"

#include <nlohmann/json.hpp>

namespace lutlib_python {

void declare_tables(py::module_& module) {
    module.def(
        "engines", [] { return as_python(converter::engines_json()); },
        "The engines, a dict for each: sizes in nodes a side, bits, layout, import step.");
    module.def(
        "encodings", [] { return as_python(converter::encodings_json()); },
        "A dict of curves, gamuts and adaptations, each with its source.");
    module.def(
        "operators", [] { return as_python(converter::operators_json()); },
        "The operators of recipes, a dict for each, with their parameters' names, units, "
        "ranges and defaults.");
    module.def(
        "formats", [] { return as_python(converter::formats_json()); },
        "The LUT file formats, a dict for each: extensions, and whether it is read and "
        "written.");
}

} // namespace lutlib_python
