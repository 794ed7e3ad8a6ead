// A picture before and after a grade, for tests of lutconv match.
#pragma once

#include "lutlib/io/png.h"
#include "tests/converter/run_program.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace converter_test {

using nlohmann::json;
namespace io = lutlib::io;

class MatchVerb : public testing::Test {
  protected:
    MatchVerb() {
        write("before.png", shot(0));
        folder_.write("grade.cube", saturated_cube(17));
        grade("before.png", "after.png");
    }

    std::string in(const std::string& name) const { return folder_.path(name); }
    void write(const std::string& name, const io::PngImage& image) const {
        folder_.write(name, io::write_png(image));
    }
    io::PngImage read(const std::string& name) const {
        return io::read_png(contents(in(name)), name);
    }
    void grade(const std::string& from, const std::string& to) const {
        const Result result =
            lutconv_in_process({"apply", in("grade.cube"), in(from), "-o", in(to)});
        ASSERT_EQ(result.exit_code, 0) << result.err;
    }
    // Waves of muted colours with edges between them, from its own start.
    static io::PngImage shot(int start, int width = 256, int height = 160) {
        io::PngImage out;
        out.width = width;
        out.height = height;
        out.srgb_tag = true;
        for (int y = 0; y < out.height; ++y) {
            for (int x = 0; x < out.width; ++x) {
                const double across = (x + start) / 19.0, down = (y + 2 * start) / 13.0;
                const double grey = 0.5 + 0.3 * std::sin(across) * std::cos(down / 2) +
                                    ((x + start) / 37 + y / 29) % 3 * 0.08;
                for (const double more : {0.1 * std::sin(down), 0.0, 0.12 * std::cos(across / 3)}) {
                    out.samples.push_back(out.depth.code(grey - 0.05 + more));
                }
            }
        }
        return out;
    }
    std::vector<std::string> words(const std::string& output = "look.cube") const {
        return {"match",
                in("before.png"),
                in("after.png"),
                "-o",
                in(output),
                "--size",
                support::is_sanitized ? "9" : "17"};
    }
    json matched(std::vector<std::string> words) const {
        words.emplace_back("--json");
        const Result result = lutconv_in_process(words);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return json::parse(result.out, nullptr, false);
    }
    json matched() const { return matched(words()); }
    void refused(const std::vector<std::string>& words, const std::string& says,
                 int exit_code = 2) const {
        const Result result = lutconv_in_process(words);
        EXPECT_EQ(result.exit_code, exit_code) << result.out;
        EXPECT_NE(result.err.find(says), std::string::npos) << result.err;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    }

    Folder folder_;
};

} // namespace converter_test
