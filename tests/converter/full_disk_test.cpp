// A full disk under every writer: an error, and nothing of the device is replaced.
#include "lutlib/io/formats.h"
#include "lutlib/io/oiio.h"
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace {

namespace io = lutlib::io;
using namespace converter_test;

void expect_full(const std::vector<std::string>& words, const Folder& folder,
                 const std::string& name) {
    const std::string path = folder.path(name);
    std::filesystem::create_symlink("/dev/full", path);
    std::vector<std::string> all = words;
    all.insert(all.end(), {"-o", path});
    const Result result = lutconv_in_process(all);
    EXPECT_EQ(result.exit_code, 2) << name;
    EXPECT_NE(result.err.find("No space left on device"), std::string::npos)
        << name << ": " << result.err;
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full")) << name;
    std::filesystem::remove(path);
}

TEST(FullDisk, is_an_error_for_every_lut_format) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(5));
    for (const lutlib::FileFormat* const format : io::file_formats()) {
        if (format->write) {
            std::vector<std::string> words{"convert", look, "--format", std::string(format->name)};
            if (format->layout) {
                words.insert(words.end(), {"--size", "16"});
            }
            expect_full(words, folder, "x." + format->extensions.first());
        }
    }
}

TEST(FullDisk, is_an_error_for_every_type_of_picture) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(5));
    std::vector<std::string> extensions = io::oiio().written_extensions();
    extensions.emplace_back("png");
    for (const std::string& extension : extensions) {
        expect_full({"apply", look, SAMPLE_LOOKS "/warm_teal.png"}, folder, "x." + extension);
    }
}

TEST(FullDisk, under_one_of_two_outputs_keeps_the_other_as_it_was) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(5));
    const std::string kept = folder.write("kept", "kept");
    expect_full({"edit", look, "--save-recipe", kept, "--force"}, folder, "x.cube");
    EXPECT_EQ(contents(kept), "kept");
    expect_full({"report", look, "--sizes", "2", "--json", kept, "--force"}, folder, "x.html");
    EXPECT_EQ(contents(kept), "kept");
}

} // namespace
