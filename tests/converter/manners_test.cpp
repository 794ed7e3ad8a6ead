// What a terminal's user expects of any program: help, names as people say them, errors for
// programs, silence, completions, man pages.
#include "lutlib/engine/engine_names.h"
#include "lutlib/io/formats.h"
#include "lutlib/ops/op.h"
#include "lutlib/version.h"
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace converter_test {
namespace {

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
}

// What a shell prints.
std::string output_of_bash(const std::string& script) {
    std::string out;
    FILE* const pipe = ::popen(("bash -c '" + script + "'").c_str(), "r");
    for (int c = 0; pipe && (c = std::fgetc(pipe)) != EOF;) {
        out += static_cast<char>(c);
    }
    if (pipe) {
        ::pclose(pipe);
    }
    return out;
}

TEST(Help, of_a_verb_is_asked_for_before_or_behind_it) {
    const Result behind = lutconv_in_process({"bake", "--help"});
    const Result before = lutconv_in_process({"help", "bake"});
    EXPECT_EQ(before.exit_code, 0);
    EXPECT_EQ(before.out, behind.out);
    EXPECT_EQ(lutconv_in_process({"help"}).out, lutconv_in_process({"--help"}).out);
    const Result typo = lutconv_in_process({"help", "bkae"});
    EXPECT_EQ(typo.exit_code, 3);
    EXPECT_NE(typo.err.find("did you mean bake?"), std::string::npos) << typo.err;
}

TEST(Help, of_every_verb_ends_in_examples_that_use_what_it_lists) {
    for (const std::string& verb : verbs()) {
        const std::string help = lutconv_in_process({verb, "--help"}).out;
        const std::size_t at = help.find("Examples:\n");
        ASSERT_NE(at, std::string::npos) << verb;
        std::istringstream lines(help.substr(at + 10));
        int count = 0;
        for (std::string line; std::getline(lines, line) && !line.empty(); ++count) {
            EXPECT_TRUE((line + " ").starts_with("lutconv " + verb + " ")) << line;
            for (const std::string& word : words_of(line)) {
                if (word.starts_with("-")) {
                    EXPECT_NE(help.substr(0, at).find(word), std::string::npos) << line;
                }
            }
        }
        EXPECT_GE(count, 1) << verb;
    }
}

TEST(EngineNames, are_those_that_people_say) {
    for (const lutlib::Engine& engine : lutlib::engines()) {
        EXPECT_EQ(lutlib::engine_called(engine.name), &engine);
        EXPECT_EQ(lutlib::engine_called(engine.label), &engine);
    }
    for (const lutlib::EngineAlias& alias : lutlib::engine_aliases()) {
        ASSERT_NE(lutlib::engine_named(alias.engine), nullptr) << alias.name;
        EXPECT_EQ(lutlib::engine_called(alias.name), lutlib::engine_named(alias.engine));
    }
    for (const auto& [said, meant] : {std::pair{"UE5", "unreal"},
                                      {"Unreal Engine 5", "unreal"},
                                      {"Unity URP", "unity"},
                                      {"three.js", "threejs"},
                                      {"GODOT", "godot"}}) {
        EXPECT_EQ(lutlib::engine_called(said), lutlib::engine_named(meant)) << said;
    }
    EXPECT_EQ(lutlib::engine_called(""), nullptr);
    EXPECT_EQ(lutlib::engine_called("!?"), nullptr);
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(3));
    EXPECT_EQ(
        lutconv_in_process({"bake", look, "-o", folder.path("x.png"), "--engine", "ue5"}).exit_code,
        0);
}

TEST(Listings, have_every_row_as_text_and_as_json) {
    const std::string operators = lutconv_in_process({"operators"}).out;
    const auto operator_rows =
        nlohmann::json::parse(lutconv_in_process({"operators", "--json"}).out);
    ASSERT_EQ(operator_rows.size(), lutlib::ops().size());
    for (std::size_t i = 0; i < operator_rows.size(); ++i) {
        const lutlib::Op& op = *lutlib::ops()[i];
        EXPECT_EQ(operator_rows[i]["name"], op.name);
        for (const lutlib::Parameter& parameter : op.parameters) {
            EXPECT_NE(operators.find("--" + std::string(parameter.flag) + " "), std::string::npos);
        }
    }
    const std::string formats = lutconv_in_process({"formats"}).out;
    const auto format_rows = nlohmann::json::parse(lutconv_in_process({"formats", "--json"}).out);
    ASSERT_EQ(format_rows.size(), lutlib::io::file_formats().size());
    for (const lutlib::FileFormat* const format : lutlib::io::file_formats()) {
        EXPECT_NE(("\n" + formats).find("\n" + std::string(format->name) + " "), std::string::npos);
    }
}

TEST(Errors, are_json_where_json_was_asked_for) {
    const Folder folder;
    const std::string bad = folder.write(
        "bad.cube", "LUT_3D_SIZE 2\n0 0 0\n0 0 x\n1 1 1\n1 1 1\n1 1 1\n1 1 1\n1 1 1\n1 1 1\n");
    const Result result = lutconv_in_process({"info", bad, "--json"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(result.err.starts_with("lutconv: ")) << result.err;
    const auto error = nlohmann::json::parse(result.out)["error"];
    EXPECT_EQ(error["file"], bad);
    EXPECT_EQ(error["line"], 3);
    EXPECT_EQ(error["exit_code"], 2);
    const auto usage = nlohmann::json::parse(lutconv_in_process({"info", "--json"}).out)["error"];
    EXPECT_EQ(usage["exit_code"], 3);
    EXPECT_TRUE(usage["file"].is_null());
    EXPECT_EQ(lutconv_in_process({"info", bad}).out, "");
}

TEST(Errors, of_usage_begin_with_the_programs_name) {
    EXPECT_TRUE(lutconv_in_process({"bake", "--no-such-flag"}).err.starts_with("lutconv: "));
}

TEST(Quiet, leaves_errors_warnings_and_json) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(3));
    const std::string png = folder.path("x.png");
    const Result bake = lutconv_in_process({"bake", look, "-o", png, "--quiet"});
    EXPECT_EQ(bake.exit_code, 0);
    EXPECT_EQ(bake.out + bake.err, "");
    EXPECT_EQ(lutconv_in_process({"bake", folder.path("gone.cube"), "-o", png, "--quiet"}).out, "");
    EXPECT_NE(lutconv_in_process({"bake", folder.path("gone.cube"), "-o", png, "--quiet"}).err, "");
    EXPECT_NE(lutconv_in_process({"bake", look, "-o", png, "--quiet", "--json"}).out, "");
    EXPECT_NE(lutconv_in_process({"bake", look, "-o", png}).out, "") << "the next run is loud";
}

TEST(Papers, have_a_page_a_verb_and_complete_verbs_options_and_values) {
    const Folder folder;
    ASSERT_EQ(lutconv_in_process({"--write-papers", folder.path("share")}).exit_code, 0);
    for (const std::string& verb : verbs()) {
        const std::string page = contents(folder.path("share/man/man1/lutconv-" + verb + ".1"));
        EXPECT_TRUE(page.starts_with(".TH LUTCONV")) << verb;
        EXPECT_NE(page.find("lutconv " + verb), std::string::npos) << verb;
    }
    const auto completed = [&](const std::string& line, int word) {
        return words_of(
            output_of_bash("source " + folder.path("share/bash-completion/completions/lutconv") +
                           "; COMP_WORDS=(" + line + "); COMP_CWORD=" + std::to_string(word) +
                           "; _lutconv; echo ${COMPREPLY[@]}"));
    };
    using Words = std::vector<std::string>;
    EXPECT_EQ(completed("lutconv ver", 1), Words{"verify"});
    EXPECT_EQ(completed("lutconv help ba", 2), Words{"bake"});
    EXPECT_EQ(completed("lutconv bake --eng", 2), Words{"--engine"});
    EXPECT_EQ(completed("lutconv bake --engine unr", 3), Words{"unreal"});
    EXPECT_EQ(completed("lutconv convert --format spi3", 3), Words{"spi3d"});
}

TEST(Version, names_the_program_and_what_it_loads) {
    const std::string text = lutconv_in_process({"--version"}).out;
    EXPECT_TRUE(text.starts_with("lutconv " + std::string(lutlib::version) + "\nOpenColorIO 2."))
        << text;
    EXPECT_NE(text.find("\nOpenImageIO 2."), std::string::npos) << text;
    EXPECT_TRUE(lutconv_in_process({"--version", "--verbose"}).out.starts_with(text));
}

TEST(UsageErrors, name_the_option_that_was_meant) {
    EXPECT_NE(lutconv_in_process({"bake", "x.cube", "-o", "x.png", "--engin", "unity"})
                  .err.find("did you mean --engine?"),
              std::string::npos);
}

TEST(UsageErrors, spell_out_what_would_command_the_terminal) {
    const Result result = lutconv({"bake", "x.cube", "-o", "y.png", "--\x1b[31m"});
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_EQ(result.err.find('\x1b'), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("\\x1b[31m"), std::string::npos) << result.err;
}

} // namespace
} // namespace converter_test
