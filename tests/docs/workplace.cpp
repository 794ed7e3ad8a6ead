#include "tests/docs/workplace.h"

#include "lutlib/io/png.h"
#include "lutlib/match/chart.h"
#include "tests/preview/scene/gltf_writer.h"

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace docs_test {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

std::string quoted(const std::string& text) {
    return "'" + text + "'";
}

void append_word(std::string& out, std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8) {
        out += static_cast<char>(value >> shift & 0xFFU);
    }
}

/// A square as a binary glTF: a header, then a chunk of JSON and one of the buffer's bytes.
std::string square_glb() {
    preview::GltfWriter square;
    square.add_node({{"mesh", square.add_mesh(preview::square_corners())}});
    square.root["buffers"] =
        preview::GltfWriter::json::array({{{"byteLength", square.bytes.size()}}});
    const auto chunk = [](std::string bytes, char padding, std::string_view type) {
        bytes.append((4 - bytes.size() % 4) % 4, padding);
        std::string out;
        append_word(out, bytes.size());
        return out.append(type) + bytes;
    };
    using namespace std::string_view_literals;
    const std::string chunks =
        chunk(square.root.dump(), ' ', "JSON") + chunk(square.bytes, '\0', "BIN\0"sv);
    std::string out = "glTF";
    append_word(out, 2);
    append_word(out, 12 + chunks.size());
    return out + chunks;
}

/// One picture below the other, as often as `count`.
std::string stacked(const std::string& png, int count) {
    lutlib::io::PngImage image = lutlib::io::read_png(png, "strip.png");
    const std::vector<std::uint16_t> one = image.samples;
    image.text = {{"Software", "lutconv"}}; // as bake --stack makes it
    for (int i = 1; i < count; ++i) {
        image.samples.insert(image.samples.end(), one.begin(), one.end());
    }
    image.height *= count;
    return lutlib::io::write_png(image);
}

/// A ColorChecker of 240x160 pixels from (40, 30) on, before grey.
std::string chart_photo() {
    constexpr int patch = 40, left = 40, top = 30;
    lutlib::io::PngImage image;
    image.width = 320;
    image.height = 220;
    image.samples.assign(std::size_t{3} * 320 * 220, 90);
    const auto patches = lutlib::published_chart();
    for (int y = 0; y < 4 * patch; ++y) {
        for (int x = 0; x < 6 * patch; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                image.at({left + x, top + y}, c) = image.depth.code(
                    patches[static_cast<std::size_t>(y / patch * 6 + x / patch)][c]);
            }
        }
    }
    return lutlib::io::write_png(image);
}

void make(const fs::path& folder, const std::string& line) {
    const Ran ran = run_in(folder, line);
    ASSERT_EQ(ran.exit_code, 0) << line << '\n' << ran.output;
}

} // namespace

Ran run_in(const fs::path& folder, const std::string& line) {
    const fs::path out = folder / ".out";
    const std::string shell = "cd " + quoted(folder.string()) + " && PATH=" + quoted(PROGRAMS) +
                              ":$PATH && { " + line + "\n} </dev/null >" + quoted(out.string()) +
                              " 2>&1";
    const int status = std::system(shell.c_str());
    Ran ran{WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(out)};
    fs::remove(out);
    return ran;
}

void fill_workplace(const fs::path& folder) {
    fs::copy(SAMPLE_LOOKS, folder / "luts");
    // Operators that are affine in code values: a lattice of any size holds them exactly, so a
    // strip is right for the recipe and for its LUT. Within 0..1 it stays healthy.
    make(folder, "lutconv edit identity -o look.cube --saturation 0.8 --contrast 0.9 "
                 "--save-recipe look.json");
    for (const char* name : {"My Look", "their", "camera", "first", "second", "a"}) {
        fs::copy(folder / "look.cube", folder / (std::string(name) + ".cube"));
    }
    make(folder, "lutconv edit identity -o b.cube --saturation 0.6");
    make(folder, "lutconv bake look.cube -o strip.png");
    make(folder, "lutconv convert look.cube -o look.3dl --size 17");
    make(folder, "lutconv bake look.cube --engine reshade -o one.png");
    make(folder, "lutconv identity -o identity.cube");
    make(folder, "lutconv apply identity.cube strip.png -o strip.tif");
    make(folder, "lutconv edit identity --saturation 0 -o grey.cube");
    make(folder, "lutconv bake grey.cube --engine unity -o grey.png");
    write(folder / "multi.png", stacked(contents(folder / "one.png"), 4));
    make(folder, "lutconv edit identity --saturation 0.8 --domain 0 4 -o wide.cube");
    make(folder, "lutconv apply look.cube luts/warm_teal.png -o picture.exr");
    fs::copy(folder / "picture.exr", folder / "Desk.exr");
    for (const char* const name : {"shot.1001.exr", "shot.1002.exr", "shot.1003.exr"}) {
        fs::copy(folder / "picture.exr", folder / name);
    }
    make(folder, "lutconv apply identity.cube luts/before_after.png -o shot.png");
    make(folder, "lutconv identity --into shot.png -o for_grading.png");
    make(folder, "lutconv apply look.cube for_grading.png -o graded.png");
    make(folder, "lutconv apply identity.cube luts/before_after.png -o before.png");
    make(folder, "lutconv apply look.cube before.png -o after.png");
    fs::copy(folder / "before.png", folder / "room.png");
    make(folder, "lutconv edit identity --cdl-slope 1.1,1,0.9 --save-cdl shots.ccc "
                 "--save-cdl-id sh010");
    write(folder / "photo.png", chart_photo());
    make(folder, "lutconv apply look.cube photo.png -o other_photo.png");
    for (const char* const frame : {"1001", "1002"}) {
        fs::copy(folder / "before.png", folder / (std::string("plate.") + frame + ".png"));
        fs::copy(folder / "after.png", folder / (std::string("graded.") + frame + ".png"));
    }
    fs::create_directory(folder / "looks");
    for (const char* const name : {"a.cube", "b.cube"}) {
        fs::copy(folder / name, folder / "looks" / name);
    }
    write(folder / "model.glb", square_glb());
    // A row whose decimal point was lost, as a spike stands out.
    std::string broken = contents(folder / "look.cube");
    const std::size_t row = broken.find("\n0.5");
    ASSERT_NE(row, std::string::npos);
    broken.erase(row + 2, 1);
    write(folder / "broken.cube", broken);
}

} // namespace docs_test
