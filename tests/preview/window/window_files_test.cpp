// The window while the files that it shows change on disk, and its way into an engine's folder.
#include "tests/preview/scene/gltf_writer.h"
#include "tests/preview/window/window_fixture.h"

namespace desktop {
namespace {

namespace fs = std::filesystem;

class WindowFiles : public Window {
  protected:
    static std::string shown_as(const std::string& color) {
        std::string out = "LUT_3D_SIZE 2\n";
        for (int node = 0; node < 8; ++node) {
            out += color + "\n";
        }
        return out;
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(file(name), std::ios::binary) << text;
    }
    void rename_over(const std::string& name, const std::string& text) const {
        write(name + ".new", text);
        fs::rename(file(name + ".new"), file(name));
    }
    /// The colour in the middle of that half of the picture, 0xRRGGBB.
    std::uint32_t color(const Screen& screen, double across) const {
        const Point at = picture().at(across, 0.5);
        return screen.pixels[static_cast<std::size_t>(at.y * screen.width + at.x)] & 0xffffff;
    }
    Screen when_right_is(std::uint32_t wanted) {
        return screen_where([&](const Screen& now) { return color(now, 0.75) == wanted; },
                            "the colour on the right");
    }
    bool has(const std::string& place) const { return places().count(place) > 0; }
};

TEST_F(WindowFiles, shows_a_look_as_it_is_written_and_the_reason_while_it_is_damaged) {
    write("look.cube", shown_as("1 0 0"));
    start({"picture.ppm", "--b", "look.cube"});
    const Screen red = when_right_is(0xff0000);
    write("look.cube", shown_as("0 1 0"));
    const Screen green = when_right_is(0x00ff00);
    EXPECT_EQ(green.changed(red, between(0, 0.5)), 0);
    rename_over("look.cube", shown_as("0 0 1"));
    const Screen blue = when_right_is(0x0000ff);
    EXPECT_FALSE(has("notice.0"));
    write("look.cube", "LUT_3D_SIZE 2\n1 1 1\n");
    wait_until([&] { return has("notice.0"); }, "the reason");
    screen_where(is(blue), "what was read before");
    fs::remove(file("look.cube"));
    rest();
    EXPECT_TRUE(has("notice.0"));
    screen_where(is(blue), "what was read before");
    write("look.cube", shown_as("1 0 0"));
    when_right_is(0xff0000);
    wait_until([&] { return !has("notice.0"); }, "no reason any more");
    rest();
    // The window has nothing to undo of all that but the first look.
    key("ctrl+z");
    rest();
    EXPECT_EQ(color(desktop_->grab(), 0.75), 0xff0000U);
}

TEST_F(WindowFiles, reads_a_picture_again_with_its_exposure_and_undo_as_they_were) {
    start({"picture.ppm", "--exposure", "-1"});
    const Screen before = first_screen();
    gradient(400, 480).write(file("same.ppm"));
    Screen white{400, 480, std::vector<std::uint32_t>(std::size_t{400} * 480, 0xffffff)};
    white.write(file("white.ppm"));
    fs::rename(file("white.ppm"), file("picture.ppm"));
    const Screen half = screen_where(
        [&](const Screen& now) { return now.changed(before, picture()) > 0.9; }, "the new picture");
    EXPECT_NEAR(color(half, 0.25) & 0xff, 255.0 / 2, 1) << "white by half";
    write("picture.ppm", "P6 400 480 255\nshort");
    wait_until([&] { return has("notice.0"); }, "the reason");
    screen_where(is(half), "what was read before");
    fs::rename(file("same.ppm"), file("picture.ppm"));
    screen_where(is(before), "the picture as it was");
    wait_until([&] { return !has("notice.0"); }, "no reason any more");
}

TEST_F(WindowFiles, reads_a_model_again_and_keeps_the_camera) {
    const auto write_model = [&](std::array<double, 3> color) {
        preview::GltfWriter gltf;
        gltf.add("materials", {{"emissiveFactor", color}, {"doubleSided", true}});
        gltf.add_node({{"mesh", gltf.add_mesh(preview::square_corners())}});
        gltf.write(file("model.gltf"));
    };
    write_model({1, 0, 1});
    start({"model.gltf", "--raster", "compute"});
    const Screen before = first_screen();
    const Area all = picture();
    drag(all.at(0.2, 0.3), all.at(0.25, 0.35), all.at(0.35, 0.4));
    const Screen turned = screen_where(
        [&](const Screen& now) { return now.changed(before, picture()) > 0.05; }, "a turn");
    write_model({0, 1, 0});
    const Screen green = screen_where(
        [&](const Screen& now) { return now.changed(turned, picture()) > 0.02; }, "another colour");
    write("model.gltf", "{");
    wait_until([&] { return has("notice.0"); }, "the reason");
    screen_where(is(green), "what was read before");
    write_model({1, 0, 1});
    screen_where(is(turned), "the first model as it was turned");
    key("ctrl+z");
    screen_where(is(before), "the first camera");
}

TEST_F(WindowFiles, keeps_unsaved_changes_of_a_recipe_and_offers_the_files) {
    const auto recipe = [](const char* stops) {
        return std::string(R"({"schema_version": 1, "operators": [{"op": "exposure", "stops": )") +
               stops + "}]}";
    };
    write("look.json", recipe("0"));
    start({"picture.ppm", "--b", "look.json"});
    const Screen plain = first_screen();
    write("look.json", recipe("-6"));
    const Screen dark = screen_where(
        [&](const Screen& now) { return now.changed(plain, between(0.5, 1)) > 0.5; }, "the recipe");
    key("ctrl+z");
    screen_where(is(plain), "the recipe as it was opened");
    EXPECT_FALSE(has("offer"));
    write("look.json", recipe("-5"));
    wait_until([&] { return has("offer.take"); }, "the question");
    screen_where(is(plain), "what is not saved");
    key("ctrl+s");
    click("replace.no");
    EXPECT_EQ(contents("look.json"), recipe("-5")) << "it was written over";
    click("offer.take");
    screen_where([&](const Screen& now) { return now.changed(plain, between(0.5, 1)) > 0.5; },
                 "the file's");
    EXPECT_FALSE(has("offer"));
    key("ctrl+z");
    screen_where(is(plain), "what was not saved");
    write("look.json", recipe("-6"));
    wait_until([&] { return has("offer.keep"); }, "the question again");
    click("offer.keep");
    EXPECT_FALSE(has("offer"));
    screen_where(is(plain), "what is not saved");
    key("ctrl+s");
    wait_until([&] { return contents("look.json") != recipe("-6"); }, "the file written");
    rest();
    EXPECT_FALSE(has("offer")) << "of what it has written itself";
    EXPECT_FALSE(has("notice.0"));
    write("look.json", "{");
    wait_until([&] { return has("notice.0"); }, "the reason");
    key("ctrl+s");
    click("replace.no");
    EXPECT_EQ(contents("look.json"), "{") << "what somebody types was written over";
    EXPECT_NE(dark.changed(plain, picture()), 0);
}

TEST_F(WindowFiles, exports_into_an_engines_folder_at_the_press_of_a_key) {
    fs::create_directory(file("game"));
    start({"picture.ppm", "--b", "look.cube", "--engine", "unity", "--watch-engine-folder",
           file("game").string()});
    first_screen();
    key("ctrl+e");
    wait_until([&] { return has("exported"); }, "what was exported");
    EXPECT_EQ(verify("game/look.png", "look.cube"), 0);
    EXPECT_EQ(
        say({LUTCONV, "verify", "game/look.png", "--against", "look.cube", "--engine", "unity"},
            desktop_->folder())
            .code,
        0);
    click("exported.close");
    EXPECT_FALSE(has("exported"));
    // Its own file is written over, and the look that the file holds now.
    write("look.cube", shown_as("1 0 0"));
    when_right_is(0xff0000);
    click("tab.Files");
    click("export-engine");
    wait_until([&] { return has("exported"); }, "what was exported");
    EXPECT_EQ(verify("game/look.png", "look.cube"), 0);
    // Somebody else's is not.
    gradient(16, 16).write(file("game/look.png"));
    const std::string theirs = contents("game/look.png");
    key("ctrl+e");
    click("replace.no");
    EXPECT_EQ(contents("game/look.png"), theirs);
    key("ctrl+e");
    click("replace.yes");
    EXPECT_EQ(verify("game/look.png", "look.cube"), 0);
    fs::remove_all(file("game"));
    key("ctrl+e");
    wait_until([&] { return has("error.close"); }, "the error");
    click("error.close");
    std::size_t entries = 0;
    for (const auto& entry : fs::directory_iterator(desktop_->folder())) {
        entries += entry.path().filename().string().find("look.png") != std::string::npos;
    }
    EXPECT_EQ(entries, 0U);
}

TEST_F(WindowFiles, rests_while_others_change) {
    start({"picture.ppm", "--b", "look.cube"});
    first_screen();
    rest();
    const int last = frame();
    for (int i = 0; i < 10; ++i) {
        write("other.cube", shown_as("1 0 0"));
    }
    write("look.cube.new", shown_as("1 0 0"));
    rest();
    EXPECT_EQ(frame(), last);
}

} // namespace
} // namespace desktop
