#include "lutlib/io/references.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/look.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <sys/stat.h>

namespace lutlib::io {
namespace {

namespace fs = std::filesystem;

std::string message_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

class References : public testing::Test {
  protected:
    void SetUp() override {
        fs::create_directory(folder_.file("in"));
        fs::create_directory(folder_.file("in/deeper"));
        write_file(folder_.file("secret"), "outside");
        write_file(folder_.file("in/deeper/b"), "inside");
    }
    void TearDown() override { allow_references_outside(false); }

    std::string read(const std::string& reference) const {
        return read_reference(folder_.file("in/names.json"), reference);
    }
    std::string refused(const std::string& reference) const {
        return message_of([&] { read(reference); });
    }

    ScratchFolder folder_;
};

TEST_F(References, lead_to_files_in_the_folder_of_the_file_that_names_them) {
    EXPECT_EQ(read("deeper/b"), "inside");
    EXPECT_EQ(read("deeper/../deeper/b"), "inside");
    EXPECT_EQ(read("../in/deeper/b"), "inside");
    EXPECT_EQ(read(folder_.file("in/deeper/b")), "inside");
    fs::create_symlink("deeper/b", folder_.file("in/link"));
    EXPECT_EQ(read("link"), "inside");
    EXPECT_NE(refused("nothing").find("in/nothing: cannot open the file"), std::string::npos);
}

TEST_F(References, that_lead_outside_are_refused_by_any_way_unless_that_is_allowed) {
    fs::create_symlink("../secret", folder_.file("in/link"));
    fs::create_directory_symlink("..", folder_.file("in/up"));
    // Whether it is there is not said either.
    for (const std::string& reference :
         {std::string("../secret"), folder_.file("secret"), std::string("link"),
          std::string("up/secret"), std::string("deeper/../../secret"), std::string("../nothing"),
          std::string("/etc/hostname"), std::string("..")}) {
        const std::string reason = refused(reference);
        EXPECT_NE(reason.find("it lies outside the folder of " + folder_.file("in/names.json") +
                              ", which names it; copy it there, or add --allow-outside"),
                  std::string::npos)
            << reference << ": " << reason;
    }
    allow_references_outside(true);
    EXPECT_EQ(read("../secret"), "outside");
    EXPECT_EQ(read("link"), "outside");
}

TEST_F(References, that_are_no_files_are_refused_at_once) {
    ASSERT_EQ(mkfifo(folder_.file("in/pipe").c_str(), 0600), 0);
    EXPECT_NE(refused("pipe").find("must be a file"), std::string::npos);
    EXPECT_NE(refused("deeper").find("must be a file"), std::string::npos);
    EXPECT_NE(refused("").find("must be a file"), std::string::npos);
    allow_references_outside(true);
    EXPECT_NE(refused("/dev/zero").find("must be a file"), std::string::npos);
    EXPECT_NE(refused("/proc/self/fd").find("must be a file"), std::string::npos);
}

TEST_F(References, of_a_recipe_hold_for_its_base) {
    const auto opened = [&](const std::string& base) {
        write_file(folder_.file("in/look.json"),
                   R"({"schema_version": 1, "operators": [], "base": ")" + base + "\"}");
        return message_of([&] { Look::open(folder_.file("in/look.json")); });
    };
    write_file(folder_.file("base.cube"), "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n");
    EXPECT_NE(opened("../base.cube").find("--allow-outside"), std::string::npos);
    fs::rename(folder_.file("base.cube"), folder_.file("in/base.cube"));
    EXPECT_EQ(opened("base.cube"), "no error");
    ASSERT_EQ(mkfifo(folder_.file("in/pipe.cube").c_str(), 0600), 0);
    EXPECT_NE(opened("pipe.cube").find("must be a file"), std::string::npos);
}

} // namespace
} // namespace lutlib::io
