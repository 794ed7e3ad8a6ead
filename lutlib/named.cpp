#include "lutlib/named.h"

#include "lutlib/closest_name.h"
#include "lutlib/error.h"

#include <algorithm>

namespace lutlib {

std::string listed(std::span<const std::string_view> names) {
    std::string out;
    for (const std::string_view name : names) {
        out.append(out.empty() ? "" : ", ").append(name);
    }
    return out;
}

std::string what_there_is(std::string_view name, std::span<const std::string_view> names) {
    const std::string_view meant = closest_name(name, names);
    std::string out;
    if (!meant.empty()) {
        out.append("did you mean ").append(meant).append("? ");
    }
    out += out.empty() ? "there " : "There ";
    out += names.size() == 1 ? "is " : "are ";
    if (names.empty()) {
        return out + "none";
    }
    constexpr std::size_t most = 100;
    out += listed(names.first(std::min(names.size(), most)));
    return names.size() > most ? out + " and " + std::to_string(names.size() - most) + " more"
                               : out;
}

std::string no_such_name(std::string_view kind, std::string_view name,
                         std::span<const std::string_view> names) {
    std::string out = "there is no ";
    return out.append(kind).append(" '").append(name).append("'; ") + what_there_is(name, names);
}

void refuse_name(std::string_view kind, std::string_view name,
                 std::span<const std::string_view> names) {
    throw UsageError(no_such_name(kind, name, names));
}

} // namespace lutlib
