// Every file of tests/bad gets the error that expected.tsv says: file, line, message.
#include "lutlib/error.h"
#include "lutlib/formats/cube.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace lutlib {
namespace {

struct Expectation {
    std::string file, message;
    std::size_t line = 0;
};

const std::filesystem::path folder = TESTS_BAD;

std::vector<Expectation> expectations() {
    std::vector<Expectation> out;
    std::ifstream list(folder / "expected.tsv");
    for (std::string text; std::getline(list, text);) {
        std::istringstream fields(text);
        Expectation e;
        std::string line;
        std::getline(fields, e.file, '\t');
        std::getline(fields, line, '\t');
        std::getline(fields, e.message);
        e.line = std::stoul(line);
        out.push_back(e);
    }
    return out;
}

std::string contents(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

class BadCube : public testing::TestWithParam<Expectation> {};
INSTANTIATE_TEST_SUITE_P(Files, BadCube, testing::ValuesIn(expectations()), [](const auto& row) {
    return std::filesystem::path(row.param.file).stem().string();
});

TEST_P(BadCube, is_refused_with_file_line_and_text) {
    const auto& [file, message, line] = GetParam();
    try {
        read_cube(contents(folder / file), file);
        FAIL() << "was read without an error";
    } catch (const Error& error) {
        EXPECT_EQ(error.where().file, file);
        EXPECT_EQ(error.where().line, line) << error.what();
        EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
}

TEST(BadCubes, are_all_listed_with_their_message) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        files += entry.path().extension() == ".cube";
    }
    EXPECT_EQ(files, expectations().size());
    EXPECT_GT(files, 20U);
}

} // namespace
} // namespace lutlib
