// Writes the choice among the rows of a table as GLSL, by the functions that the rows name and the
// numbers by which specialisation constants know them. The build runs it before it compiles the
// shaders: a row whose function is missing does not compile.
#include "lutlib/error.h"
#include "preview/finish/compare.h"
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

/// The place of the colour `unit` among `n` nodes, as the engine has it. Throws lutlib::Error for
/// one that is no straight line between clamped ends.
std::string place_of(const lutlib::Engine* engine) {
    double nodes = -1, offset = 0; // unit * (n + nodes) + offset
    if (engine != nullptr) {
        offset = 2 * engine->place(0.375, 16) - engine->place(0.75, 16);
        nodes = (engine->place(0.75, 16) - offset) / 0.75 - 16;
        for (const int n : {2, 16, 33, 64}) {
            for (int i = 0; i <= 64; ++i) {
                const double line = i / 64.0 * (n + nodes) + offset;
                if (std::abs(engine->place(i / 64.0, n) - std::clamp(line, 0.0, n - 1.0)) > 1e-9) {
                    throw lutlib::Error(fmt::format(
                        "the engine '{}' places colours along no straight line: name a shader "
                        "function in its row",
                        engine->name));
                }
            }
        }
    }
    return fmt::format("unit * (float(n) + {:.6f}) + {:.6f}", nodes, offset);
}

std::string reading_of(const GpuLookup& row) {
    if (row.source == Source::none) {
        return "c";
    }
    if (row.source == Source::table) {
        return fmt::format("{}(volume, shaper, look, c)", row.shader);
    }
    if (!row.shader.empty()) {
        return fmt::format("{}(picture, n, unit)", row.shader);
    }
    return fmt::format("{}_picture(picture, layout_{}, n, {})", lutlib::name_of(row.interpolation),
                       row.layout, place_of(row.engine));
}

std::string lookup_choice() {
    std::string cases;
    for (const GpuLookup& row : gpu_lookups()) {
        cases += fmt::format("    case {}: // {}\n        return {};\n", index_of(row), row.name,
                             reading_of(row));
    }
    return "// Written by the build from preview/look/gpu_lookups.cpp.\n"
           "#include \"common/lookup.glsl\"\n\n"
           "/// `row` is a specialisation constant wherever this is called, so one branch "
           "remains.\n"
           "vec3 apply_lookup(int row, sampler2D picture, sampler3D volume, sampler2D shaper, "
           "Look look,\n                  vec3 c) {\n"
           "    int n = look.size;\n    vec3 unit = saturate(c);\n    switch (row) {\n" +
           cases + "    default:\n        return c;\n    }\n}\n";
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

std::string compare_choice() {
    std::string cases;
    for (const Compare& row : compares) {
        cases += fmt::format("    case {}: // {}\n        {}(target, at, size, texel, how);\n"
                             "        break;\n",
                             index_of(row), row.name, row.shader);
    }
    return fmt::format("// Written by the build from preview/finish/compare.h.\n"
                       "#include \"common/compare.glsl\"\n\n"
                       "const uint difference_bins = {}u;\n"
                       "const float difference_bins_per_unit = {:.1f};\n\n"
                       "/// `row` is a specialisation constant wherever this is called, so one "
                       "branch remains.\n"
                       "void show(int row, writeonly image2D target, ivec2 at, ivec2 size, "
                       "Stages texel, Shown how) {{\n    switch (row) {{\n",
                       DifferenceBins::count, DifferenceBins::per_unit) +
           cases + "    }\n}\n";
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
