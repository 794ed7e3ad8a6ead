// What effects say of parameters that change nothing, against the pictures that they make.
#include "tests/preview/effects/effect_fixture.h"

#include <fmt/format.h>

namespace preview {
namespace {

/// Colours and distances that differ from place to place; nothing at all in one corner.
reference::Image picture_with(std::vector<float>& depth) {
    reference::Image out(90, 60);
    depth.clear();
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            const double texture = 0.3 * ((x * 7 + y * 13) % 11) / 11.0;
            const bool inside = (x - 40) * (x - 40) + (y - 30) * (y - 30) < 300;
            out.at(x, y) = inside ? lutlib::RgbD{0.9, 0.7 - texture, 0.2}
                                  : lutlib::RgbD{0.1, 0.15 + texture, 0.3};
            const float z = 0.3F + 0.05F * static_cast<float>(x + 2 * y);
            depth.push_back(x > 70 && y < 20 ? 1.0F : 1 - 0.1F / z);
        }
    }
    return out;
}

/// Values beside which parameters are tried.
const std::string situations[] = {"glitch:tear=0,static=0", "glitch:tear=0",
                                  "glitch:static=0",        "paintbrush:coherence=0",
                                  "depth-of-field:focus=1", "depth-of-field:focus=0"};

TEST_F(EffectTest, a_parameter_changes_the_picture_unless_its_effect_says_why_not) {
    std::vector<std::string> texts(std::begin(situations), std::end(situations));
    for (const PostEffect* const effect : post_effects()) {
        texts.emplace_back(effect->name);
    }
    Given given;
    const reference::Image picture = picture_with(given.depth);
    int idle = 0;
    for (const std::string& text : texts) {
        const EffectUse use = parse_use(text);
        for (std::size_t i = 1; i < use.values.size(); ++i) {
            const lutlib::Parameter& parameter = use.effect->parameters[i];
            // What the situation itself sets.
            if (text.find(fmt::format("{}=", parameter.name)) != std::string::npos) {
                continue;
            }
            for (const double seconds : {0.0, 1.37}) {
                given.seconds = seconds;
                const auto with = [&](double value) {
                    EffectUse other = use;
                    set_number(other, parameter.name, value);
                    return run(use_text(other), picture, given);
                };
                const std::string_view why =
                    use.effect->idle_parameter == nullptr
                        ? std::string_view()
                        : use.effect->idle_parameter(use.values, i, seconds);
                EXPECT_EQ(with(parameter.min) == with(parameter.max), !why.empty())
                    << text << ':' << parameter.name << " at " << seconds << ": " << why;
                idle += why.empty() ? 0 : 1;
            }
        }
    }
    EXPECT_GT(idle, 10);
}

} // namespace
} // namespace preview
