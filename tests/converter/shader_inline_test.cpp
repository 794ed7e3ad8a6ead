// The code that `shader --inline` writes: its constants read back, its arithmetic done here in
// floats, against the look.
#include "lutlib/color/difference.h"
#include "lutlib/engine/shader_code.h"
#include "lutlib/io/look.h"
#include "lutlib/metrics/samples.h"
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <regex>

namespace converter_test {
namespace {

using lutlib::Rgb;
using lutlib::RgbD;

const std::string curve_look = "# Input encoding: srgb\n# Output encoding: srgb\n"
                               "LUT_1D_SIZE 3\n0 0.1 0\n0.6 0.5 0.4\n1 0.9 0.8\n";

const std::string mixer_recipe = R"({"schema_version": 1, "operators": [
    {"op": "saturation", "amount": 0.7},
    {"op": "curves", "master": [[0, 0], [0.2, 0.05], [0.5, 0.6], [1, 1]]}]})";

// The numbers between the brackets or braces that follow a name.
std::vector<double> constants(const std::string& code, const std::string& name) {
    const std::size_t at = code.find(" " + name);
    EXPECT_NE(at, std::string::npos) << name;
    if (at == std::string::npos) {
        return {};
    }
    const std::size_t from = code.find_first_of("({", code.find('=', at)) + 1;
    const std::string list = code.substr(from, code.find_first_of(")}", from) - from);
    std::vector<double> out;
    const std::regex number("[-+]?[0-9][0-9.]*(e[-+]?[0-9]+)?");
    for (std::sregex_iterator it(list.begin(), list.end(), number), end; it != end; ++it) {
        out.push_back(std::stod(it->str()));
    }
    return out;
}

Rgb vector_constant(const std::string& code, const std::string& name) {
    const std::vector<double> v = constants(code, name);
    return v.size() == 3 ? lutlib::to_float({v[0], v[1], v[2]}) : Rgb{};
}

struct HeldInput {
    explicit HeldInput(const std::string& code)
        : low(vector_constant(code, "LUT_MIN")), high(vector_constant(code, "LUT_MAX")) {}

    Rgb operator()(Rgb color) const {
        for (std::size_t c = 0; c < 3; ++c) {
            color[c] = color[c] > low[c] ? std::min(color[c], high[c]) : low[c];
        }
        return color;
    }
    Rgb low, high;
};

// The statements of the lattice's code, in floats.
class LatticeCode {
  public:
    explicit LatticeCode(const std::string& code)
        : held_(code), scale_(vector_constant(code, "LUT_SCALE")),
          base_(vector_constant(code, "LUT_LOW")), step_(vector_constant(code, "LUT_STEP")) {
        const std::size_t at = code.find("LUT_SIZE = ");
        size_ = std::stoi(code.substr(at + 11));
        for (const double word : constants(code, "LUT_NODES")) {
            words_.push_back(static_cast<unsigned>(word));
        }
        EXPECT_EQ(words_.size(), static_cast<std::size_t>(size_ * size_ * size_));
    }

    Rgb operator()(Rgb color) const {
        const Rgb c = held_(color);
        std::array<float, 3> f{};
        std::array<int, 3> n{};
        for (std::size_t k = 0; k < 3; ++k) {
            const float place = (c[k] - held_.low[k]) * scale_[k];
            const float low = std::min(std::floor(place), static_cast<float>(size_ - 2));
            f[k] = place - low;
            n[k] = static_cast<int>(low);
        }
        // From the lower node along the channels in order of falling fraction.
        std::array<std::size_t, 3> order{0, 1, 2};
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return f[a] > f[b]; });
        Rgb out = node(n) * (1 - f[order[0]]);
        for (std::size_t k = 0; k < 3; ++k) {
            ++n[order[k]];
            out = out + node(n) * (f[order[k]] - (k < 2 ? f[order[k + 1]] : 0.0F));
        }
        return out;
    }

  private:
    Rgb node(const std::array<int, 3>& n) const {
        const unsigned word =
            words_[static_cast<std::size_t>(n[0] + size_ * (n[1] + size_ * n[2]))];
        Rgb out;
        for (std::size_t k = 0; k < 3; ++k) {
            out[k] = base_[k] + step_[k] * static_cast<float>(word >> (10 * k) & 1023U);
        }
        return out;
    }

    HeldInput held_;
    Rgb scale_, base_, step_;
    int size_ = 0;
    std::vector<unsigned> words_;
};

// One function of the curves' code: its table, and the two numbers that place a value in it.
struct CurveCode {
    CurveCode(const std::string& code, const std::string& name) {
        std::string table = "LUT_" + name;
        std::transform(table.begin(), table.end(), table.begin(),
                       [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
        for (const double entry : constants(code, table + "[")) {
            entries.push_back(static_cast<float>(entry));
        }
        const std::regex placed("lut_" + name +
                                R"(\(float x\)\s*\{\s*float at = (sqrt\()?clamp)"
                                R"(\(\(x - \(([^)]*)\)\) \* ([^,]*), 0.0, 1.0\))");
        std::smatch found;
        EXPECT_TRUE(std::regex_search(code, found, placed)) << name;
        by_root = found[1].matched;
        low = std::stof(found[2]);
        scale = std::stof(found[3]);
    }
    float operator()(float x) const {
        const auto last = static_cast<float>(entries.size() - 1);
        const float share = std::clamp((x - low) * scale, 0.0F, 1.0F);
        const float at = (by_root ? std::sqrt(share) : share) * last;
        const float i = std::min(std::floor(at), last - 1);
        const auto k = static_cast<std::size_t>(i);
        return entries[k] + (entries[k + 1] - entries[k]) * (at - i);
    }
    std::vector<float> entries;
    float low = 0, scale = 1;
    bool by_root = false;
};

// The code of curves, a matrix and curves.
class MixingCode {
  public:
    explicit MixingCode(const std::string& code)
        : held_(code), before_{CurveCode(code, "before_r"), CurveCode(code, "before_g"),
                               CurveCode(code, "before_b")},
          after_{CurveCode(code, "after_r"), CurveCode(code, "after_g"),
                 CurveCode(code, "after_b")} {
        const std::regex row(R"(dot\(\w+\(([^,]*), ([^,]*), ([^)]*)\), t\))");
        for (std::sregex_iterator it(code.begin(), code.end(), row), end; it != end; ++it) {
            rows_.push_back({std::stof((*it)[1]), std::stof((*it)[2]), std::stof((*it)[3])});
        }
        EXPECT_EQ(rows_.size(), 3U);
    }

    Rgb operator()(Rgb color) const {
        const Rgb c = held_(color);
        const Rgb t{before_[0](c.r), before_[1](c.g), before_[2](c.b)};
        Rgb out;
        for (std::size_t k = 0; k < 3 && k < rows_.size(); ++k) {
            out[k] = after_[k](rows_[k].r * t.r + rows_[k].g * t.g + rows_[k].b * t.b);
        }
        return out;
    }

  private:
    HeldInput held_;
    std::array<CurveCode, 3> before_, after_;
    std::vector<Rgb> rows_;
};

class InlineShader : public testing::Test {
  protected:
    const Folder folder;

    std::string code(const std::string& look, const std::string& bound,
                     const std::string& language = "glsl") const {
        const std::string file = folder.path("look." + language);
        const Result result = lutconv_in_process({"shader", "--inline", look, "--language",
                                                  language, "--max-delta-e", bound, "-o", file});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_NE(result.out.find("dE2000 from the look"), std::string::npos) << result.out;
        return contents(file);
    }
};

template <class Code>
double worst_delta_e(const std::string& look, const Code& by_code) {
    const lutlib::Transform exact = lutlib::io::Look::open(look).exact();
    double worst = 0;
    for (const Rgb& color :
         lutlib::sample_colors(2, {.neutral = 65, .random = 3000, .lattice = false})) {
        worst = std::max(worst,
                         lutlib::delta_e_2000(exact(to_double(color)), to_double(by_code(color))));
    }
    return worst;
}

TEST_F(InlineShader, of_nodes_computes_the_look_within_the_bound) {
    const std::string look = folder.write("look.cube", saturated_cube(7));
    for (const char* bound : {"1", "0.2"}) {
        const std::string text = code(look, bound);
        ASSERT_NE(text.find("LUT_NODES"), std::string::npos) << text.substr(0, 900);
        EXPECT_LE(worst_delta_e(look, LatticeCode(text)), std::stod(bound));
    }
    const LatticeCode by_code(code(look, "1"));
    EXPECT_EQ(by_code({NAN, 2, -1}), by_code({0, 1, 0}));
}

TEST_F(InlineShader, of_curves_computes_them) {
    const std::string look = folder.write("curve.cube", curve_look);
    const std::string text = code(look, "0.01");
    const std::array<CurveCode, 3> curves{CurveCode(text, "after_r"), CurveCode(text, "after_g"),
                                          CurveCode(text, "after_b")};
    EXPECT_EQ(text.find("lut_before"), std::string::npos);
    EXPECT_EQ(text.find("dot("), std::string::npos);
    EXPECT_LT(worst_delta_e(look,
                            [&](Rgb c) {
                                return Rgb{curves[0](c.r), curves[1](c.g), curves[2](c.b)};
                            }),
              0.01);
}

TEST_F(InlineShader, of_curves_and_a_matrix_computes_the_look_within_the_bound) {
    const std::string recipe = folder.write("mixer.json", mixer_recipe);
    const std::string text = code(recipe, "1.5");
    ASSERT_NE(text.find("dot("), std::string::npos) << text.substr(0, 900);
    EXPECT_LE(worst_delta_e(recipe, MixingCode(text)), 1.5);
}

TEST_F(InlineShader, is_refused_with_the_figure_that_would_do) {
    const std::string steep = folder.write("steep.cube", "LUT_3D_SIZE 2\n0 0 0\n1 1 0\n0 1 1\n"
                                                         "1 0 0\n0 0 1\n1 0 1\n1 1 0\n0 1 0\n");
    const std::string noisy = folder.write("noisy.cube", [] {
        std::string rows = "LUT_3D_SIZE 20\n";
        for (unsigned i = 0, seed = 5; i < 8000; ++i) {
            for (int c = 0; c < 3; ++c) {
                seed = seed * 1664525U + 1013904223U;
                rows += std::to_string((seed >> 16U) % 1000 / 1000.0) + (c < 2 ? " " : "\n");
            }
        }
        return rows;
    }());
    EXPECT_EQ(code(steep, "1").empty(), false); // its own two nodes do
    const std::string out = folder.path("x.glsl");
    const Result refused =
        lutconv_in_process({"shader", "--inline", noisy, "--language", "glsl", "-o", out});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(out));
    std::smatch figure;
    ASSERT_TRUE(
        std::regex_search(refused.err, figure, std::regex("--max-delta-e ([0-9.]+) would allow")))
        << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_FALSE(code(noisy, figure[1]).empty());
}

TEST_F(InlineShader, is_written_in_every_language_and_says_what_has_no_part_in_it) {
    const std::string look = folder.write("a \\\\ b.cube", saturated_cube(5));
    const std::string curve = folder.write("curve.cube", curve_look);
    for (const lutlib::ShaderLanguage& language : lutlib::shader_languages()) {
        for (const std::string& each : {look, curve}) {
            const std::string text = code(each, "3", std::string(language.name));
            EXPECT_EQ(text.find('$'), std::string::npos) << text.substr(0, 600);
            EXPECT_EQ(text.find('\\'), std::string::npos) << text.substr(0, 600);
            EXPECT_NE(text.find("lut_lookup("), std::string::npos);
            EXPECT_EQ(text.find("lut_strip"), std::string::npos);
        }
    }
    const Result unused =
        lutconv_in_process({"shader", "--inline", curve, "--language", "glsl", "--engine", "unity",
                            "--size", "9", "-o", folder.path("x.glsl")});
    EXPECT_EQ(unused.exit_code, 0);
    for (const char* option : {"--engine changes nothing here", "--size changes nothing here"}) {
        EXPECT_NE(unused.err.find(option), std::string::npos) << unused.err;
    }
    const Result picture = lutconv_in_process(
        {"shader", "--language", "glsl", "--max-delta-e", "2", "-o", folder.path("x.glsl")});
    EXPECT_NE(picture.err.find("--max-delta-e changes nothing here"), std::string::npos)
        << picture.err;
}

TEST_F(InlineShader, compiles) {
    const char* const compiler = "/usr/bin/glslangValidator";
    if (!std::filesystem::exists(compiler)) {
        GTEST_SKIP() << "there is no glslangValidator (Debian package glslang-tools)";
    }
    const std::string lattice = folder.write("look.cube", saturated_cube(7)),
                      curve = folder.write("curve.cube", curve_look),
                      mixer = folder.write("mixer.json", mixer_recipe);
    for (const std::string& look : {lattice, curve, mixer}) {
        const std::string glsl = folder.write(
            "x.frag", "#version 330\n" + code(look, "1.5") +
                          "in vec4 v;\nout vec4 o;\nvoid main() { o.rgb = lut_lookup(v.rgb); }\n");
        const std::string hlsl =
            folder.write("x.hlsl", code(look, "1.5", "hlsl") +
                                       "float4 main(float4 v : COLOR) : SV_Target { return "
                                       "float4(lut_lookup(v.rgb), 1); }\n");
        for (const std::string& words :
             {"-S frag '" + glsl + "'",
              "-D -V -S frag -e main -o '" + folder.path("x.spv") + "' '" + hlsl + "'"}) {
            EXPECT_EQ(std::system((std::string(compiler) + " " + words + " >'" +
                                   folder.path("log") + "' 2>&1")
                                      .c_str()),
                      0)
                << look << '\n'
                << contents(folder.path("log"));
        }
    }
}

} // namespace
} // namespace converter_test
