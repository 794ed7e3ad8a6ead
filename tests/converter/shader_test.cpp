// What `shader` and the engines' pages say; that the code computes what the CPU does is held by
// tests/preview/generated.
#include "lutlib/engine/shader_code.h"
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

namespace converter_test {
namespace {

TEST(Shader, is_written_for_every_engine_in_every_language) {
    const Folder folder;
    for (const lutlib::Engine& engine : lutlib::engines()) {
        for (const lutlib::ShaderLanguage& language : lutlib::shader_languages()) {
            const std::string file = folder.path(std::string(language.file));
            const Result result =
                lutconv_in_process({"shader", "--engine", std::string(engine.name), "--language",
                                    std::string(language.name), "-o", file});
            ASSERT_EQ(result.exit_code, 0) << engine.name << language.name << result.err;
            const std::string code = contents(file);
            EXPECT_EQ(code.find('$'), std::string::npos) << code;
            EXPECT_NE(code.find("lut_lookup("), std::string::npos);
            EXPECT_NE(
                code.find("lutconv bake LOOK -o strip.png --engine " + std::string(engine.name)),
                std::string::npos)
                << code;
            EXPECT_NE(result.out.find(std::string(language.trial)), std::string::npos)
                << result.out;
            // A sampler would filter, and its half texel would be the reader's affair.
            EXPECT_EQ(code.find("texture("), std::string::npos) << code;
        }
    }
}

TEST(Shader, refuses_what_the_engine_does_not_take) {
    const Folder folder;
    const std::string file = folder.path("lut.glsl");
    const auto exit_code = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"shader", "-o", file};
        words.insert(words.end(), more.begin(), more.end());
        return lutconv_in_process(words).exit_code;
    };
    EXPECT_EQ(exit_code({"--language", "glsl", "--engine", "unreal", "--size", "32"}), 3);
    EXPECT_EQ(exit_code({"--language", "cg"}), 3);
    EXPECT_EQ(exit_code({"--language", "glsl", "--interpolation", "cubic"}), 3);
    EXPECT_TRUE(folder.names().empty());
    EXPECT_EQ(exit_code({"--language", "glsl", "--size", "32", "--interpolation", "tetrahedral"}),
              0);
    EXPECT_NE(contents(file).find("LUT_SIZE = 32"), std::string::npos);
}

// for e in $(ls docs/engines | sed 's/.md//'); do lutconv engines --page $e > docs/engines/$e.md;
// done
TEST(EnginePage, in_docs_is_what_the_row_says) {
    for (const lutlib::Engine& engine : lutlib::engines()) {
        const std::string name(engine.name);
        const Result page = lutconv_in_process({"engines", "--page", name});
        ASSERT_EQ(page.exit_code, 0) << page.err;
        EXPECT_EQ(contents(std::string(REPOSITORY) + "/docs/engines/" + name + ".md"), page.out)
            << "write it anew: lutconv engines --page " << name << " > docs/engines/" << name
            << ".md";
    }
    EXPECT_EQ(lutconv_in_process({"engines", "--page", "quake"}).exit_code, 3);
}

TEST(Compare, exits_with_1_where_the_looks_differ_by_more_than_is_allowed) {
    const Folder folder;
    const std::string a = folder.write("a.cube", saturated_cube(5)),
                      b = folder.write("b.cube", "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n");
    EXPECT_EQ(lutconv_in_process({"compare", a, b}).exit_code, 0);
    const Result far = lutconv_in_process({"compare", a, b, "--max-delta-e", "0.5"});
    EXPECT_EQ(far.exit_code, 1);
    EXPECT_NE(far.out.find("FAILED: dE2000"), std::string::npos) << far.out;
    const Result json = lutconv_in_process({"compare", a, b, "--max-delta-e", "0.5", "--json"});
    EXPECT_EQ(json.exit_code, 1);
    EXPECT_NE(json.out.find("\"kept\": false"), std::string::npos) << json.out;
    EXPECT_EQ(lutconv_in_process({"compare", a, b, "--max-delta-e", "100"}).exit_code, 0);
    EXPECT_EQ(lutconv_in_process({"compare", a, a, "--max-delta-e", "0"}).exit_code, 0);
}

} // namespace
} // namespace converter_test
