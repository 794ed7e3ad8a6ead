// Reference stills on the sides: shown, taken off, read again.
#include "preview/editor/stills.h"

#include "lutlib/io/image.h"
#include "preview/editor/look_baker.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

namespace preview::editor {
namespace {

class Stills : public testing::Test {
  protected:
    void write(float grey) {
        lutlib::io::FloatImage image;
        image.width = image.height = 1;
        image.rgba = {grey, grey, grey, 1};
        lutlib::io::ImageWriteOptions options;
        options.depth = lutlib::io::Depth::uint8;
        static_cast<void>(lutlib::io::write_image(path_, image, options));
    }
    lutlib::ScratchFolder folder_;
    std::string path_ = folder_.file("reference.png");
};

TEST_F(Stills, are_shown_beside_what_the_other_side_shows_and_taken_off) {
    write(0.2F);
    State state = initial_state();
    state.compare = &compare_b;
    show_still(state, 0, load_still(path_));
    EXPECT_EQ(state.compare, &compare_split) << "side A is not seen else";
    EXPECT_EQ(title_of(state.sides[0]), "still reference");
    EXPECT_FALSE(look_of(state.recipe, state.sides[0], {}).skip_reason.empty()) << "it has no look";
    show_still(state, 1, load_still(path_));
    take_still_off(state, 0);
    take_still_off(state, 1);
    EXPECT_EQ(state.sides[0].source, SideSource::none);
    EXPECT_EQ(state.sides[1].source, SideSource::recipe);
    EXPECT_TRUE(followed_stills(state).empty());
}

TEST_F(Stills, that_another_look_has_taken_the_place_of_stay_until_they_are_taken_off) {
    write(0.2F);
    State state = initial_state();
    show_still(state, 0, load_still(path_));
    state.sides[0].source = SideSource::file;
    take_still_off(state, 0);
    EXPECT_EQ(state.sides[0].source, SideSource::file);
}

TEST_F(Stills, are_read_again_in_every_state_when_their_file_changes) {
    write(0.2F);
    History history(initial_state());
    show_still(history.draft(), 0, load_still(path_));
    history.settle();
    history.draft().exposure = 1;
    history.settle();
    write(0.8F);
    const std::vector<FollowedFile> followed = followed_stills(history.draft());
    ASSERT_EQ(followed.size(), 1U);
    EXPECT_EQ(followed[0].files, std::vector<std::string>{path_});
    EXPECT_EQ(followed[0].read()(history), nullptr);
    for (int step = 0; step < 2; ++step) {
        EXPECT_NEAR(history.draft().sides[0].still->rgba[0], 0.8, 1e-6);
        EXPECT_TRUE(history.undo());
    }
    EXPECT_EQ(history.draft().sides[0].still, nullptr);
    // One that is converted is another.
    History converted(initial_state());
    show_still(converted.draft(), 0, load_still(path_, lutlib::encoding_named("logc3")));
    EXPECT_NE(followed_stills(converted.draft())[0].key, followed[0].key);
    const auto before = converted.draft().sides[0].still;
    take_still(converted, load_still(path_));
    EXPECT_EQ(converted.draft().sides[0].still, before);
}

} // namespace
} // namespace preview::editor
