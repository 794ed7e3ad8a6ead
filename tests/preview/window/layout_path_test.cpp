// Where the window's settings file lies.
#include "preview/window/gui.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

namespace preview {
namespace {

namespace fs = std::filesystem;

/// Sets both variables of the environment for a test, or unsets them.
class LayoutPath : public testing::Test {
  protected:
    void SetUp() override {
        for (Variable& variable : variables_) {
            if (const char* const value = std::getenv(variable.name)) {
                variable.before = value;
            }
        }
    }
    void TearDown() override {
        for (const Variable& variable : variables_) {
            set(variable.name, variable.before);
        }
    }

    static void set(const char* name, const std::optional<std::string>& value) {
        if (value) {
            ::setenv(name, value->c_str(), 1);
        } else {
            ::unsetenv(name);
        }
    }
    static std::string path_for(const std::optional<std::string>& config,
                                const std::optional<std::string>& home) {
        set("XDG_CONFIG_HOME", config);
        set("HOME", home);
        return layout_path();
    }

    lutlib::ScratchFolder scratch_;

  private:
    struct Variable {
        const char* name;
        std::optional<std::string> before{};
    };
    Variable variables_[2] = {{"XDG_CONFIG_HOME"}, {"HOME"}};
};

TEST_F(LayoutPath, lies_in_the_configuration_folder_that_is_named_and_makes_its_own) {
    const fs::path config = scratch_.path() / "settings";
    EXPECT_EQ(path_for(config, scratch_.file("home")),
              (config / "lutpreview" / "layout.ini").string());
    EXPECT_TRUE(fs::is_directory(config / "lutpreview"));
    EXPECT_FALSE(fs::exists(scratch_.path() / "home"));
}

TEST_F(LayoutPath, is_in_the_home_folder_where_none_is_named) {
    const std::string home = scratch_.path().string();
    const std::string expected =
        (scratch_.path() / ".config" / "lutpreview" / "layout.ini").string();
    EXPECT_EQ(path_for(std::nullopt, home), expected);
    EXPECT_EQ(path_for("", home), expected);
    EXPECT_EQ(path_for("relative", home), expected);
    EXPECT_FALSE(fs::exists("relative"));
}

TEST_F(LayoutPath, is_empty_where_there_is_neither) {
    EXPECT_EQ(path_for(std::nullopt, std::nullopt), "");
    EXPECT_EQ(path_for("", ""), "");
}

TEST_F(LayoutPath, is_empty_where_its_folder_cannot_be_made) {
    const std::string in_the_way = scratch_.file("in-the-way");
    std::ofstream(in_the_way) << "a file";
    EXPECT_EQ(path_for(in_the_way, std::nullopt), "");
}

TEST_F(LayoutPath, stays_where_it_was_with_what_is_in_it) {
    const std::string path = path_for(scratch_.path().string(), std::nullopt);
    std::ofstream(path) << "[Window][View]\n";
    EXPECT_EQ(path_for(scratch_.path().string(), std::nullopt), path);
    std::string line;
    std::getline(std::ifstream(path), line);
    EXPECT_EQ(line, "[Window][View]");
}

} // namespace
} // namespace preview
