#include "converter/config_options.h"

#include "converter/report.h"
#include "lutlib/error.h"
#include "lutlib/io/ocio.h"

#include <fmt/core.h>

namespace converter {

void ConfigOptions::declare(Verb& verb) {
    constexpr const char* group = "OpenColorIO config";
    verb.add_option("--ocio-config", config_,
                    "let this .ocio file (or ocio:// name) convert first, evaluated by OpenColorIO")
        .group(group);
    verb.add_option("--from", from_, "the config's colour space of the input").group(group);
    verb.add_option("--to", to_, "the config's colour space of the result").group(group);
    verb.add_option("--display", display_, "instead of --to, one of the config's displays")
        .group(group);
    verb.add_option("--view", view_, "how --display shows it (default: the display's own)")
        .group(group);
}

void ConfigOptions::check() const {
    const bool none =
        config_.empty() && from_.empty() && to_.empty() && display_.empty() && view_.empty();
    if (none) {
        return;
    }
    if (!given() || from_.empty() || to_.empty() == display_.empty() ||
        (display_.empty() && !view_.empty())) {
        throw lutlib::UsageError("an OpenColorIO config needs --ocio-config FILE --from SPACE and "
                                 "either --to SPACE or --display DISPLAY [--view VIEW]");
    }
}

void ConfigOptions::require_alone(bool others) const {
    if (given() && others) {
        throw lutlib::UsageError("--ocio-config says what is converted; leave --look-input, "
                                 "--look-output, --adaptation and --no-convert out");
    }
}

lutlib::Transform ConfigOptions::before(const lutlib::Transform& look) const {
    return given() ? lutlib::in_sequence({transform(), look}) : look;
}

lutlib::Transform ConfigOptions::transform() const {
    check();
    return lutlib::io::ocio().from_config({config_, from_, to_, display_, view_});
}

std::string ConfigOptions::text() const {
    return fmt::format("{}, from {} to {}", one_line(config_), one_line(from_),
                       one_line(display_.empty() ? to_
                                : view_.empty()  ? display_
                                                 : display_ + ", " + view_));
}

} // namespace converter
