// Writes the choice among the rows of a table as GLSL, by the functions that the rows name and the
// numbers by which specialisation constants know them. The build runs it before it compiles the
// shaders: a row whose function is missing does not compile.
#include "lutlib/error.h"
#include "preview/finish/compare.h"
#include "preview/finish/picture_views.h"
#include "preview/finish/tonemaps.h"
#include "preview/look/gpu_lookups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace preview {
namespace {

using Source = GpuLookup::Source;

std::string tonemap_choice() {
    std::string cases;
    for (const Tonemap& row : tonemaps()) {
        if (!row.shader.empty()) {
            cases +=
                fmt::format("    case {}:\n        return {}(light);\n", index_of(row), row.shader);
        }
    }
    return "// Written by the build from preview/finish/tonemaps.cpp.\n"
           "#include \"common/tone_curve.glsl\"\n"
           "#include \"common/tonemap.glsl\"\n\n"
           "/// `row` is a specialisation constant wherever this is called, so one branch "
           "remains.\n"
           "/// `light` within 0..65504.\n"
           "vec3 tonemap(int row, vec3 light) {\n    switch (row) {\n" +
           cases + "    default:\n        return tone_curve(light);\n    }\n}\n";
}

/// The place of the colour `unit` among `n` nodes: unit * (n + nodes) + offset.
struct Place {
    double nodes = -1, offset = 0;
};

/// As the engine has it. Throws lutlib::Error for one that is no straight line between clamped
/// ends.
Place place_of(const lutlib::Engine* engine) {
    Place place;
    if (engine != nullptr) {
        place.offset = 2 * engine->place(0.375, 16) - engine->place(0.75, 16);
        place.nodes = (engine->place(0.75, 16) - place.offset) / 0.75 - 16;
        for (const int n : {2, 16, 33, 64}) {
            for (int i = 0; i <= 64; ++i) {
                const double line = i / 64.0 * (n + place.nodes) + place.offset;
                if (std::abs(engine->place(i / 64.0, n) - std::clamp(line, 0.0, n - 1.0)) > 1e-9) {
                    throw lutlib::Error(fmt::format(
                        "the engine '{}' places colours along no straight line: name a shader "
                        "function in its row",
                        engine->name));
                }
            }
        }
    }
    return place;
}

bool is_described(const GpuLookup& row) {
    return row.source == Source::picture && row.shader.empty();
}

/// Of a row that is not described by its layout, place and interpolation.
std::string reading_of(const GpuLookup& row) {
    if (row.source == Source::none) {
        return "c";
    }
    if (row.source == Source::table) {
        return fmt::format("{}(volume, shaper, look, c)", row.shader);
    }
    return fmt::format("{}(picture, n, unit)", row.shader);
}

/// Rows that are described share one call for each interpolation: drivers take functions in
/// wherever they are called before they learn which row is chosen.
std::string lookup_choice() {
    std::string cases, described;
    for (const GpuLookup& row : gpu_lookups()) {
        const std::string label = fmt::format("    case {}: // {}\n", index_of(row), row.name);
        if (is_described(row)) {
            const Place place = place_of(row.engine);
            described +=
                label + fmt::format("        place = NodePlace(layout_{}, {:.6f}, {:.6f}, {});\n"
                                    "        break;\n",
                                    row.layout, place.nodes, place.offset,
                                    row.interpolation == lutlib::Interpolation::tetrahedral);
        } else {
            cases += label + fmt::format("        return {};\n", reading_of(row));
        }
    }
    return "// Written by the build from preview/look/gpu_lookups.cpp.\n"
           "#include \"common/lookup.glsl\"\n\n"
           "struct NodePlace {\n    int arrangement;\n    float nodes, offset;\n"
           "    bool is_tetrahedral;\n};\n\n"
           "/// `row` is a specialisation constant wherever this is called, so one branch "
           "remains.\n"
           "vec3 apply_lookup(int row, sampler2D picture, sampler3D volume, sampler2D shaper, "
           "Look look,\n                  vec3 c) {\n"
           "    int n = look.size;\n    vec3 unit = saturate(c);\n    switch (row) {\n" +
           cases +
           "    }\n    NodePlace place = NodePlace(layout_strip, -1.0, 0.0, false);\n"
           "    switch (row) {\n" +
           described +
           "    }\n    vec3 at = unit * (float(n) + place.nodes) + place.offset;\n"
           "    if (place.is_tetrahedral) {\n"
           "        return tetrahedral_picture(picture, place.arrangement, n, at);\n    }\n"
           "    return trilinear_picture(picture, place.arrangement, n, at);\n}\n";
}

std::string shared_lookup_choice() {
    std::string any, cases;
    for (const GpuLookup& row : gpu_lookups()) {
        if (row.shared()) {
            any += fmt::format("{}row == {}", any.empty() ? "" : " || ", index_of(row));
            cases += fmt::format("    case {}: // {}\n        return {}(c);\n", index_of(row),
                                 row.name, row.shared_shader);
        }
    }
    return "// Written by the build from preview/look/gpu_lookups.cpp.\n"
           "#include \"common/lattice16.glsl\"\n\n"
           "bool is_shared(int row) {\n    return " +
           any +
           ";\n}\n\n/// Of a shared row; `c` within 0..1.\n"
           "vec3 shared_lookup(int row, vec3 c) {\n    switch (row) {\n" +
           cases + "    default:\n        return c;\n    }\n}\n";
}

std::string side_choice(char side, bool Compare::*shows) {
    std::string any = "false";
    for (const Compare& row : compares) {
        if (row.*shows) {
            any += fmt::format(" || row == {}{}", index_of(row),
                               !row.shows_one ? ""
                               : side == 'a'  ? " && is_before"
                                              : " && !is_before");
        }
    }
    return fmt::format("\n/// Whether a texel on that side of the border needs side {}.\n"
                       "bool needs_{}(int row, bool is_before) {{\n    return {};\n}}\n",
                       side, side, any);
}

std::string compare_choice() {
    std::string cases;
    for (const Compare& row : compares) {
        cases += fmt::format("    case {}: // {}\n        {}(target, at, size, sides, how);\n"
                             "        break;\n",
                             index_of(row), row.name, row.shader);
    }
    return fmt::format("// Written by the build from preview/finish/compare.h.\n"
                       "#include \"common/compare.glsl\"\n\n"
                       "const uint difference_bins = {}u;\n"
                       "const float difference_bins_per_unit = {:.1f};\n"
                       "const int compare_box = {};\n\n"
                       "/// `row` is a specialisation constant wherever this is called, so one "
                       "branch remains.\n"
                       "void show(int row, writeonly image2D target, ivec2 at, ivec2 size, "
                       "Sides sides, Shown how) {{\n    switch (row) {{\n",
                       DifferenceBins::count, DifferenceBins::per_unit, index_of(compare_box)) +
           cases + "    }\n}\n" + side_choice('a', &Compare::shows_a) +
           side_choice('b', &Compare::shows_b);
}

std::string color_text(const std::array<float, 3>& color) {
    return fmt::format("vec3({:.6f}, {:.6f}, {:.6f})", color[0], color[1], color[2]);
}

/// A constant array of GLSL.
std::string array_text(const std::string& type, const std::string& name,
                       const std::vector<std::string>& items) {
    return fmt::format("const {0} {1}[{2}] = {0}[{2}]({3});\n", type, name, items.size(),
                       fmt::join(items, ", "));
}

std::string level_bands_text() {
    constexpr double beyond_all = 2; // luma ends at 1
    std::vector<std::string> ends, marked, colors;
    for (const LevelBand& band : level_bands) {
        ends.push_back(fmt::format("{:.6f}", std::min(band.to, beyond_all)));
        marked.push_back(band.text.empty() ? "false" : "true");
        colors.push_back(color_text(band.color));
    }
    return fmt::format("const int level_count = {};\n", level_bands.size()) +
           array_text("float", "level_ends", ends) + array_text("bool", "level_is_marked", marked) +
           array_text("vec3", "level_colors", colors);
}

std::string picture_view_choice() {
    std::string legends, cases;
    for (const PictureView& row : picture_views()) {
        if (row.is_picture()) {
            continue;
        }
        std::string name(row.name);
        std::replace(name.begin(), name.end(), '-', '_');
        std::vector<std::string> colors;
        for (const LegendEntry& entry : row.legend) {
            colors.push_back(color_text(entry.color));
        }
        legends += array_text("vec3", name + "_colors", colors);
        cases += fmt::format("    case {}: // {}\n        return {}(v);\n", index_of(row), row.name,
                             row.shader);
    }
    return "// Written by the build from preview/finish/picture_views.cpp.\n" + legends +
           level_bands_text() +
           "#include \"common/picture_views.glsl\"\n\n"
           "/// `row` is a specialisation constant wherever this is called, so one branch "
           "remains.\n"
           "vec3 picture_view(int row, Viewed v) {\n    switch (row) {\n" +
           cases + "    default:\n        return v.color;\n    }\n}\n";
}

/// Leaves a file alone that says the same already, so that no shader is compiled for nothing.
void write(const std::filesystem::path& path, const std::string& text) {
    std::ostringstream known;
    known << std::ifstream(path, std::ios::binary).rdbuf();
    if (known.str() == text) {
        return;
    }
    std::ofstream file(path, std::ios::binary);
    file << text;
    if (!file.flush()) {
        throw lutlib::Error("cannot write it", {path.string(), 0, {}});
    }
}

void write_tables(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    write(folder / "tonemaps.glsl", tonemap_choice());
    write(folder / "compares.glsl", compare_choice());
    write(folder / "lookups.glsl", lookup_choice());
    write(folder / "shared_lookups.glsl", shared_lookup_choice());
    write(folder / "picture_views.glsl", picture_view_choice());
}

} // namespace
} // namespace preview

int main(int argc, char** argv) {
    try {
        if (argc != 2) {
            throw lutlib::UsageError("usage: shader_tables FOLDER");
        }
        preview::write_tables(argv[1]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "shader_tables: %s\n", error.what());
        return 1;
    }
}
