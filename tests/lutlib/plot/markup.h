// What tests ask of SVG and HTML.
#pragma once

#include <regex>
#include <string>
#include <vector>

namespace plot {

/// Every match of a pattern's only group.
inline std::vector<std::string> all_of(const std::string& text, const std::string& pattern) {
    const std::regex wanted(pattern);
    std::vector<std::string> out;
    for (std::sregex_iterator it(text.begin(), text.end(), wanted), end; it != end; ++it) {
        out.push_back((*it)[1]);
    }
    return out;
}

inline std::vector<double> numbers_of(const std::string& text, const std::string& pattern) {
    std::vector<double> out;
    for (const std::string& match : all_of(text, pattern)) {
        out.push_back(std::stod(match));
    }
    return out;
}

/// The first element that is closed out of turn or not at all; empty when there is none. Elements
/// that need no end in HTML are left out.
inline std::string unbalanced_element(const std::string& text) {
    std::vector<std::string> open;
    const std::regex tag("<(/?)([a-z][a-z0-9]*)([^>]*)>");
    for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it) {
        const std::string name = (*it)[2];
        const std::string rest = (*it)[3];
        if (name == "meta" || name == "input" || (!rest.empty() && rest.back() == '/')) {
            continue;
        }
        if ((*it)[1].length() == 0) {
            open.push_back(name);
        } else if (open.empty() || open.back() != name) {
            return name;
        } else {
            open.pop_back();
        }
    }
    return open.empty() ? "" : open.back();
}

} // namespace plot
