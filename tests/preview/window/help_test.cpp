// The list of keys (F1) misses nothing.
#include "preview/panels/actions.h"
#include "preview/window/window_events.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace preview::panels {
namespace {

bool lists(const std::vector<HelpRow>& rows, const std::string& keys, const std::string& help) {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const HelpRow& row) { return row.keys == keys && row.help == help; });
}

/// Whether a row's keys have it as a word of its own: "Ctrl+Z" has "Z".
bool names(const HelpRow& row, std::string_view key) {
    const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
    for (std::size_t at = row.keys.find(key); at != std::string::npos;
         at = row.keys.find(key, at + 1)) {
        const std::size_t end = at + key.size();
        if ((at == 0 || !is_letter(row.keys[at - 1])) &&
            (end == row.keys.size() || !is_letter(row.keys[end]))) {
            return true;
        }
    }
    return false;
}

TEST(Help, has_every_action_with_its_keys) {
    const std::vector<HelpRow> rows = help_rows();
    std::string series; // keys of a row that stands for those behind it: "Ctrl+1 to 9"
    std::size_t left = 0;
    for (const Action& action : actions()) {
        EXPECT_FALSE(action.help.empty()) << keys_of(action);
        if (action.listed && action.listed->empty()) {
            EXPECT_GT(left, 0U) << keys_of(action) << " is in no list";
            left -= left > 0 ? 1 : 0;
            const std::string own = keys_of(action);
            EXPECT_EQ(own.substr(0, own.size() - 1), series.substr(0, own.size() - 1)) << own;
            continue;
        }
        EXPECT_EQ(left, 0U) << series << " has another number of keys";
        series = action.listed.value_or("");
        left = series.ends_with("1 to 9") ? 8 : 0;
        EXPECT_TRUE(lists(rows, action.listed.value_or(keys_of(action)),
                          action.help + (left > 0 ? " to 9" : "")))
            << keys_of(action);
    }
    EXPECT_EQ(left, 0U);
}

TEST(Help, names_every_key_that_panels_know) {
    const std::vector<HelpRow> rows = help_rows();
    for (std::size_t i = 0; i < key_count; ++i) {
        const auto key = static_cast<Key>(i);
        if (key == Key::none || key == Key::modifier) {
            continue;
        }
        const bool is_digit = key >= Key::digit_2 && key <= Key::digit_8;
        EXPECT_TRUE(is_digit ||
                    std::any_of(rows.begin(), rows.end(),
                                [&](const HelpRow& row) { return names(row, text_of(key)); }))
            << text_of(key);
    }
}

TEST(Help, says_nothing_twice) {
    std::set<std::pair<std::string, std::string>> seen;
    for (const HelpRow& row : help_rows()) {
        EXPECT_FALSE(row.help.empty());
        EXPECT_TRUE(seen.insert({row.keys, row.help}).second) << row.keys;
    }
}

TEST(Keys, that_panels_know_are_each_on_a_keyboard) {
    std::set<Key> reached;
    for (int glfw = -1; glfw < 512; ++glfw) {
        reached.insert(key_of(glfw));
    }
    EXPECT_EQ(reached.size(), key_count);
}

} // namespace
} // namespace preview::panels
