#include "terminal/command_line.h"

#include "lutlib/error.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace terminal {
namespace {

/// A program with a verb, whose options are declared in another order than they are typed in.
struct Program {
    Program() {
        app.set_version_flag("--version", "program 1");
        CLI::App& verb = *app.add_subcommand("bake", "Bakes");
        verb.add_option("--bits", bits, "Bits")->check(CLI::Range(8, 16));
        verb.add_option("--size", size, "Size")->check(CLI::Range(2, 64));
        verb.add_option_function<std::string>(
            "--engine", [](const std::string& name) { throw lutlib::UsageError("no " + name); },
            "Engine");
        verb.add_option("-o,--output", output, "Output")->required();
    }

    std::optional<std::string> run(std::vector<const char*> words) {
        words.insert(words.begin(), "program");
        return parse(app, static_cast<int>(words.size()), words.data());
    }

    /// What it refuses the words with; empty where it takes them.
    std::string refusal(const std::vector<const char*>& words) {
        try {
            run(words);
            return {};
        } catch (const lutlib::UsageError& error) {
            return error.what();
        }
    }

    CLI::App app{"Does things", "program"};
    int bits = 8, size = 16;
    std::string output;
};

TEST(CommandLine, that_is_right_is_read) {
    Program program;
    EXPECT_EQ(program.run({"bake", "-o", "x", "--size", "5"}), std::nullopt);
    EXPECT_EQ(program.size, 5);
    EXPECT_EQ(program.output, "x");
}

TEST(CommandLine, that_asks_for_help_or_the_version_gets_it) {
    EXPECT_EQ(Program().run({"--version"}), "program 1\n");
    const std::string help = *Program().run({"bake", "--help"});
    EXPECT_NE(help.find("--size"), std::string::npos) << help;
    EXPECT_FALSE(help.ends_with("\n\n"));
}

TEST(CommandLine, is_refused_for_the_mistake_that_was_typed_first) {
    EXPECT_EQ(Program().refusal({"bake", "-o", "x", "--size", "1", "--bits", "1"}).find("--size"),
              0U);
    EXPECT_EQ(Program().refusal({"bake", "-o", "x", "--bits", "1", "--size", "1"}).find("--bits"),
              0U);
    EXPECT_EQ(Program().refusal({"bake", "--engine", "quake", "-o", "x", "--bits", "1"}),
              "no quake");
    EXPECT_EQ(
        Program().refusal({"bake", "--bits", "1", "--engine", "quake", "-o", "x"}).find("--bits"),
        0U);
    EXPECT_EQ(Program().refusal({"bake", "-o", "x", "one", "two"}),
              "this was not expected: one two; 'program help bake' shows what there is");
}

TEST(CommandLine, with_a_misspelled_option_hears_which_was_meant) {
    const std::string said = "there is no option '--siez'; did you mean --size? 'program help "
                             "bake' shows what there is";
    EXPECT_EQ(Program().refusal({"bake", "-o", "x", "--siez", "5"}), said);
    EXPECT_EQ(Program().refusal({"bake", "-o", "x", "--siez=5"}), said);
    EXPECT_EQ(Program()
                  .refusal({"bake", "--outputt", "x"})
                  .find("there is no option '--outputt'; did you mean --output?"),
              0U);
    EXPECT_EQ(Program().refusal({"bake", "-o", "x", "--nothing-like-it"}),
              "there is no option '--nothing-like-it'; 'program help bake' shows what there is");
    EXPECT_EQ(Program().refusal({"bake"}),
              "--output is required; 'program help bake' shows what there is");
}

} // namespace
} // namespace terminal
