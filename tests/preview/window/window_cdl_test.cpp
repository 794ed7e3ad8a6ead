// ASC CDL files on the page CDL, by mouse and keys.
#include "tests/preview/window/look_window.h"

namespace desktop {
namespace {

class WindowCdl : public LookWindow {
  protected:
    void choose_file(const std::string& button, const std::string& name) {
        click(button);
        place("file.name");
        key("ctrl+a");
        type(file(name).string());
        click("file.choose");
    }
};

TEST_F(WindowCdl, files_are_opened_chosen_from_and_saved_into) {
    std::ofstream(file("shots.ccc")) << "<ColorCorrectionCollection>\n"
                                        "  <ColorCorrection id=\"sh010\"><SOPNode><Slope>0.5 1 1"
                                        "</Slope></SOPNode></ColorCorrection>\n"
                                        "  <ColorCorrection id=\"sh020\"><SatNode><Saturation>0"
                                        "</Saturation></SatNode></ColorCorrection>\n"
                                        "</ColorCorrectionCollection>\n";
    start_with("", "880x530");
    click("page.CDL");
    const Screen neutral = first_screen();
    choose_file("cdl.open", "shots.ccc");
    const Screen first =
        screen_where([&](const Screen& now) { return now.changed(neutral, between(0.5, 1)) > 0.5; },
                     "the first correction");
    EXPECT_EQ(saved()["operators"].at(0)["slope"], (std::vector<double>{0.5, 1, 1}));
    click("cdl.corrections");
    type("sh020");
    click("cdl.corrections.1");
    screen_where([&](const Screen& now) { return now.changed(first, between(0.5, 1)) > 0.5; },
                 "the second correction");
    const nlohmann::json grey = saved()["operators"].at(0);
    EXPECT_EQ(grey["saturation"], 0);
    EXPECT_FALSE(grey.contains("slope"));
    key("ctrl+z");
    screen_where([&](const Screen& now) { return now.changed(first, between(0.5, 1)) == 0; },
                 "the first again: choosing is a step");
    click("cdl.id");
    key("ctrl+a");
    type("sh030");
    choose_file("cdl.save", "shots.ccc");
    wait_until([&] { return places().count("export.write") > 0; }, "what would be lost");
    click("export.write");
    const std::string text = contents("shots.ccc");
    EXPECT_NE(text.find("id=\"sh010\"><SOPNode><Slope>0.5 1 1</Slope>"), std::string::npos) << text;
    EXPECT_NE(text.find("<ColorCorrection id=\"sh030\">"), std::string::npos) << text;
    const Said said = say({LUTCONV, "edit", "identity", "-o", "x.cube", "--cdl-file", "shots.ccc",
                           "--cdl-id", "sh030"},
                          desktop_->folder());
    EXPECT_EQ(said.code, 0) << said.text;
}

TEST_F(WindowCdl, that_is_no_such_file_is_told_and_changes_nothing) {
    std::ofstream(file("bad.cc")) << "<ColorCorrection><SOPNode><Slope>1 1</Slope>";
    start_with("", "880x530");
    click("page.CDL");
    choose_file("cdl.open", "bad.cc");
    click("error.close");
    EXPECT_TRUE(saved()["operators"].empty());
    choose_file("cdl.save", "new.cc");
    wait_until([&] { return places().count("error.close") > 0; }, "that there is no CDL");
    click("error.close");
    EXPECT_FALSE(std::filesystem::exists(file("new.cc")));
}

} // namespace
} // namespace desktop
