// Every verb and every interpolation over the suite of stiff and extreme looks: a defined answer or
// a clear error, never a crash, never a silent NaN.
#include "lutlib/formats/cube.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/io/formats.h"
#include "lutlib/resample/resample.h"
#include "lutlib/survey/stiff_suite.h"
#include "tests/converter/run_program.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <type_traits>
#include <vector>

#include <algorithm>
#include <cctype>
#include <map>

namespace converter_test {
namespace {

using Arguments = std::vector<std::string>;

struct Runs {
    std::vector<Arguments> each;
    int highest_exit_code;
};

// What follows a verb's name. A verb without a row is run on the look, with a .cube to write; it
// may say that it is used otherwise.
Runs runs_of(const std::string& verb, const std::string& look, const Folder& folder) {
    const std::string cube = folder.path(verb + ".cube"), png = folder.path(verb + ".png");
    const std::string baked = folder.path("bake.png");
    const std::map<std::string, std::vector<Arguments>> rows{
        {"bake", {{look, "-o", png}, {look, "-o", png, "--engine", "unreal", "--explain"}}},
        {"verify", {{baked, "--against", look, "--samples", "1000"}}},
        {"check", {{look, "--repair", "--clamp", "-o", cube}, {look, "--explain", "--json"}}},
        {"convert", {{look, "-o", cube, "--explain"}, {look, "-o", folder.path("convert.csp")}}},
        {"edit", {{look, "--contrast", "1.2", "--saturation", "1.1", "--size", "9", "-o", cube}}},
        {"resample", {{look, "--size", "9", "-o", cube}}},
        {"compose", {{look, look, "--size", "9", "-o", cube}}},
        {"invert", {{look, "--size", "5", "-o", cube}}},
        {"blend", {{look, look, "--size", "9", "-o", cube}}},
        {"compare", {{look, "identity", "--samples", "1000"}}},
        {"match", {{baked, baked, "--size", "5", "-o", cube}}},
        {"apply", {{look, baked, "-o", png}}},
        {"extract", {{baked, "--engine", "unity", "--damaged", "-o", png}, {baked, "-o", cube}}},
        {"info", {{look}, {look, "--json"}}},
        {"eval", {{look, "0.5", "0.25", "1", "nan", "inf", "-inf", "-0", "1e30", "1e-45"}}},
        {"identity", {{"--size", "5", "-o", cube}}},
        {"engines", {{}, {"--json"}}},
        {"encodings", {{}}},
        {"operators", {{}, {"--json"}}},
        {"formats", {{}, {"--json"}}},
        {"shader",
         {{"--engine", "unity", "--language", "glsl", "-o", folder.path("x.glsl")},
          {"--inline", look, "--language", "hlsl", "--max-delta-e", "9", "-o",
           folder.path("x.hlsl")}}},
        {"sheet", {{baked, look, "-o", png}, {baked, look, "-o", png, "--engine", "unity"}}},
        {"show", {{look, "-o", png, "--size", "640"}, {look, look, "--json"}}},
        {"report", {{look, "--sizes", "2", "3", "-o", folder.path("report.html")}}},
    };
    const auto row = rows.find(verb);
    return row == rows.end() ? Runs{{{look, "-o", cube}}, 3} : Runs{row->second, 2};
}

// Those that the verb's own help offers. verify's oracle knows no nearest node, and says so.
Arguments read_interpolations_of(const std::string& verb) {
    const std::string help = lutconv_in_process({verb, "--help"}).out;
    const std::size_t at = help.find("--interpolation");
    Arguments out;
    if (at == std::string::npos) {
        return out;
    }
    const std::string text = help.substr(at, help.find("\n  -", at) - at);
    for (const lutlib::InterpolationInfo& row : lutlib::interpolations()) {
        if (text.find(" " + std::string(row.name)) != std::string::npos &&
            !(verb == "verify" && row.kind == lutlib::Interpolation::nearest)) {
            out.emplace_back(row.name);
        }
    }
    for (const lutlib::ResamplingMethod& row : lutlib::resampling_methods()) {
        const std::string name(row.name);
        if (text.find(" " + name) != std::string::npos &&
            std::find(out.begin(), out.end(), name) == out.end()) {
            out.push_back(name);
        }
    }
    EXPECT_GE(out.size(), 2U) << verb;
    return out;
}

const Arguments& interpolations_of(const std::string& verb) {
    static std::map<std::string, Arguments> known;
    const auto found = known.find(verb);
    return found != known.end() ? found->second
                                : known.emplace(verb, read_interpolations_of(verb)).first->second;
}

bool says_nan(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (std::size_t at = text.find("nan"); at != std::string::npos;
         at = text.find("nan", at + 1)) {
        const bool begins = at == 0 || !std::isalpha(static_cast<unsigned char>(text[at - 1]));
        const bool ends =
            at + 3 == text.size() || !std::isalpha(static_cast<unsigned char>(text[at + 3]));
        if (begins && ends) {
            return true;
        }
    }
    return false;
}

void run_and_judge(const std::string& verb, const Arguments& arguments, int highest_exit_code,
                   const Folder& folder) {
    Arguments words{verb};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::string line = "lutconv";
    for (const std::string& word : words) {
        line += " " + word;
    }
    SCOPED_TRACE(line);
    const Result result = lutconv_in_process(words);
    EXPECT_GE(result.exit_code, 0);
    EXPECT_LE(result.exit_code, highest_exit_code) << result.err;
    EXPECT_FALSE(says_nan(result.out)) << result.out;
    if (result.exit_code >= 2) {
        EXPECT_EQ(result.err.rfind("lutconv: ", 0), 0U) << "an error without words";
        return;
    }
    // What was written is read again, which refuses values that are no numbers.
    const std::string cube = folder.path(verb + ".cube");
    const std::vector<std::string> names = folder.names();
    if (std::find(names.begin(), names.end(), verb + ".cube") != names.end()) {
        EXPECT_NO_THROW(lutlib::io::read_lut(cube));
    }
    if (verb == "eval") {
        EXPECT_EQ(result.exit_code, 0);
        EXPECT_EQ(result.out.find("inf"), std::string::npos) << result.out;
    }
}

class EveryVerb : public testing::TestWithParam<lutlib::StiffLook> {};

// Every third or sixth walks the same code.
auto stiff_looks() {
    const auto suite = lutlib::stiff_suite();
    std::vector<std::decay_t<decltype(*suite.begin())>> out;
    const std::size_t step = support::is_thorough() ? 1 : support::is_sanitized ? 6 : 3;
    for (std::size_t i = 0; i < suite.size(); i += step) {
        out.push_back(suite[i]);
    }
    return out;
}

// Its own nodes, of at most so many planes: what is stiff between two of them only becomes stiffer.
lutlib::Lut of_few_nodes(lutlib::Lut lut) {
    const int most = support::is_thorough() ? 129 : support::is_sanitized ? 7 : 13;
    if (!lut.cube || lut.cube->size <= most) {
        return lut;
    }
    const lutlib::Lut3D whole = *lut.cube;
    const auto from = [&](int i) { return (i * (whole.size - 1) + (most - 1) / 2) / (most - 1); };
    *lut.cube = lutlib::identity_cube(most, whole.domain);
    for (int b = 0; b < most; ++b) {
        for (int g = 0; g < most; ++g) {
            for (int r = 0; r < most; ++r) {
                lut.cube->at(r, g, b) = whole.at(from(r), from(g), from(b));
            }
        }
    }
    return lut;
}
INSTANTIATE_TEST_SUITE_P(Suite, EveryVerb, testing::ValuesIn(support::rows_to_try(stiff_looks())),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(EveryVerb, gives_a_defined_answer_or_a_clear_error) {
    const lutlib::Lut lut = of_few_nodes(GetParam().make());
    const Folder folder;
    const std::string look = folder.write("look.cube", write_cube(lut, best_dialect(lut)));
    static const std::vector<std::string> all = verbs();
    ASSERT_GE(all.size(), 10U);
    // Of the largest files one run of each verb is enough for a test that is run often: the last,
    // whose picture verify need not diagnose; that takes most of the time and does not depend on
    // the look's size.
    const bool large = lut.cube && lut.cube->size > 65;
    for (const std::string& verb : all) {
        const Runs runs = runs_of(verb, look, folder);
        const Arguments& methods = interpolations_of(verb);
        // Every form of the verb and every interpolation, each in at least one run.
        const std::size_t count = std::max(runs.each.size(), methods.size());
        for (std::size_t i = large ? count - 1 : 0; i < count; ++i) {
            Arguments arguments = runs.each[i % runs.each.size()];
            if (!methods.empty()) {
                // Behind eval's LUT come its colours.
                const Arguments option{"--interpolation", methods[i % methods.size()]};
                arguments.insert(arguments.begin() + (verb == "eval" ? 1 : 0), option.begin(),
                                 option.end());
            }
            run_and_judge(verb, arguments, runs.highest_exit_code, folder);
        }
    }
}

} // namespace
} // namespace converter_test
