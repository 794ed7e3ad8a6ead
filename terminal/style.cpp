#include "terminal/style.h"

#include <charconv>
#include <cstdlib>
#include <string_view>
#include <sys/ioctl.h>
#include <unistd.h>

namespace terminal {
namespace {

std::string_view variable(const char* name) {
    const char* const value = std::getenv(name);
    return value ? value : "";
}

} // namespace

std::string Style::marked(const char* mark, const std::string& text) const {
    return has_color_ && !text.empty() ? std::string("\x1b[") + mark + "m" + text + "\x1b[0m"
                                       : text;
}

std::string Style::name(const std::string& text) const {
    return marked("1", text);
}

std::string Style::heading(const std::string& text) const {
    return marked("4", text);
}

std::string Style::bad(const std::string& text) const {
    return marked("1;31", text);
}

Style style_of(int descriptor) {
    const std::string_view kind = variable("TERM");
    return Style(variable("NO_COLOR").empty() && !kind.empty() && kind != "dumb" &&
                 ::isatty(descriptor) == 1);
}

std::size_t columns_of(int descriptor) {
    if (::isatty(descriptor) != 1) {
        return 0;
    }
    const std::string_view given = variable("COLUMNS");
    std::size_t columns = 0;
    std::from_chars(given.data(), given.data() + given.size(), columns);
    winsize size{};
    if (columns == 0 && ::ioctl(descriptor, TIOCGWINSZ, &size) == 0) {
        columns = size.ws_col;
    }
    return columns;
}

} // namespace terminal
