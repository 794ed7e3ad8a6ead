#include "lutlib/io/formats.h"

#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/io/file.h"
#include "lutlib/io/fit_format.h"
#include "lutlib/io/look.h"
#include "lutlib/io/ocio.h"
#include "lutlib/named.h"
#include "tests/lutlib/io/looks.h"
#include "tests/lutlib/io/scratch.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lutlib::io {
namespace {

// What a format's numbers may differ from the look's: half a step, interpolated, and float noise.
double precision_of(const Holds& holds) {
    const double half_step = holds.integer_bits ? 0.5 / (std::ldexp(1, holds.integer_bits) - 1)
                             : holds.decimals   ? 0.5 * std::pow(10, -holds.decimals)
                                                : 0;
    return half_step + 2e-6;
}

std::vector<std::string> names(bool readable_too) {
    std::vector<std::string> out;
    for (const FileFormat* const row : file_formats()) {
        if (row->write && (!readable_too || row->read)) {
            out.emplace_back(row->name);
        }
    }
    return out;
}

// The error that a list of losses admits, values clamped included.
double admitted(const std::vector<Loss>& losses) {
    double sum = 0;
    for (const Loss& loss : losses) {
        sum += loss.unit.empty() ? loss.figure : 0;
    }
    return sum;
}

// Small where the format needs a cube of another make; 16 is a size that every layout has.
Encoded encode(const Lut& lut, const FileFormat& format) {
    WriteOptions options;
    options.size = can_hold(lut, format.holds) && !format.layout ? 0 : 16;
    return encode_lut(lut, format, options);
}

class EveryWriter : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Formats, EveryWriter, testing::ValuesIn(names(true)),
                         [](const auto& row) { return support::test_name(row.param); });

TEST_P(EveryWriter, what_it_writes_reads_back_as_the_look_it_said) {
    const FileFormat& format = require_file_format(GetParam());
    for (const auto& [name, lut] : looks_of_every_shape(9)) {
        SCOPED_TRACE(name);
        const Encoded file = encode(lut, format);
        const Lut back =
            decode_lut(file.bytes, "x." + format.extensions.first(), {}, format.name).lut;
        const Domain domain = file.lut.domain();
        EXPECT_EQ(back.domain(), domain);
        const auto in = colors_in(domain);
        EXPECT_LE(largest_difference(evaluated(back, in), evaluated(file.lut, in)),
                  precision_of(format.holds) + admitted(file.losses));
    }
}

TEST_P(EveryWriter, loses_nothing_that_it_does_not_report) {
    const FileFormat& format = require_file_format(GetParam());
    for (const auto& [name, lut] : looks_of_every_shape(9)) {
        SCOPED_TRACE(name);
        const Encoded file = encode(lut, format);
        const auto in = colors_in(file.lut.domain());
        const Lut back =
            decode_lut(file.bytes, "x." + format.extensions.first(), {}, format.name).lut;
        // The errors are measured on other colours, so the largest may be a little larger here.
        EXPECT_LE(largest_difference(evaluated(back, in), evaluated(lut, in)),
                  1.3 * admitted(file.losses) + precision_of(format.holds));
        const bool whole = file.lut.domain() == lut.domain();
        EXPECT_TRUE(whole || !file.losses.empty());
    }
}

TEST_P(EveryWriter, what_it_writes_is_recognised_without_its_name) {
    const FileFormat& format = require_file_format(GetParam());
    for (const auto& [name, lut] : looks_of_every_shape(9)) {
        SCOPED_TRACE(name);
        const std::string path = "x." + format.extensions.first();
        const std::string bytes = encode(lut, format).bytes;
        const auto in = colors_in({});
        EXPECT_EQ(evaluated(decode_lut(bytes, path).lut, in),
                  evaluated(decode_lut(bytes, path, {}, format.name).lut, in));
    }
}

TEST(Formats, of_comparison_only_are_written_and_read_back_by_our_own_reader) {
    for (const FileFormat* const format : file_formats()) {
        if (!format->read) {
            const Encoded file = encode_lut(looks_of_every_shape()[0].lut, *format);
            const Lut back = decode_lut(file.bytes, "x." + format->extensions.first()).lut;
            const auto in = colors_in({});
            EXPECT_LE(largest_difference(evaluated(back, in), evaluated(file.lut, in)),
                      precision_of(format->holds))
                << format->name;
        }
    }
}

TEST(Formats, cover_every_extension_that_opencolorio_reads) {
    for (const std::string& extension : ocio().readable_extensions()) {
        const bool known =
            std::any_of(file_formats().begin(), file_formats().end(), [&](const FileFormat* row) {
                return row->read && row->extensions.contain(extension);
            });
        EXPECT_TRUE(known) << extension;
    }
}

TEST(Formats, have_names_of_their_own) {
    for (const FileFormat* const row : file_formats()) {
        EXPECT_EQ(find_named(file_formats(), row->name), row);
        EXPECT_FALSE(row->extensions.first().empty());
        EXPECT_FALSE(row->label.empty());
    }
}

TEST(Formats, refuse_nonsense_of_every_extension_with_an_error_that_names_the_file) {
    for (const FileFormat* const row : file_formats()) {
        for (const std::string_view known : row->extensions) {
            const std::string extension(known);
            for (const std::string& bytes : {std::string("nonsense\n"), std::string(300, '\0'),
                                             std::string("<?xml>\n<a/>"), std::string("0 1 2\n")}) {
                try {
                    decode_lut(bytes, "bad." + extension);
                    ADD_FAILURE() << extension << " accepted " << bytes;
                } catch (const Error& e) {
                    EXPECT_EQ(std::string(e.what()).rfind("bad." + extension, 0), 0U) << e.what();
                    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
                }
            }
        }
    }
}

TEST(Formats, refuse_every_truncated_file) {
    const Lut lut = looks_of_every_shape(5)[0].lut;
    for (const std::string& name : names(true)) {
        const FileFormat& format = require_file_format(name);
        const Encoded file = encode_lut(lut, format);
        const std::string path = "x." + format.extensions.first();
        for (int cut = 1; cut < 12; ++cut) {
            const std::size_t length =
                file.bytes.size() * static_cast<std::size_t>(cut) / std::size_t{12};
            try {
                decode_lut(file.bytes.substr(0, length), path, {}, name);
                ADD_FAILURE() << name << " accepted " << cut << "/12 of a file";
            } catch (const Error&) {
            }
        }
    }
}

// OpenColorIO's reader of .csp, which it tries on files of any name, reads such metadata without
// end.
TEST(Formats, refuse_metadata_without_end_under_any_name) {
    for (const FileFormat* const format : file_formats()) {
        if (!format->read || format->layout) {
            continue;
        }
        const std::string file = "x." + std::string(format->extensions.first());
        for (const char* const bytes : {"CSPLUTV100\n1D\n\nBEGIN METADATA\nx\n2\n0 1\n",
                                        "\n csplutv100\n3D\nbegin metadata\nend metadat\n"}) {
            try {
                format->read(*format, bytes, file, {});
                ADD_FAILURE() << format->name;
            } catch (const Error& error) {
                const std::string message = error.what();
                EXPECT_NE(message.find(file), std::string::npos) << message;
                EXPECT_EQ(message.find("seconds"), std::string::npos) << message;
            }
        }
    }
}

TEST(Formats, refuse_a_clf_table_without_values) {
    const std::string head =
        "<?xml version=\"1.0\"?>\n<ProcessList id=\"a\" compCLFversion=\"3\">\n"
        "<!-- <LUT3D> -->\n";
    for (const std::string table : {"<LUT3D inBitDepth=\"32f\" outBitDepth=\"32f\"></LUT3D>",
                                    "<LUT1D inBitDepth=\"32f\" outBitDepth=\"32f\"/>"}) {
        try {
            decode_lut(head + table + "</ProcessList>", "x.clf");
            ADD_FAILURE() << table;
        } catch (const Error& error) {
            EXPECT_NE(error.message().find("has no Array of values"), std::string::npos)
                << error.what();
            EXPECT_EQ(error.where().line, 4U);
        }
    }
}

// Readers lay a smooth curve through a .csp's prelut, which a steep table bends.
TEST(WriteLut, measures_what_a_reader_makes_of_a_steep_table_before_a_cube) {
    Lut look;
    look.shaper.emplace().domain = {{0, 0, 0}, {100, 100, 100}};
    for (int i = 0; i < 4096; ++i) {
        const auto v = static_cast<float>(std::log1p(1e5 * i / 4095.0) / std::log(1e5 + 1));
        look.shaper->entries.push_back({v, v, v});
    }
    look.cube = identity_cube(17);
    for (Rgb& node : look.cube->nodes) {
        node = {std::sqrt(node.r), std::sqrt(node.g), std::sqrt(node.b)};
    }
    const Encoded file = encode_lut(look, require_file_format("csp"));
    ASSERT_EQ(file.losses.size(), 1U);
    const Transform read = Look::of_bytes(file.bytes, "a.csp").exact();
    double most = 0;
    for (double v = 1e-5; v < 100; v *= 1.0005) {
        most = std::max(most, largest_magnitude(read({v, v, v}) - evaluate_exact(look, {v, v, v})));
    }
    EXPECT_GT(most, 1e-3);
    EXPECT_GE(file.losses[0].figure, 0.98 * most);
    EXPECT_LE(file.losses[0].figure, 1.15 * most); // it looks at more than greys
}

TEST(WriteLut, says_what_a_reader_loses_of_a_narrow_domain) {
    Lut look;
    look.shaper.emplace().domain = {{.5F, .5F, .5F}, {.500001F, .500001F, .500001F}};
    for (int i = 0; i < 64; ++i) {
        const auto v = static_cast<float>(i / 63.0);
        look.shaper->entries.push_back({v, v, v});
    }
    for (const char* const format : {"clf", "ctf"}) {
        const Encoded file = encode_lut(look, require_file_format(format));
        ASSERT_EQ(file.losses.size(), 1U) << format;
        EXPECT_GT(file.losses[0].figure, 1e-3) << format;
    }
}

TEST(WriteLut, writes_numbers_too_small_for_its_reader_as_0_and_says_so) {
    Lut look;
    look.cube = identity_cube(5);
    for (Rgb& node : look.cube->nodes) {
        node = {1e-40F * node.r, node.g, node.b};
    }
    for (const char* const format : {"csp", "spi3d"}) {
        const Encoded file = encode_lut(look, require_file_format(format));
        ASSERT_FALSE(file.losses.empty()) << format;
        EXPECT_NE(file.losses[0].what.find("100 values so small"), std::string::npos)
            << file.losses[0].what;
        EXPECT_EQ(decode_lut(file.bytes, std::string("a.") + format).lut.cube->nodes[4].r, 0);
    }
}

TEST(WriteLut, chooses_the_cube_dialect_that_keeps_the_look) {
    const ScratchFolder folder;
    for (const auto& [name, lut] : looks_of_every_shape()) {
        const std::string path = folder.file(name + ".cube");
        const Encoded file = write_lut(path, lut);
        EXPECT_EQ(file.losses.empty(), !lut.interpolation) << name;
        const Lut back = read_lut(path).lut;
        EXPECT_EQ(back.shaper, lut.shaper) << name;
        EXPECT_EQ(back.cube, lut.cube) << name;
        EXPECT_EQ(back.provenance, path);
    }
}

TEST(WriteLut, refuses_unknown_names_and_extensions_as_usage_errors) {
    const Lut lut = looks_of_every_shape()[0].lut;
    EXPECT_THROW(write_lut("/nowhere/x.unknown", lut), UsageError);
    EXPECT_THROW(write_lut("/nowhere/x.cube", lut, {}, "unknown"), UsageError);
    EXPECT_THROW(write_lut("/nowhere/x.cc", lut), UsageError);
}

TEST(WriteLut, keeps_the_interpolation_in_formats_that_name_one) {
    const Lut lut = looks_of_every_shape(5)[0].lut;
    for (const char* name : {"clf", "ctf"}) {
        for (const Interpolation how : {Interpolation::trilinear, Interpolation::tetrahedral}) {
            Lut asking = lut;
            asking.interpolation = how;
            const FileFormat& format = require_file_format(name);
            const std::string bytes = encode_lut(asking, format).bytes;
            EXPECT_EQ(decode_lut(bytes, std::string("x.") + name).lut.interpolation, how) << name;
        }
    }
}

TEST(MistakenFiles, of_every_extension_are_refused_with_the_remedy) {
    for (const char* name : {"cube", "flame", "clf"}) {
        const std::string file = "a." + require_file_format(name).extensions.first();
        try {
            decode_lut("<!DOCTYPE html><html>", file);
            ADD_FAILURE() << file;
        } catch (const Error& error) {
            EXPECT_NE(error.message().find("a web page"), std::string::npos) << error.what();
        }
    }
}

} // namespace
} // namespace lutlib::io
