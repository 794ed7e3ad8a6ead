// A scene on a device, and the settings that tests of whole frames begin with.
#pragma once

#include "preview/cli/headless.h"
#include "preview/effects/effect.h"
#include "preview/frame/frame.h"
#include "preview/scene/gpu_scene.h"
#include "tests/preview/graph/gpu_test.h"

namespace preview {

/// A look that no side shows by chance.
inline lutlib::Lut inverting_look() {
    lutlib::Lut look;
    look.cube = lutlib::identity_cube(5);
    for (lutlib::Rgb& node : look.cube->nodes) {
        node = {1 - node.b, node.r, node.g};
    }
    return look;
}

class FrameTest : public GpuTest {
  protected:
    static constexpr Size size{160, 90};

    static FrameSettings settings_for(const Scene& scene) {
        FrameSettings settings;
        settings.output = size;
        settings.orbit = scene.orbit;
        settings.tonemap = tonemap_named("agx");
        settings.bloom = bloom_named("glare");
        settings.bloom_settings = {-1, 1.25F, 0.2F, 1};
        set_usual(settings.effects, true);
        settings.shadow_size = 256;
        return settings;
    }

    struct Loaded {
        explicit Loaded(const Scene& shown) : scene(shown), gpu(device(), scene) {}
        FrameInputs inputs() const {
            FrameInputs out;
            out.scene = &scene;
            out.gpu_scene = &gpu;
            return out;
        }
        Scene scene;
        GpuScene gpu;
    };

    static bool kept(const Rendered& rendered, const std::string& pass) {
        return rendered.explanation.find("kept      " + pass + " ") != std::string::npos;
    }
};

} // namespace preview
