#include "tests/structure/include_rules.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>

namespace structure {

namespace {

namespace fs = std::filesystem;

struct Include {
    int line = 0;
    std::string target;
    bool is_ours = false; ///< #include "...", not <...>
};

std::optional<Include> include_in(const std::string& text, int line) {
    static constexpr std::string_view word = "include";
    const auto skip = [&](std::size_t at) { return text.find_first_not_of(" \t", at); };
    std::size_t at = skip(0);
    if (at == std::string::npos || text[at] != '#') {
        return std::nullopt;
    }
    at = skip(at + 1);
    if (at == std::string::npos || text.compare(at, word.size(), word) != 0) {
        return std::nullopt;
    }
    at = skip(at + word.size());
    if (at == std::string::npos || (text[at] != '"' && text[at] != '<')) {
        return std::nullopt;
    }
    const std::size_t end = text.find(text[at] == '"' ? '"' : '>', at + 1);
    if (end == std::string::npos) {
        return std::nullopt;
    }
    return Include{line, text.substr(at + 1, end - at - 1), text[at] == '"'};
}

std::vector<Include> includes_of(const std::string& source) {
    std::vector<Include> out;
    std::istringstream lines(source);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        if (std::optional<Include> include = include_in(line, ++number)) {
            out.push_back(std::move(*include));
        }
    }
    return out;
}

bool is_in_tests(const std::string& path) {
    return path.starts_with("tests/");
}

/// The file's own part, else its folder's; null when the table has neither.
const Part* part_of(const std::vector<Part>& table, const std::string& path) {
    const std::string folder = is_in_tests(path) ? "tests" : path.substr(0, path.rfind('/'));
    const Part* found = nullptr;
    for (const Part& part : table) {
        if (part.name.ends_with('*') &&
            path.starts_with(part.name.substr(0, part.name.size() - 1))) {
            return &part;
        }
        if (part.name == folder || (part.with == folder && !folder.empty())) {
            found = &part;
        }
    }
    return found;
}

bool is_meant(std::string_view pattern, std::string_view name) {
    if (pattern == "*") {
        return true;
    }
    if (!pattern.ends_with("/*")) {
        return pattern == name;
    }
    const std::string_view folder = pattern.substr(0, pattern.size() - 2);
    return name == folder || name.starts_with(pattern.substr(0, pattern.size() - 1));
}

bool may_use(const Part& user, const Part& used) {
    return &user == &used || std::any_of(user.uses.begin(), user.uses.end(), [&](auto pattern) {
        return is_meant(pattern, used.name);
    });
}

using IncludesByFile = std::map<std::string, std::vector<Include>>;

/// The way from a file to a system header that starts with `forbidden`, as "a.h -> b.h -> <c.h>".
std::string way_to(std::string_view forbidden, const std::string& file,
                   const IncludesByFile& includes, std::set<std::string>& seen) {
    const auto here = includes.find(file);
    if (here == includes.end() || !seen.insert(file).second) {
        return {};
    }
    for (const Include& include : here->second) {
        if (!include.is_ours && include.target.starts_with(forbidden)) {
            return file + " -> <" + include.target + ">";
        }
        if (include.is_ours) {
            const std::string rest = way_to(forbidden, include.target, includes, seen);
            if (!rest.empty()) {
                return file + " -> " + rest;
            }
        }
    }
    return {};
}

} // namespace

Sources read_sources(const std::string& repository) {
    Sources out;
    for (const char* folder :
         {"lutlib", "converter", "preview", "terminal", "python", "examples", "tests"}) {
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(repository) / folder)) {
            const fs::path& path = entry.path();
            if (path.extension() != ".h" && path.extension() != ".cpp") {
                continue;
            }
            std::ifstream file(path, std::ios::binary);
            out[path.lexically_relative(repository).generic_string()] =
                std::string(std::istreambuf_iterator<char>(file), {});
        }
    }
    return out;
}

std::vector<std::string> faults(const std::vector<Part>& table, const Sources& sources) {
    std::vector<std::string> out;
    IncludesByFile includes;
    for (const auto& [path, text] : sources) {
        includes[path] = includes_of(text);
    }
    for (const auto& [path, list] : includes) {
        const Part* const part = part_of(table, path);
        if (part == nullptr) {
            out.push_back(path + ":1: its folder is not in the table of parts");
            continue;
        }
        for (const Include& include : list) {
            if (!include.is_ours) {
                continue;
            }
            const std::string place = path + ":" + std::to_string(include.line) + ": includes " +
                                      include.target + ", which ";
            const Part* const used = part_of(table, include.target);
            if (!sources.contains(include.target)) {
                out.push_back(place + "is no file of the repository");
            } else if (used != nullptr && !may_use(*part, *used)) {
                out.push_back(place + std::string(part->name) + " may not");
            }
        }
        for (const std::string_view forbidden : part->never) {
            std::set<std::string> seen;
            const std::string way = way_to(forbidden, path, includes, seen);
            if (!way.empty()) {
                out.push_back(path + ":1: reaches <" + std::string(forbidden) + "...>: " + way);
            }
        }
    }
    return out;
}

std::string circle_in(const std::vector<Part>& table) {
    std::set<const Part*> done;
    std::vector<const Part*> way;
    const std::function<std::string(const Part&)> walk = [&](const Part& part) -> std::string {
        const auto again = std::find(way.begin(), way.end(), &part);
        if (again != way.end()) {
            std::string circle;
            for (auto at = again; at != way.end(); ++at) {
                circle += std::string((*at)->name) + " -> ";
            }
            return circle + std::string(part.name);
        }
        if (!done.insert(&part).second) {
            return {};
        }
        way.push_back(&part);
        for (const Part& used : table) {
            if (&used == &part || !may_use(part, used)) {
                continue;
            }
            if (std::string circle = walk(used); !circle.empty()) {
                return circle;
            }
        }
        way.pop_back();
        return {};
    };
    for (const Part& part : table) {
        if (std::string circle = walk(part); !circle.empty()) {
            return circle;
        }
    }
    return {};
}

} // namespace structure
