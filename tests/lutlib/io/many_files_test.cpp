#include "lutlib/io/inputs.h"
#include "lutlib/io/output_names.h"

#include "lutlib/error.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>

namespace lutlib::io {
namespace {

namespace fs = std::filesystem;

bool is_picture(const std::string& extension) {
    return extension == "png" || extension == "exr";
}

void put(const std::string& path) {
    std::ofstream(path) << "x";
}

std::vector<std::string> names_of(const Inputs& inputs) {
    std::vector<std::string> out;
    for (const InputFile& file : inputs.files) {
        out.push_back(fs::path(file.path).filename().string() + " " + file.frame);
    }
    return out;
}

Inputs found(const std::vector<std::string>& words, const std::string& frames = "") {
    return find_inputs(words, frames, is_picture);
}

using Names = std::vector<std::string>;

TEST(Inputs, of_a_folder_are_its_pictures_by_name_and_what_is_left_out_is_said) {
    const ScratchFolder folder;
    for (const char* const name : {"b.2.png", "a.exr", ".hidden.png", "notes.txt", "C.PNG"}) {
        put(folder.file(name));
    }
    fs::create_directory(folder.file("sub.png"));
    const Inputs inputs = found({folder.file("")});
    EXPECT_EQ(names_of(inputs), (Names{"C.PNG ", "a.exr ", "b.2.png 2"}));
    ASSERT_EQ(inputs.remarks.size(), 1U);
    EXPECT_NE(inputs.remarks[0].find("left out 1 file of types"), std::string::npos);
    EXPECT_TRUE(inputs.are_listed);
}

TEST(Inputs, of_a_pattern_are_the_frames_there_are_by_number_and_gaps_are_said) {
    const ScratchFolder folder;
    for (const char* const name :
         {"s.0010.png", "s.0002.png", "s.12000.png", "s.0003.png", "s.0001.exr", "s.2.png"}) {
        put(folder.file(name));
    }
    const Inputs inputs = found({folder.file("s.####.png")});
    EXPECT_EQ(names_of(inputs), (Names{"s.0002.png 0002", "s.0003.png 0003", "s.0010.png 0010",
                                       "s.12000.png 12000"}));
    ASSERT_EQ(inputs.remarks.size(), 1U);
    EXPECT_NE(inputs.remarks[0].find("11995 numbers"), std::string::npos) << inputs.remarks[0];
    EXPECT_NE(inputs.remarks[0].find("4-9, 11-11999"), std::string::npos) << inputs.remarks[0];
    EXPECT_EQ(names_of(found({folder.file("s.%04d.png")})), names_of(inputs));
}

TEST(Inputs, that_frames_name_need_not_be_there) {
    EXPECT_EQ(names_of(found({"none/s.####.png"}, "1001-1005x2")),
              (Names{"s.1001.png 1001", "s.1003.png 1003", "s.1005.png 1005"}));
    EXPECT_THROW(found({"s.png"}, "1-2"), UsageError);
}

TEST(Inputs, whose_own_name_looks_like_a_pattern_are_that_file) {
    const ScratchFolder folder;
    put(folder.file("s.##.png"));
    put(folder.file("s.01.png"));
    const Inputs inputs = found({folder.file("s.##.png"), "-", "take 12b.png"});
    EXPECT_EQ(names_of(inputs), (Names{"s.##.png ", "- ", "take 12b.png 12"}));
    EXPECT_FALSE(inputs.are_listed);
}

TEST(Inputs, are_demanded_of_folders_and_patterns) {
    const ScratchFolder folder;
    put(folder.file("a.txt"));
    EXPECT_THROW(found({folder.file("")}), Error);
    EXPECT_THROW(found({folder.file("s.##.png")}), Error);
    EXPECT_THROW(found({folder.file("none/s.##.png")}), Error);
}

struct Made {
    const char* name;
    const char* path;
};

TEST(OutputTemplate, fills_in_what_an_input_gives_once) {
    const InputFile input{"in/shot.{ext}.0007.exr", "0007"};
    for (const auto& [name, path] :
         {Made{"out/{name}.{ext}", "out/shot.{ext}.0007.exr"}, Made{"x.{frame}.png", "x.0007.png"},
          Made{"x.##.png", "x.07.png"}, Made{"{engine}/%05d.{ext}", "unity/00007.exr"},
          Made{"{nmae}{.png", "{nmae}{.png"}, Made{"out/", "out/shot.{ext}.0007.exr"}}) {
        const OutputTemplate made(name, {"engine"});
        const std::array<NameField, 1> fields{{{"engine", "unity"}}};
        EXPECT_EQ(made.path_for(input, fields), path);
    }
    EXPECT_FALSE(OutputTemplate("plain #1 {x}.png").varies());
    EXPECT_FALSE(OutputTemplate("{engine}.png").varies());
    EXPECT_TRUE(OutputTemplate("{engine}.png", {"engine"}).varies());
    EXPECT_TRUE(OutputTemplate("%04d.png").varies());
    EXPECT_THROW(OutputTemplate("{frame}.png").path_for({"a.png", ""}), UsageError);
}

TEST(OutputTemplate, takes_a_folder_that_is_there_for_one) {
    const ScratchFolder folder;
    EXPECT_EQ(OutputTemplate(folder.file("")).path_for({"a/b.c.png", ""}), folder.file("b.c.png"));
}

TEST(Routes, to_one_name_or_onto_each_others_inputs_are_refused) {
    const auto refused = [](const std::vector<Route>& routes) {
        try {
            require_distinct(routes);
        } catch (const UsageError&) {
            return true;
        }
        return false;
    };
    EXPECT_FALSE(refused({{{"a.png"}, "x/a.png"}, {{"b.png"}, "x/b.png"}}));
    EXPECT_FALSE(refused({{{"a.png"}, "a.png"}, {{"b.png"}, "b.png"}}));
    EXPECT_TRUE(refused({{{"a.png"}, "x/a.png"}, {{"b/a.png"}, "y/../x/./a.png"}}));
    EXPECT_TRUE(refused({{{"a.png"}, "-"}, {{"b.png"}, "-"}}));
    EXPECT_TRUE(refused({{{"a.1.png"}, "a.2.png"}, {{"a.2.png"}, "a.3.png"}}));
}

TEST(UpToDate, is_what_is_there_not_empty_and_newer_than_all_inputs) {
    const ScratchFolder folder;
    const std::string a = folder.file("a"), b = folder.file("b"), out = folder.file("out");
    put(a);
    put(b);
    const std::array<std::string, 2> inputs{a, b};
    EXPECT_FALSE(is_up_to_date(out, inputs));
    put(out);
    const auto at = [](const std::string& path, int seconds) {
        fs::last_write_time(path, fs::file_time_type::clock::now() + std::chrono::seconds(seconds));
    };
    at(a, -20);
    at(b, -10);
    at(out, -5);
    EXPECT_TRUE(is_up_to_date(out, inputs));
    at(out, -15);
    EXPECT_FALSE(is_up_to_date(out, inputs));
    fs::last_write_time(out, fs::last_write_time(b));
    EXPECT_FALSE(is_up_to_date(out, inputs)) << "it may have been made before the change";
    std::ofstream(out, std::ios::trunc).close();
    EXPECT_FALSE(is_up_to_date(out, inputs));
    put(out);
    at(out, 5);
    fs::remove(b);
    EXPECT_FALSE(is_up_to_date(out, inputs));
}

TEST(MakeFolders, makes_all_of_them_and_keeps_those_that_are_there) {
    const ScratchFolder folder;
    const std::vector<Route> routes{
        {{"a"}, folder.file("x/y/a.png")}, {{"b"}, folder.file("b.png")}, {{"c"}, "c.png"}};
    make_folders(routes);
    make_folders(routes);
    EXPECT_TRUE(fs::is_directory(folder.file("x/y")));
    put(folder.file("file"));
    EXPECT_THROW(make_folders(std::vector<Route>{{{"a"}, folder.file("file/a.png")}}), Error);
}

} // namespace
} // namespace lutlib::io
