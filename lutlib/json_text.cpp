#include "lutlib/json_text.h"

#include "lutlib/error.h"

#include <algorithm>

namespace lutlib {

std::string json_reason(const nlohmann::json::exception& error) {
    const std::string_view text = error.what();
    const std::size_t end = text.starts_with("[json.exception") ? text.find("] ") : text.npos;
    return std::string(end == text.npos ? text : text.substr(end + 2));
}

nlohmann::json parse_json(std::string_view text, const std::string& file) {
    try {
        return nlohmann::json::parse(text.begin(), text.end());
    } catch (const nlohmann::json::parse_error& error) {
        const auto end =
            text.begin() +
            static_cast<std::ptrdiff_t>(std::min(text.size(), error.byte > 0 ? error.byte - 1 : 0));
        const auto line = static_cast<std::size_t>(std::count(text.begin(), end, '\n')) + 1;
        const std::size_t start = text.rfind('\n', static_cast<std::size_t>(end - text.begin()));
        const std::size_t first = start == text.npos ? 0 : start + 1;
        throw Error("this is not JSON",
                    {file, line, std::string(text.substr(first, text.find('\n', first) - first))});
    } catch (const nlohmann::json::exception& error) {
        throw Error("this JSON cannot be read: " + json_reason(error), {file, 0, ""});
    }
}

} // namespace lutlib
