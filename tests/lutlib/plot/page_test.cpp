#include "lutlib/plot/page.h"
#include "tests/lutlib/plot/markup.h"

#include <gtest/gtest.h>

namespace plot {
namespace {

Page page() {
    Page out;
    out.title = "Report";
    out.summary = "33 nodes do.";
    out.paragraphs = {"How it was measured."};
    out.views = {{"mean", {"<svg class=\"a\"></svg>", "<svg class=\"b\"></svg>"}},
                 {"worst", {"<svg class=\"c\"></svg>"}}};
    out.table.columns = {"lookup", "ns"};
    out.table.rows = {{{text_cell("trilinear"), number_cell(12.3456)}, false, false},
                      {{text_cell("nearest"), number_cell(0.000123456)}, true, false},
                      {{text_cell("tetrahedral"), number_cell(1e9)}, true, true}};
    return out;
}

TEST(Page, holds_all_that_it_is_given_and_closes_every_element) {
    const std::string text = html(page());
    for (const char* part : {"<title>Report</title>", "33 nodes do.", "How it was measured.",
                             "class=\"a\"", "class=\"b\"", "class=\"c\"", ">trilinear<"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part;
    }
    const std::string markup = text.substr(0, text.find("<script>"));
    EXPECT_EQ(unbalanced_element(markup + "</body></html>"), "");
}

TEST(Page, loads_nothing) {
    const std::string text = html(page());
    for (const char* word : {"src=", "href=", "http:", "https:", "url(", "@import"}) {
        EXPECT_EQ(text.find(word), std::string::npos) << word;
    }
}

TEST(Page, shows_the_first_view_and_switches_by_rules_alone) {
    const std::string text = html(page());
    EXPECT_EQ(all_of(text, "id=\"view-([0-9]+)\" checked>"), (std::vector<std::string>{"0"}));
    EXPECT_EQ(all_of(text, "id=\"view-([0-9]+)\""), (std::vector<std::string>{"0", "1"}));
    for (const char* rule : {"#view-0:checked ~ #plots-0 { display: flex; }",
                             "#view-1:checked ~ #plots-1 { display: flex; }"}) {
        EXPECT_NE(text.find(rule), std::string::npos) << rule;
    }
    const std::size_t second = text.find("id=\"plots-1\"");
    EXPECT_LT(text.find("class=\"b\""), second);
    EXPECT_GT(text.find("class=\"c\""), second);
}

TEST(Page, numbers_are_read_to_three_digits_and_sorted_by_all_of_them) {
    const std::string text = html(page());
    EXPECT_NE(text.find("<td data-v=\"12.3456\">12.3</td>"), std::string::npos);
    EXPECT_NE(text.find("<td data-v=\"0.000123456\">0.000123</td>"), std::string::npos);
    EXPECT_NE(text.find("<td data-v=\"1e+09\">1e+09</td>"), std::string::npos);
    EXPECT_NE(text.find("<td>trilinear</td>"), std::string::npos);
}

TEST(Page, rows_say_whether_they_are_dominated_or_recommended) {
    const std::string text = html(page());
    for (const char* row : {"<tr id=\"row-0\">", "<tr id=\"row-1\" class=\"dominated\">",
                            "<tr id=\"row-2\" class=\"recommended\">"}) {
        EXPECT_NE(text.find(row), std::string::npos) << row;
    }
}

TEST(Page, headings_of_words_and_of_numbers_differ) {
    const std::string text = html(page());
    EXPECT_NE(text.find("<th class=\"words\">lookup</th><th>ns</th>"), std::string::npos);
    Page empty = page();
    empty.table.rows.clear();
    EXPECT_NE(html(empty).find("<th class=\"words\">ns</th>"), std::string::npos);
}

TEST(Page, panels_hold_every_row_s_values_for_scripts_and_nothing_ends_them_early) {
    Page with = page();
    with.panels.markup = "<p id=\"d-a\">first</p>";
    with.panels.values = {{"a", "text"}};
    with.panels.rows = {{"first"}, {"\"2\" </script>"}, {"back\\slash"}};
    const std::string text = html(with);
    EXPECT_NE(text.find("<p id=\"d-a\">first</p>"), std::string::npos);
    EXPECT_NE(text.find("[\"a\",\"text\"]"), std::string::npos);
    EXPECT_NE(text.find("[\"\\\"2\\\" \\u003c/script>\"]"), std::string::npos) << text;
    EXPECT_NE(text.find("[\"back\\\\slash\"]"), std::string::npos) << text;
    EXPECT_EQ(html(page()).find("id=\"panels\""), std::string::npos);
}

TEST(Page, filters_are_hidden_until_a_script_fills_them) {
    Page with = page();
    with.table.filters = {0};
    const std::string text = html(with);
    EXPECT_NE(text.find("<span class=\"filters\" hidden>"), std::string::npos);
    EXPECT_EQ(all_of(text, "<select data-column=\"([0-9]+)\"").size(), 1U);
    EXPECT_EQ(html(page()).find("<select"), std::string::npos);
}

TEST(Page, text_is_escaped_wherever_it_stands) {
    Page rude = page();
    const std::string text = "<i>\"a\" & b</i>";
    rude.title = rude.summary = rude.paragraphs[0] = rude.views[0].name = rude.table.columns[0] =
        text;
    rude.table.rows[0].cells[0] = text_cell(text);
    const std::string out = html(rude);
    EXPECT_EQ(out.find(text), std::string::npos);
    EXPECT_EQ(all_of(out, "(&lt;i&gt;&quot;a&quot; &amp; b&lt;/i&gt;)").size(), 7U);
}

} // namespace
} // namespace plot
