#include "lutlib/io/module.h"

#include "lutlib/error.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace lutlib::io {
namespace {

namespace fs = std::filesystem;

std::string message_of(const std::string& file, const std::vector<std::string>& folders) {
    try {
        module_path(file, folders);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Module, lies_in_the_first_folder_that_has_it) {
    const fs::path folder = fs::path(testing::TempDir()) / "lutlib_module_test";
    fs::create_directories(folder / "a");
    fs::create_directories(folder / "b");
    std::ofstream(folder / "b" / "libx.so") << "x";
    const std::vector<std::string> folders{(folder / "a").string(), (folder / "b").string()};
    EXPECT_EQ(module_path("libx.so", folders), (folder / "b" / "libx.so").string());
    std::ofstream(folder / "a" / "libx.so") << "x";
    EXPECT_EQ(module_path("libx.so", folders), (folder / "a" / "libx.so").string());
    fs::remove_all(folder);
}

TEST(Module, that_is_missing_names_the_package_and_the_folders) {
    EXPECT_EQ(message_of("lutlib-reader", {"/a", "/b"}),
              "install the Debian package lutconv, or name the folder that holds lutlib-reader in "
              "LUTLIB_MODULE_PATH: it is not in /a, /b");
    EXPECT_EQ(loading_problem("lutlib_ocio", "libOpenColorIO.so.2.1: cannot open shared object "
                                             "file: No such file or directory"),
              "install the Debian package libopencolorio2.1, which this needs: "
              "libOpenColorIO.so.2.1: cannot open shared object file: No such file or directory");
    EXPECT_EQ(loading_problem("lutlib_oiio", "/x/liblutlib_oiio.so: undefined symbol: OpenImageIO"),
              "cannot load liblutlib_oiio.so: /x/liblutlib_oiio.so: undefined symbol: OpenImageIO");
}

TEST(Module, is_looked_for_where_the_program_says_then_the_environment_then_beside_the_library) {
    const std::vector<std::string> usual = module_folders();
    EXPECT_EQ(module_path("lutlib-reader", usual), module_path("lutlib-reader"));

    ::setenv("LUTLIB_MODULE_PATH", "relative:/named:.:", 1);
    set_module_folder("/said");
    std::vector<std::string> expected{"/said", "/named"};
    expected.insert(expected.end(), usual.begin(), usual.end());
    EXPECT_EQ(module_folders(), expected);
    set_module_folder("");
    ::unsetenv("LUTLIB_MODULE_PATH");

    EXPECT_THROW(set_module_folder("relative"), Error);
    for (const std::string& folder : usual) {
        EXPECT_TRUE(fs::path(folder).is_absolute()) << folder;
    }
}

} // namespace
} // namespace lutlib::io
