#include "lutlib/formats/threedl.h"

#include "lutlib/codes.h"
#include "lutlib/error.h"
#include "lutlib/formats/all.h"
#include "lutlib/formats/integer_codes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lutlib {
namespace {

constexpr int mesh_bits = 10;

// OpenColorIO takes a mesh for even where no number is two codes or more off it.
constexpr int mesh_tolerance = 1;

/// The step of a mesh line of whole, even steps that OpenColorIO takes for even, at the depth
/// nearest to the usual 10 bits; nullopt where no depth has one.
std::optional<int> even_step(int size) {
    const int cells = size - 1;
    for (const int bits : {mesh_bits, 12, 16, 8}) {
        const int top = static_cast<int>(largest_code(bits));
        for (const int end : {top + mesh_tolerance, top, top - mesh_tolerance}) {
            if (end % cells == 0) {
                return end / cells;
            }
        }
    }
    return std::nullopt;
}

std::string mesh_line(int size) {
    const std::optional<int> step = even_step(size);
    std::string out;
    for (int i = 0; i < size; ++i) {
        const int code = step ? i * *step
                              : static_cast<int>(std::lround(i * largest_code(mesh_bits) /
                                                             static_cast<double>(size - 1)));
        out += (i == 0 ? "" : " ") + std::to_string(code);
    }
    return out + '\n';
}

int code_of(float value) {
    return CodeDepth{threedl_bits}.code(static_cast<double>(value));
}

std::string rows_of(const Lut3D& cube) {
    std::string out;
    for (int r = 0; r < cube.size; ++r) {
        for (int g = 0; g < cube.size; ++g) {
            for (int b = 0; b < cube.size; ++b) {
                const Rgb& node = cube.at(r, g, b);
                out += std::to_string(code_of(node.r)) + ' ' + std::to_string(code_of(node.g)) +
                       ' ' + std::to_string(code_of(node.b)) + '\n';
            }
        }
    }
    return out;
}

const Lut3D& cube_of(const Lut& lut) {
    validate(lut);
    if (!lut.cube || lut.shaper || !lut.cube->domain.is_unit() ||
        lut.cube->size < min_threedl_size || lut.cube->size > max_threedl_size) {
        throw Error("a .3dl holds one cube of " + std::to_string(min_threedl_size) + " to " +
                    std::to_string(max_threedl_size) +
                    " nodes per axis over 0..1 and nothing else");
    }
    return *lut.cube;
}

// Nodes a side of a Lustre mesh are 2^n + 1.
int lustre_depth(int size) {
    return static_cast<int>(std::lround(std::floor(std::log2(size - 1))));
}

std::vector<std::string> readers_of_mesh(const Lut3D& cube) {
    std::vector<std::string> out;
    if (!even_step(cube.size)) {
        out.push_back("three.js refuses it: a mesh line of " + std::to_string(cube.size) +
                      " nodes has no even whole steps; use 17, 33 or 65 nodes");
    }
    int largest = 0;
    for (const Rgb& node : cube.nodes) {
        largest = std::max({largest, code_of(node.r), code_of(node.g), code_of(node.b)});
    }
    constexpr int least_of_12_bits = 2048, least_of_any = 128;
    if (largest < least_of_any) {
        out.push_back("OpenColorIO refuses it, for its largest code, " + std::to_string(largest) +
                      ", is below " + std::to_string(least_of_any));
    } else if (largest < least_of_12_bits) {
        out.push_back("OpenColorIO and three.js take its codes for fewer than 12 bits, and so for "
                      "brighter, for its largest, " +
                      std::to_string(largest) + ", is below " + std::to_string(least_of_12_bits));
    }
    return out;
}

constexpr Holds holds{.cube = true,
                      .min_cube_size = min_threedl_size,
                      .max_cube_size = max_threedl_size,
                      .integer_bits = threedl_bits};

Reading read_threedl_row(const FileFormat& /*format*/, std::string_view bytes,
                         const std::string& file, const ReadOptions& /*options*/) {
    return {read_threedl(bytes, file), {}};
}

} // namespace

std::string write_flame(const Lut& lut, const WriteOptions& /*options*/) {
    const Lut3D& cube = cube_of(lut);
    // ffmpeg skips comments and takes the first line after them for the mesh.
    return "# Output bit depth " + std::to_string(threedl_bits) + '\n' + mesh_line(cube.size) +
           rows_of(cube);
}

std::string write_lustre(const Lut& lut, const WriteOptions& /*options*/) {
    const Lut3D& cube = cube_of(lut);
    return "3DMESH\nMesh " + std::to_string(lustre_depth(cube.size)) + ' ' +
           std::to_string(threedl_bits) + '\n' + mesh_line(cube.size) + rows_of(cube) +
           "\nLUT8\ngamma 1.0\n";
}

std::vector<std::string> flame_readers(const Lut& lut) {
    std::vector<std::string> out = readers_of_mesh(cube_of(lut));
    constexpr int ffmpeg_size = 17;
    if (lut.cube->size != ffmpeg_size) {
        out.emplace_back("ffmpeg reads it wrongly, for it takes every .3dl for one of 17 nodes; "
                         "give it a .cube, or --size 17");
    }
    return out;
}

std::vector<std::string> lustre_readers(const Lut& lut) {
    std::vector<std::string> out = readers_of_mesh(cube_of(lut));
    out.emplace_back(
        "ffmpeg refuses it, for it knows no keywords of Lustre; give it --format flame "
        "of 17 nodes, or a .cube");
    return out;
}

constinit const FileFormat formats::flame{
    .name = "flame",
    .label = "Autodesk Flame .3dl: a cube of integer codes",
    .extensions = {"3dl"},
    .holds = holds,
    .read = read_threedl_row,
    .write = [](const FileFormat& /*format*/, const Lut& lut,
                const WriteOptions& options) { return write_flame(lut, options); },
    .readers = flame_readers,
};

constinit const FileFormat formats::lustre{
    .name = "lustre",
    .label = "Autodesk Lustre .3dl: a cube of integer codes with a mesh header",
    .extensions = {"3dl"},
    .holds = holds,
    .magic = "3DMESH",
    .read = read_threedl_row,
    .write = [](const FileFormat& /*format*/, const Lut& lut,
                const WriteOptions& options) { return write_lustre(lut, options); },
    .readers = lustre_readers,
};

} // namespace lutlib
