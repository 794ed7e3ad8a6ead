// Files of ASC CDL corrections: read, written, added to, and refused in a sentence.
#include "lutlib/recipe/correction_file.h"

#include "lutlib/error.h"

#include <gtest/gtest.h>

namespace lutlib {
namespace {

const ColorCorrection odd{"sh010 \"a\" & <b>", "warm, 1/3 \xc3\xa9", {1.1, 1, 1.0 / 3},
                          {-0.03, 1e-9, 2},    {1.25, 0.05, 1},      1.7};

TEST(CorrectionFile, of_every_format_comes_back_to_the_bit) {
    for (const CorrectionFormat& format : correction_formats()) {
        const std::string text = correction_text(odd, format);
        const auto read = parse_corrections(text, "a");
        ASSERT_EQ(read.size(), 1U) << text;
        EXPECT_EQ(read[0], odd) << text;
        EXPECT_TRUE(is_correction_text(text, "a")) << text;
        EXPECT_FALSE(is_correction_text(text + "<!-- mine -->", "a"));
        EXPECT_EQ(correction_format_of("x/y." + std::string(format.extension)), &format);
    }
    EXPECT_EQ(correction_format_of("A.CDL"), &correction_formats()[2]);
    EXPECT_EQ(correction_format_of("a.cube"), nullptr);
}

// As the ASC's documentation has it, with what other programs add.
constexpr std::string_view published = R"(<?xml version="1.0" encoding="UTF-8"?>
<!-- <ColorCorrection id="no"> -->
<cdl:ColorCorrectionCollection xmlns:cdl="urn:ASC:CDL:v1.2">
  <InputDescription>log</InputDescription>
  <ColorCorrection id='cc03340' other="a > b">
    <Description>first &amp; only&#233;</Description>
    <SOPNode><Description>not this one</Description>
      <Slope> +1 1
 0.9 </Slope><Offset>-0.03 -2.0e-2 0</Offset><Power>1.25 1 1</Power></SOPNode>
    <SATNode><Saturation>1.7</Saturation></SATNode>
  </ColorCorrection>
  <ColorCorrection id="empty"/>
  <cdl:ColorCorrection><SatNode><Saturation><![CDATA[0.5]]></Saturation></SatNode></cdl:ColorCorrection>
</cdl:ColorCorrectionCollection>
)";

TEST(CorrectionFile, is_read_with_what_others_write_into_it) {
    const auto read = parse_corrections(published, "p.ccc");
    ASSERT_EQ(read.size(), 3U);
    EXPECT_EQ(
        read[0],
        (ColorCorrection{
            "cc03340", "first & only\xc3\xa9", {1, 1, 0.9}, {-0.03, -0.02, 0}, {1.25, 1, 1}, 1.7}));
    EXPECT_EQ(read[1], ColorCorrection{"empty"});
    EXPECT_EQ(read[2].saturation, 0.5);
    EXPECT_EQ(correction_named(read, "empty"), 1U);
    EXPECT_EQ(correction_named(read, ""), 0U);
    EXPECT_EQ(name_of(read, 2), "correction 3");
    EXPECT_EQ(correction_named(read, "correction 3"), 2U);
    try {
        correction_named(read, "cc0334");
        ADD_FAILURE() << "there is none";
    } catch (const UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("cc03340"), std::string::npos) << error.what();
    }
}

TEST(CorrectionFile, of_several_keeps_the_others_byte_by_byte) {
    const std::string text(published);
    ColorCorrection next{"next"};
    next.saturation = 0;
    const std::string longer = with_correction(text, "p.ccc", next);
    const std::size_t end = text.find("</cdl:ColorCorrectionCollection");
    EXPECT_EQ(longer.substr(0, end), text.substr(0, end));
    EXPECT_TRUE(longer.ends_with(text.substr(end)));
    const auto read = parse_corrections(longer, "p.ccc");
    ASSERT_EQ(read.size(), 4U);
    EXPECT_EQ(read[3], next);
    // In place of the one of its id.
    next.id = "empty";
    const auto replaced = parse_corrections(with_correction(longer, "p.ccc", next), "p.ccc");
    ASSERT_EQ(replaced.size(), 4U);
    EXPECT_EQ(replaced[1], next);
    EXPECT_EQ(replaced[0], read[0]);
    EXPECT_EQ(replaced[2], read[2]);
}

TEST(CorrectionFile, that_we_write_stays_ours_with_more_corrections) {
    for (const CorrectionFormat& format : correction_formats()) {
        if (!format.holds_many()) {
            EXPECT_THROW(with_correction(correction_text(odd, format), "a", odd), Error);
            continue;
        }
        std::string text = correction_text(odd, format);
        text = with_correction(text, "a", {.id = "b"});
        text = with_correction(text, "a", {.id = "c", .saturation = 2});
        text = with_correction(text, "a", {.id = "b", .saturation = 3});
        EXPECT_TRUE(is_correction_text(text, "a")) << text;
        const auto read = parse_corrections(text, "a");
        ASSERT_EQ(read.size(), 3U);
        EXPECT_EQ(read[0], odd);
        EXPECT_EQ(read[1].saturation, 3);
        EXPECT_EQ(read[2].saturation, 2);
    }
}

struct Bad {
    std::string text;
    std::size_t line;
};

TEST(CorrectionFile, that_is_none_is_refused_with_its_line) {
    const std::string open = "<ColorCorrection>\n<SOPNode>\n",
                      close = "</SOPNode></ColorCorrection>";
    std::string deep;
    for (int i = 0; i < 100; ++i) {
        deep += "<a>";
    }
    const Bad bad[] = {
        {"", 1},
        {"1 2 3", 1},
        {"<cube/>", 1},
        {"<ColorCorrection>", 1},
        {"<ColorCorrection", 1},
        {"<ColorCorrectionCollection></ColorCorrectionCollection>", 1},
        {"<ColorCorrection/>\n<ColorCorrection/>", 2},
        {open + "<Slope>1 1</Slope>" + close, 3},
        {open + "<Slope>1 1 1 1</Slope>" + close, 3},
        {open + "<Slope>1 1 nan</Slope>" + close, 3},
        {open + "<Slope>1 1 1e999</Slope>" + close, 3},
        {open + "<Slope>1,0 1,0 1,0</Slope>" + close, 3},
        {open + "<Power/>" + close, 3},
        {open + "</ColorCorrection></SOPNode>", 3},
        {open + "<ColorCorrection/>" + close, 3},
        {"<ColorCorrection><!-- a", 1},
        {"\n<!DOCTYPE x [<!ENTITY a \"b\">]>\n<ColorCorrection/>", 2},
        {"<ColorCorrectionCollection>" + deep, 1},
        {"<ColorCorrectionCollection>\n<ColorCorrection id=\"a\"/>\n<ColorCorrection id=\"a\"/>\n"
         "</ColorCorrectionCollection>",
         3},
    };
    for (const Bad& row : bad) {
        try {
            parse_corrections(row.text, "bad.cc");
            ADD_FAILURE() << row.text;
        } catch (const Error& error) {
            EXPECT_EQ(error.where().file, "bad.cc") << row.text;
            EXPECT_EQ(error.where().line, row.line) << row.text << ": " << error.what();
        }
    }
}

TEST(CorrectionFile, is_not_written_with_what_xml_cannot_hold) {
    EXPECT_THROW(correction_text({.id = "a\nb"}, correction_formats()[0]), UsageError);
    EXPECT_THROW(correction_text({.description = std::string("\0", 1)}, correction_formats()[1]),
                 UsageError);
}

} // namespace
} // namespace lutlib
