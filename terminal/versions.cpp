#include "terminal/versions.h"

#include "lutlib/error.h"
#include "lutlib/io/box/box.h"
#include "lutlib/io/ocio.h"
#include "lutlib/io/oiio.h"

#include <functional>

namespace terminal {
namespace {

std::string or_why_not(const std::function<std::string()>& text) {
    try {
        return text();
    } catch (const lutlib::Error& error) {
        return "is not there: " + error.message();
    }
}

} // namespace

std::string loaded_versions() {
    return "OpenColorIO " + or_why_not([] { return lutlib::io::ocio().version(); }) +
           "\nOpenImageIO " + or_why_not([] { return lutlib::io::oiio().version(); }) + "\n";
}

std::string holding_line() {
    return or_why_not([] { return lutlib::io::box::holding_text(); }) + "\n";
}

} // namespace terminal
