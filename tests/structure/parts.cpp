#include "tests/structure/include_rules.h"

namespace structure {

namespace {

using Names = std::vector<std::string_view>;

Names joined(Names a, const Names& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

const Names plain_gpu{"preview/gpu/size.*", "preview/gpu/types.*"};
/// Descriptors without any setting: plain, too.
constexpr std::string_view setting_rows = "preview/finish/setting_*";
const Names no_screen{"vulkan/", "GLFW/", "imgui"};
const Names no_vulkan{"vulkan/", "GLFW/"};
const Names no_big_library{"OpenColorIO/", "OpenImageIO/", "vulkan/", "GLFW/", "glm/", "imgui"};

/// What a frame is made with.
const Names render =
    joined({"lutlib/*", "preview/finish", "preview/graph", "preview/look",
            "preview/look/gpu_look.*", "preview/scene", "preview/scene/light_data.*",
            "preview/scene/nearest.*", "preview/scene/scene_data.*", "preview/scene/gpu_scene.*"},
           plain_gpu);

} // namespace

const std::vector<Part>& parts() {
    static const std::vector<Part> table{
        // lutlib
        {"lutlib", {}, no_big_library},
        // What makes a transform of a table samples it.
        {"lutlib/transform.cpp*", {"lutlib", "lutlib/interpolation"}, no_big_library},
        {"lutlib/color", {"lutlib"}, no_big_library, "lutlib/color/rows"},
        {"lutlib/interpolation", {"lutlib"}, no_big_library},
        {"lutlib/formats", {"lutlib"}, no_big_library},
        {"lutlib/metrics", {"lutlib", "lutlib/color", "lutlib/interpolation"}, no_big_library},
        {"lutlib/ops", {"lutlib", "lutlib/color"}, no_big_library},
        {"lutlib/resample",
         {"lutlib", "lutlib/color", "lutlib/interpolation", "lutlib/metrics"},
         no_big_library},
        {"lutlib/recipe",
         {"lutlib", "lutlib/color", "lutlib/interpolation", "lutlib/ops", "lutlib/resample"},
         no_big_library},
        {"lutlib/engine", {"lutlib", "lutlib/color", "lutlib/interpolation"}, no_big_library},
        {"lutlib/fit",
         {"lutlib", "lutlib/color", "lutlib/interpolation", "lutlib/metrics", "lutlib/engine"},
         no_big_library},
        {"lutlib/bake",
         {"lutlib", "lutlib/color", "lutlib/engine", "lutlib/fit", "lutlib/interpolation",
          "lutlib/metrics"},
         no_big_library},
        {"lutlib/verify",
         {"lutlib", "lutlib/bake", "lutlib/color", "lutlib/engine", "lutlib/interpolation",
          "lutlib/metrics"},
         no_big_library},
        // Tells a fitted picture from a wrong one: needs both.
        {"lutlib/bake/fitted.*",
         {"lutlib", "lutlib/bake", "lutlib/color", "lutlib/engine", "lutlib/fit",
          "lutlib/interpolation", "lutlib/metrics", "lutlib/verify"},
         no_big_library},
        {"lutlib/health",
         {"lutlib", "lutlib/color", "lutlib/interpolation", "lutlib/metrics", "lutlib/resample"},
         no_big_library},
        {"lutlib/survey",
         {"lutlib", "lutlib/bake", "lutlib/color", "lutlib/engine", "lutlib/fit",
          "lutlib/interpolation", "lutlib/metrics", "lutlib/recipe", "lutlib/resample"},
         no_big_library},
        // Strips on their way through paint programs.
        {"lutlib/paint",
         {"lutlib", "lutlib/color", "lutlib/engine", "lutlib/interpolation", "lutlib/metrics"},
         no_big_library},
        // Looks out of pictures before and after a grade.
        {"lutlib/match",
         {"lutlib", "lutlib/color", "lutlib/engine", "lutlib/interpolation"},
         no_big_library},
        {"lutlib/io",
         {"lutlib", "lutlib/bake", "lutlib/bake/fitted.*", "lutlib/color", "lutlib/engine",
          "lutlib/formats", "lutlib/interpolation", "lutlib/metrics", "lutlib/ops", "lutlib/recipe",
          "lutlib/resample", "lutlib/verify"},
         no_big_library,
         "lutlib/io/formats"},
        {"lutlib/io/ocio",
         {"lutlib", "lutlib/interpolation", "lutlib/io", "lutlib/metrics", "lutlib/resample"}},
        {"lutlib/io/box", {"lutlib", "lutlib/io"}, no_big_library},
        {"lutlib/io/oiio", {"lutlib", "lutlib/io", "lutlib/io/box"}},
        {"lutlib/plot", {"lutlib"}, no_big_library},

        // What the command lines of both programs share.
        {"terminal", {"lutlib", "lutlib/io", "lutlib/io/box"}, no_big_library},

        // lutconv
        {"converter/panels", {"lutlib/*"}, no_big_library},
        {"converter", {"converter/panels", "lutlib/*", "terminal"}, no_big_library},
        {"converter/commands",
         {"converter", "converter/panels", "lutlib/*", "terminal"},
         no_big_library},

        // Figures are lutconv's.
        {"python", {"converter", "lutlib/*"}, no_big_library},

        // lutpreview
        {"preview/gpu/size.*", {}, no_screen},
        {"preview/gpu/types.*", {}, no_screen},
        {"preview/gpu", joined({"lutlib"}, plain_gpu)},
        {"preview/graph", joined({"lutlib"}, plain_gpu), no_screen},
        {"preview/graph/execute.*",
         joined({"lutlib", "preview/gpu", "preview/graph", "preview/graph/realise.*"}, plain_gpu)},
        {"preview/graph/realise.*", joined({"lutlib", "preview/gpu", "preview/graph"}, plain_gpu)},
        {"preview/finish/setting_*", {}, no_screen},
        {"preview/finish", joined({"lutlib/*", setting_rows}, plain_gpu), no_screen},
        {"preview/effects", joined({"lutlib/*", "preview/finish", "preview/graph"}, plain_gpu),
         no_screen},
        {"preview/scene", {"lutlib/*", setting_rows}, no_screen},
        {"preview/scene/scene_data.*",
         joined({"lutlib", "preview/graph", "preview/scene"}, plain_gpu), no_screen},
        {"preview/scene/nearest.*",
         joined({"lutlib", "preview/graph", "preview/scene", "preview/scene/scene_data.*"},
                plain_gpu),
         no_screen},
        {"preview/scene/light_data.*",
         joined({"lutlib", "preview/graph", "preview/scene", "preview/scene/scene_data.*"},
                plain_gpu),
         no_screen},
        {"preview/scene/gpu_scene.*",
         joined({"preview/gpu", "preview/graph", "preview/scene", "preview/scene/scene_data.*"},
                plain_gpu)},
        {"preview/look", joined({"lutlib/*", setting_rows}, plain_gpu), no_screen},
        {"preview/look/gpu_look.*", joined({"lutlib", "preview/gpu", "preview/look"}, plain_gpu)},
        {"preview/look/look_slot.*",
         joined({"lutlib", "preview/gpu", "preview/look", "preview/look/gpu_look.*"}, plain_gpu)},
        // Writes the tables that shaders include; runs while they are compiled.
        {"preview/shader_tables", {"lutlib/*", "preview/finish", "preview/look"}, no_screen},
        {"preview/passes", render},
        {"preview/frame", joined({"preview/effects", "preview/gpu", "preview/passes"}, render)},
        {"preview/frame/measured.*", joined({"preview/frame", "preview/graph/execute.*"}, render)},
        {"preview/check", joined({"preview/effects", "preview/frame", "preview/gpu",
                                  "preview/graph/execute.*", "preview/passes", "preview/reference"},
                                 render)},
        {"preview/report",
         joined({"preview/check", "preview/effects", "preview/frame", "preview/frame/measured.*",
                 "preview/gpu", "preview/graph/execute.*", "preview/passes", "preview/reference"},
                render)},
        {"preview/editor",
         {"lutlib/*", "preview/finish", "preview/look", "preview/scene"},
         no_screen},
        {"preview/panels",
         joined({"lutlib/*", "preview/editor", "preview/effects", "preview/finish", "preview/graph",
                 "preview/look", "preview/scene"},
                plain_gpu),
         no_vulkan},
        {"preview/window",
         joined({"preview/editor", "preview/effects", "preview/frame", "preview/frame/measured.*",
                 "preview/gpu", "preview/graph/execute.*", "preview/look/look_slot.*",
                 "preview/panels", "preview/passes"},
                render)},
        {"preview/cli",
         joined({"preview/check", "preview/cli/option*", "preview/cli/sequence.*", "preview/report",
                 "preview/effects", "preview/editor", "preview/frame", "preview/frame/measured.*",
                 "preview/gpu", "preview/graph/execute.*", "preview/passes", "preview/window",
                 "terminal"},
                render)},
        {"preview/cli/option*",
         {"lutlib/*", setting_rows, "preview/cli/light_edit.*", "preview/cli/sequence.*",
          "preview/effects", "preview/finish", "preview/frame", "preview/look", "preview/passes",
          "preview/scene", "terminal"},
         no_screen},
        {"preview/cli/light_edit.*", {"lutlib", "preview/scene"}, no_screen},
        {"preview/cli/sequence.*", {"lutlib", "lutlib/io"}, no_screen},
        {"preview", {"lutlib", "lutlib/io", "preview/cli", "preview/cli/option*", "terminal"}},
        // Oracles, which nothing but tests and studies includes.
        {"preview/reference",
         {"lutlib/*", "preview/finish", "preview/look", "preview/scene",
          "preview/scene/scene_data.*"},
         no_screen},

        // As programs of other people, by <lutlib/...> alone.
        {"examples", {}, no_big_library},

        {"tests", {"*"}},
    };
    return table;
}

} // namespace structure
