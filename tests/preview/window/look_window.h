// A window whose panel Look edits a recipe.
#pragma once

#include "tests/preview/window/window_fixture.h"

#include <nlohmann/json.hpp>

namespace desktop {

class LookWindow : public Window {
  protected:
    /// Opens a picture between no look and a recipe of these operators, in the panel Look.
    void start_with(const std::string& operators, const std::string& size = "800x480") {
        std::ofstream(file("look.json"))
            << R"({"schema_version": 1, "input": "srgb", "operators": [)" << operators << "]}";
        start_unsized({"--size", size, "picture.ppm", "--b", "look.json"});
        click("tab.Look");
    }
    nlohmann::json saved() {
        key("ctrl+s");
        return nlohmann::json::parse(contents("look.json"));
    }
};

} // namespace desktop
