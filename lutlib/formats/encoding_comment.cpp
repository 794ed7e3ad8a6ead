#include "lutlib/formats/encoding_comment.h"

#include "lutlib/text.h"

#include <algorithm>
#include <array>

namespace lutlib {
namespace {

struct Row {
    std::string_view words, option;
    std::string EncodingNames::*name;
};

constexpr std::array<Row, 2> rows{{
    {"Input encoding:", "--look-input", &EncodingNames::input},
    {"Output encoding:", "--look-output", &EncodingNames::output},
}};

bool begins_with(std::string_view text, std::string_view words) {
    const auto same = [](char a, char b) { return upper(a) == upper(b); };
    return text.size() > words.size() && std::equal(words.begin(), words.end(), text.begin(), same);
}

} // namespace

bool take_encoding(std::string_view comment, EncodingNames& names) {
    for (const Row& row : rows) {
        if (begins_with(comment, row.words) && (names.*row.name).empty()) {
            const std::string_view name = trimmed(comment.substr(row.words.size()));
            if (name.empty()) {
                return false;
            }
            names.*row.name = name;
            return true;
        }
    }
    return false;
}

std::string encoding_contradiction(std::string_view comment, const EncodingNames& names) {
    for (const Row& row : rows) {
        const std::string& taken = names.*row.name;
        if (!begins_with(comment, row.words) || taken.empty()) {
            continue;
        }
        const std::string_view other = trimmed(comment.substr(row.words.size()));
        if (!other.empty() && upper(other) != upper(taken)) {
            return "its comments name two encodings, '" + taken + "' and '" + std::string(other) +
                   "', as \"" + std::string(row.words) +
                   "\"; the first is taken: delete the wrong " + "comment, or say it with " +
                   std::string(row.option);
        }
    }
    return {};
}

std::vector<std::string> encoding_comments(const EncodingNames& names) {
    std::vector<std::string> out;
    for (const Row& row : rows) {
        if (!(names.*row.name).empty()) {
            out.push_back(std::string(row.words) + ' ' + names.*row.name);
        }
    }
    return out;
}

} // namespace lutlib
