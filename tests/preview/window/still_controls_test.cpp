// Where files that are dropped become reference stills.
#include "preview/panels/still_controls.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace preview::panels {
namespace {

TEST(DroppedFiles, become_stills_on_the_panel_versions_and_nowhere_else) {
    Ui ui(initial_state());
    const std::vector<std::string> names = panel_names();
    EXPECT_FALSE(takes_dropped_stills(ui, 500, 100)) << "nothing is drawn yet";
    ui.places["panels"] = {400, 0, 200, 300};
    for (std::size_t i = 0; i < names.size(); ++i) {
        ui.panel = i;
        EXPECT_EQ(takes_dropped_stills(ui, 500, 100), names[i] == "Versions") << names[i];
    }
    ui.panel =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), "Versions") - names.begin());
    EXPECT_FALSE(takes_dropped_stills(ui, 399, 100)) << "on the picture";
    EXPECT_TRUE(takes_dropped_stills(ui, 400, 0));
    EXPECT_FALSE(takes_dropped_stills(ui, 500, 300));
}

} // namespace
} // namespace preview::panels
