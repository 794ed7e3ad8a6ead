// What the file dialog lists, what is typed in it, and the files of late.
#include "preview/editor/folder_list.h"
#include "tests/preview/editor/look_files.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace preview::editor {
namespace {

namespace fs = std::filesystem;
using lutlib::ScratchFolder;

std::vector<std::string> names_in(const FolderList& list) {
    std::vector<std::string> out;
    for (const FolderEntry& entry : list.entries) {
        out.push_back(entry.name + (entry.is_folder ? "/" : ""));
    }
    return out;
}

TEST(FolderList, has_folders_first_and_files_of_the_kind_in_an_order_that_people_expect) {
    const ScratchFolder folder;
    for (const char* const name : {"b.cube", "A.cube", "a.cube", "c.PNG", "notes.txt",
                                   ".hidden.cube", "look.json", "model.glb"}) {
        overwrite(folder.file(name), "x");
    }
    fs::create_directory(folder.file("z"));
    fs::create_directory(folder.file(".git"));
    fs::create_symlink(folder.file("gone"), folder.file("leads nowhere.cube"));
    using Names = std::vector<std::string>;
    const std::string path = fs::path(folder.file("x")).parent_path().string();
    const auto listed = [&](std::string_view label) {
        const auto kinds = file_kinds();
        return names_in(
            list_folder(path, *std::find_if(kinds.begin(), kinds.end(), [&](const FileKind& kind) {
                            return kind.label == label;
                        })));
    };
    EXPECT_EQ(listed("every file"),
              (Names{"z/", "A.cube", "a.cube", "b.cube", "c.PNG", "leads nowhere.cube", "look.json",
                     "model.glb", "notes.txt"}));
    EXPECT_EQ(listed("models"), (Names{"z/", "model.glb"}));
    EXPECT_EQ(listed("pictures"), (Names{"z/", "c.PNG"}));
    EXPECT_EQ(names_in(list_folder(path, file_kinds().front())),
              (Names{"z/", "A.cube", "a.cube", "b.cube", "c.PNG", "leads nowhere.cube", "look.json",
                     "model.glb"}));
    const FolderList none = list_folder(path + "/absent", file_kinds().front());
    EXPECT_TRUE(none.entries.empty());
    EXPECT_NE(none.reason.find("absent"), std::string::npos);
}

TEST(FolderList, takes_what_is_typed_as_a_path) {
    EXPECT_EQ(path_in("/a/b", "c.cube"), "/a/b/c.cube");
    EXPECT_EQ(path_in("/a/b", ".."), "/a");
    EXPECT_EQ(path_in("/", ".."), "/");
    EXPECT_EQ(path_in("/a/b", "/c/./d/"), "/c/d");
    setenv("HOME", "/home/somebody", 1);
    EXPECT_EQ(path_in("/a/b", "~"), "/home/somebody");
    EXPECT_EQ(path_in("/a/b", "~/x.cube"), "/home/somebody/x.cube");
    EXPECT_EQ(path_in("/a/b", "~x"), "/a/b/~x");
}

TEST(RecentFiles, are_the_newest_each_once) {
    std::vector<std::string> recent;
    for (int i = 0; i < 20; ++i) {
        remember_file(recent, "/f" + std::to_string(i));
    }
    EXPECT_EQ(recent.size(), most_recent_files);
    remember_file(recent, "/x/../f15");
    EXPECT_EQ(recent[0], "/f15");
    EXPECT_EQ(recent[1], "/f19");
    EXPECT_EQ(recent.size(), most_recent_files);
    EXPECT_EQ(std::count(recent.begin(), recent.end(), "/f15"), 1);
    remember_file(recent, "here.cube");
    EXPECT_EQ(recent[0], (fs::current_path() / "here.cube").string());
}

} // namespace
} // namespace preview::editor
