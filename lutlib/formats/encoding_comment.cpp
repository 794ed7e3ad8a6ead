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
    {"Input encoding", "--look-input", &EncodingNames::input},
    {"Output encoding", "--look-output", &EncodingNames::output},
}};

// The name behind `words` and a colon, which may stand apart; empty where the text says no such
// thing.
std::string_view named_in(std::string_view text, std::string_view words) {
    const auto same = [](char a, char b) { return upper(a) == upper(b); };
    if (text.size() <= words.size() ||
        !std::equal(words.begin(), words.end(), text.begin(), same)) {
        return {};
    }
    const std::string_view behind = trimmed(text.substr(words.size()));
    return behind.substr(0, 1) == ":" ? trimmed(behind.substr(1)) : std::string_view{};
}

} // namespace

bool take_encoding(std::string_view comment, EncodingNames& names) {
    for (const Row& row : rows) {
        const std::string_view name = named_in(comment, row.words);
        if (!name.empty() && (names.*row.name).empty()) {
            names.*row.name = name;
            return true;
        }
    }
    return false;
}

std::string encoding_contradiction(std::string_view comment, const EncodingNames& names) {
    for (const Row& row : rows) {
        const std::string& taken = names.*row.name;
        const std::string_view other = named_in(comment, row.words);
        if (!other.empty() && !taken.empty() && upper(other) != upper(taken)) {
            return "its comments name two encodings, '" + taken + "' and '" + std::string(other) +
                   "', as \"" + std::string(row.words) +
                   ":\"; the first is taken: delete the wrong comment, or say it with " +
                   std::string(row.option);
        }
    }
    return {};
}

bool is_superseded(std::string_view comment, const EncodingNames& names) {
    return std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
        return !(names.*row.name).empty() && !named_in(comment, row.words).empty();
    });
}

std::vector<std::string> encoding_comments(const EncodingNames& names) {
    std::vector<std::string> out;
    for (const Row& row : rows) {
        if (!(names.*row.name).empty()) {
            out.push_back(std::string(row.words) + ": " + names.*row.name);
        }
    }
    return out;
}

} // namespace lutlib
