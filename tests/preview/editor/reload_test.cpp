// What becomes of looks in the window's states when their files change, without files that change.
#include "preview/editor/reload.h"

#include "lutlib/error.h"
#include "preview/editor/commands.h"
#include "tests/preview/editor/look_files.h"

#include <gtest/gtest.h>

namespace preview::editor {
namespace {

namespace fs = std::filesystem;
using lutlib::ScratchFolder;
using lutlib::io::Look;

class Reload : public testing::Test {
  protected:
    std::string write(const std::string& name, const std::string& text) const {
        overwrite(folder_.file(name), text);
        return folder_.file(name);
    }
    void open(const std::string& path) {
        open_look(history_.draft(), Look::open(path));
        history_.settle();
    }
    State& draft() { return history_.draft(); }
    /// Reads what the draft is made of again, as the follower does.
    std::shared_ptr<const Look> reread() {
        std::shared_ptr<const Look> offered;
        for (const FollowedFile& file : followed_looks(draft())) {
            if (auto look = file.read()(history_)) {
                offered = std::move(look);
            }
        }
        return offered;
    }
    std::vector<std::string> keys() {
        std::vector<std::string> out;
        for (const FollowedFile& file : followed_looks(draft())) {
            out.push_back(file.key.substr(0, file.key.find(' ')));
        }
        return out;
    }
    std::size_t steps_back() {
        std::size_t out = 0;
        while (history_.undo()) {
            ++out;
        }
        return out;
    }

    ScratchFolder folder_;
    History history_{initial_state()};
};

TEST_F(Reload, of_a_lut_replaces_it_under_every_edit_that_undo_brings_back) {
    const std::string look = write("look.cube", cube_of(0.5));
    open(look);
    add_operation(draft().recipe, *lutlib::op_named("exposure"));
    history_.settle();
    draft().recipe.operations[0].values[0] = 1.0;
    history_.settle();
    const double edited = white_of(draft().recipe);
    write("look.cube", cube_of(0.25));
    EXPECT_EQ(reread(), nullptr);
    EXPECT_LT(white_of(draft().recipe), edited);
    EXPECT_TRUE(is_unsaved(draft())) << "the edits are what they were";
    EXPECT_EQ(stops_of(draft().recipe), 1.0);
    EXPECT_TRUE(history_.undo());
    EXPECT_NEAR(white_of(draft().recipe), 0.25, 1e-6);
    EXPECT_TRUE(history_.undo());
    EXPECT_NEAR(white_of(draft().recipe), 0.25, 1e-6);
    EXPECT_FALSE(is_unsaved(draft()));
    EXPECT_TRUE(history_.undo());
    EXPECT_EQ(draft().recipe.base_lut, nullptr);
    EXPECT_FALSE(history_.undo()) << "the reload made a step";
}

TEST_F(Reload, of_a_lut_brings_its_title_unless_a_person_gave_another) {
    const std::string look = write("look.cube", "TITLE \"one\"\n" + cube_of(0.5));
    open(look);
    draft().recipe.title = "mine";
    history_.settle();
    write("look.cube", "TITLE \"two\"\n" + cube_of(0.5));
    reread();
    EXPECT_EQ(draft().recipe.title, "mine");
    history_.undo();
    EXPECT_EQ(draft().recipe.title, "two");
}

TEST_F(Reload, of_the_same_content_changes_nothing) {
    open(write("look.cube", cube_of(0.5)));
    open_side(draft().sides[0], Look::open(folder_.file("look.cube")));
    history_.settle();
    const State before = draft();
    EXPECT_EQ(keys(), (std::vector<std::string>{"base", "side"}));
    EXPECT_EQ(reread(), nullptr);
    EXPECT_TRUE(draft() == before) << "a table is another object";
    open(write("look.json", recipe_of(1, "look.cube")));
    const State recipe = draft();
    EXPECT_EQ(reread(), nullptr);
    EXPECT_TRUE(draft() == recipe);
    EXPECT_EQ(steps_back(), 3U);
}

TEST_F(Reload, of_a_recipe_is_a_step_that_undo_takes_back) {
    const std::string path = write("look.json", recipe_of(1));
    open(path);
    draft().exposure = 2;
    history_.settle();
    history_.undo();
    write("look.json", recipe_of(2));
    EXPECT_EQ(reread(), nullptr);
    EXPECT_EQ(stops_of(draft().recipe), 2);
    EXPECT_FALSE(is_unsaved(draft()));
    EXPECT_TRUE(history_.undo());
    EXPECT_EQ(stops_of(draft().recipe), 1);
    EXPECT_TRUE(is_unsaved(draft())) << "the file holds another";
    EXPECT_TRUE(history_.redo());
    EXPECT_TRUE(history_.redo()) << "what could be redone is lost";
    EXPECT_EQ(draft().exposure, 2);
}

TEST_F(Reload, of_a_recipe_beside_unsaved_changes_keeps_them_and_offers_the_files) {
    const std::string path = write("look.json", recipe_of(1));
    open(path);
    draft().recipe.operations[0].values[0] = 3.0;
    write("look.json", recipe_of(2));
    const std::shared_ptr<const Look> offered = reread();
    ASSERT_NE(offered, nullptr);
    EXPECT_EQ(stops_of(draft().recipe), 3);
    EXPECT_TRUE(is_offered(draft(), *offered));
    draft().recipe.operations[0].values[0] = 1.0;
    EXPECT_TRUE(is_unsaved(draft())) << "as it was opened, which the file is not any more";
    draft().recipe.operations[0].values[0] = 2.0;
    EXPECT_FALSE(is_unsaved(draft())) << "what the file holds now";
    EXPECT_FALSE(is_offered(draft(), *offered));
    draft().recipe.operations[0].values[0] = 3.0;
    take_offered(history_, *offered);
    EXPECT_EQ(stops_of(draft().recipe), 2);
    EXPECT_FALSE(is_unsaved(draft()));
    EXPECT_TRUE(history_.undo());
    EXPECT_EQ(stops_of(draft().recipe), 3);
    save_recipe(history_, path);
    EXPECT_FALSE(is_offered(draft(), *offered));
}

TEST_F(Reload, of_a_recipe_that_came_to_be_what_is_shown_saves_it) {
    open(write("look.json", recipe_of(1)));
    draft().recipe.operations[0].values[0] = 3.0;
    write("look.json", recipe_of(3));
    EXPECT_EQ(reread(), nullptr);
    EXPECT_FALSE(is_unsaved(draft()));
}

TEST_F(Reload, of_a_recipes_base_keeps_unsaved_changes_and_takes_the_base) {
    write("base.cube", cube_of(0.5));
    open(write("look.json", recipe_of(0, "base.cube")));
    EXPECT_EQ(followed_looks(draft()).at(0).files,
              (std::vector<std::string>{folder_.file("look.json"), folder_.file("base.cube")}));
    draft().recipe.operations[0].enabled = false;
    write("base.cube", cube_of(0.25));
    EXPECT_EQ(reread(), nullptr);
    EXPECT_NEAR(white_of(draft().recipe), 0.25, 1e-6);
    EXPECT_FALSE(draft().recipe.operations[0].enabled);
    EXPECT_TRUE(is_unsaved(draft()));
    write("other.cube", cube_of(0.75));
    write("look.json", recipe_of(0, "other.cube"));
    draft().recipe.operations[0].enabled = true;
    EXPECT_FALSE(is_unsaved(draft()));
    EXPECT_EQ(reread(), nullptr);
    EXPECT_NEAR(white_of(draft().recipe), 0.75, 1e-6);
    EXPECT_EQ(draft().base_path, folder_.file("other.cube"));
}

TEST_F(Reload, of_what_the_window_itself_has_saved_is_none_wherever_its_base_lies) {
    const ScratchFolder elsewhere;
    open(write("look.cube", cube_of(0.5)));
    add_operation(draft().recipe, *lutlib::op_named("exposure"));
    for (const std::string& path : {folder_.file("look.json"), elsewhere.file("look.json")}) {
        save_recipe(history_, path);
        history_.settle();
        const State saved = draft();
        EXPECT_EQ(reread(), nullptr) << path;
        EXPECT_TRUE(draft() == saved) << path;
        EXPECT_FALSE(is_unsaved(draft()));
        write("look.cube", cube_of(0.25));
        EXPECT_EQ(reread(), nullptr);
        EXPECT_NEAR(white_of(draft().recipe), 0.25, 1e-6) << path;
        EXPECT_FALSE(is_unsaved(draft()));
        write("look.cube", cube_of(0.5));
        EXPECT_EQ(reread(), nullptr);
    }
    // By others it is refused as at its opening.
    overwrite(elsewhere.file("look.json"),
              recipe_of(1, "../" + folder_.path().filename().string() + "/look.cube"));
    EXPECT_THROW(reread(), lutlib::Error);
    EXPECT_FALSE(is_unsaved(draft()));
}

TEST_F(Reload, of_a_side_replaces_its_table_where_that_file_is_shown_with_the_same_encodings) {
    const std::string path = write("side.cube", cube_of(0.5));
    const lutlib::LookEncodings said{*lutlib::encoding_named("logc3"), std::nullopt};
    open_side(draft().sides[0], Look::open(path));
    history_.settle();
    open_side(draft().sides[1], Look::open(path, {.encodings = said}), said);
    history_.settle();
    EXPECT_EQ(keys(), (std::vector<std::string>{"side", "side"}));
    write("side.cube", cube_of(0.25));
    reread();
    for (const Side& side : draft().sides) {
        EXPECT_NEAR(white_of(side.lut), 0.25, 1e-6);
    }
    EXPECT_EQ(draft().sides[0].lut->encodings.input, "");
    EXPECT_EQ(lutlib::encoding_named(draft().sides[1].lut->encodings.input), said.input);
    EXPECT_TRUE(history_.undo());
    EXPECT_NEAR(white_of(draft().sides[0].lut), 0.25, 1e-6);
    EXPECT_EQ(steps_back(), 1U);
}

TEST_F(Reload, follows_the_base_of_a_recipe_on_a_side) {
    write("base.cube", cube_of(0.5));
    const std::string path = write("side.json", recipe_of(0, "base.cube"));
    open_side(draft().sides[0], Look::open(path));
    EXPECT_EQ(draft().sides[0].files, (std::vector<std::string>{path, folder_.file("base.cube")}));
    write("base.cube", cube_of(0.25));
    reread();
    EXPECT_NEAR(white_of(draft().sides[0].lut), 0.25, 1e-6);
}

TEST_F(Reload, of_a_file_of_another_kind_is_refused_with_the_remedy) {
    const auto refusal = [&] {
        const State before = draft();
        try {
            reread();
        } catch (const lutlib::Error& error) {
            EXPECT_TRUE(draft() == before);
            return error.message();
        }
        return std::string();
    };
    open(write("look.cube", cube_of(0.5)));
    write("look.cube", recipe_of(1));
    EXPECT_NE(refusal().find("it is a recipe now"), std::string::npos);
    open(write("look.json", recipe_of(1)));
    write("look.json", cube_of(0.5));
    EXPECT_NE(refusal().find("it is a LUT now"), std::string::npos);
    for (const char* const damage : {"{\"schema_version\": 1, ", "{}", "\xff\xfe"}) {
        write("look.json", damage);
        EXPECT_NE(refusal(), "") << damage;
    }
    write("look.json", "");
    EXPECT_NE(refusal().find("empty"), std::string::npos);
    fs::remove(folder_.file("look.json"));
    EXPECT_NE(refusal().find("No such file"), std::string::npos);
    fs::create_directory(folder_.file("look.json"));
    EXPECT_NE(refusal(), "");
}

TEST_F(Reload, is_not_needed_to_know_that_saving_would_lose_what_others_wrote) {
    write("base.cube", cube_of(0.5));
    const std::string path = write("look.json", recipe_of(1, "base.cube"));
    open(path);
    draft().recipe.operations[0].values[0] = 3.0;
    EXPECT_TRUE(is_file_as_saved(draft())) << "as it was opened";
    write("look.json", " " + recipe_of(1, "base.cube"));
    EXPECT_TRUE(is_file_as_saved(draft())) << "it says the same";
    for (const std::string& theirs :
         {recipe_of(2, "base.cube"), recipe_of(1), std::string("{"), std::string(), cube_of(1)}) {
        write("look.json", theirs);
        EXPECT_FALSE(is_file_as_saved(draft())) << theirs;
    }
    save_recipe(history_, path);
    EXPECT_TRUE(is_file_as_saved(draft()));
    fs::remove(path);
    EXPECT_TRUE(is_file_as_saved(draft()));
    fs::create_directory(path);
    EXPECT_FALSE(is_file_as_saved(draft()));
}

TEST_F(Reload, leaves_what_is_no_file_alone) {
    draft().recipe_path = "-";
    draft().base_path = "/dev/null";
    draft().recipe.base_lut = std::make_shared<const lutlib::Lut>();
    draft().sides[0].path = "-";
    draft().sides[0].lut = draft().recipe.base_lut;
    EXPECT_TRUE(followed_looks(draft()).empty());
}

} // namespace
} // namespace preview::editor
