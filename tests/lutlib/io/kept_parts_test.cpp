// Files of OpenImageIO's types, written and read back by OpenImageIO itself.
#include "lutlib/io/image.h"
#include "tests/lutlib/io/scratch.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

namespace lutlib::io {
namespace {

constexpr int width = 5, height = 3;

struct Part {
    OIIO::ImageSpec spec;
    std::vector<float> values;
};

Part part(const std::string& name, std::vector<std::string> channels, OIIO::TypeDesc type) {
    Part out{{width, height, static_cast<int>(channels.size()), type}, {}};
    out.spec.channelnames = std::move(channels);
    out.spec.attribute("oiio:subimagename", name);
    for (std::size_t i = 0; i < static_cast<std::size_t>(width * height * out.spec.nchannels);
         ++i) {
        out.values.push_back(static_cast<float>(i + 1) / 128);
    }
    return out;
}

void write(const std::string& path, const std::vector<Part>& parts) {
    const auto output = OIIO::ImageOutput::create(path);
    std::vector<OIIO::ImageSpec> specs;
    for (const Part& p : parts) {
        specs.push_back(p.spec);
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        ASSERT_TRUE(i == 0 ? output->open(path, static_cast<int>(specs.size()), specs.data())
                           : output->open(path, specs[i], OIIO::ImageOutput::AppendSubimage));
        ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, parts[i].values.data()));
    }
    ASSERT_TRUE(output->close());
}

std::vector<Part> read(const std::string& path) {
    std::vector<Part> out;
    const auto input = OIIO::ImageInput::open(path);
    for (int i = 0; input && input->seek_subimage(i, 0); ++i) {
        Part p{input->spec(), {}};
        p.values.resize(p.spec.image_pixels() * static_cast<std::size_t>(p.spec.nchannels));
        EXPECT_TRUE(input->read_image(i, 0, 0, -1, OIIO::TypeDesc::FLOAT, p.values.data()));
        out.push_back(std::move(p));
    }
    if (input) {
        input->geterror();
    }
    return out;
}

ImageWriteOptions keeping(const FloatImage& image) {
    return {.depth = image.depth, .alpha = image.alpha, .text = {}, .keep = image.source.get()};
}

TEST(KeptParts, of_an_exr_are_bit_for_bit_those_of_the_file_but_for_the_picture_s_colors) {
    const ScratchFolder folder;
    std::vector<Part> parts{part("depth", {"Z"}, OIIO::TypeDesc::FLOAT),
                            part("rgba", {"R", "G", "B", "A", "motion.X"}, OIIO::TypeDesc::HALF)};
    OIIO::ImageSpec& spec = parts[1].spec;
    spec.channelformats = {4, OIIO::TypeDesc(OIIO::TypeDesc::HALF)};
    spec.channelformats.emplace_back(OIIO::TypeDesc::FLOAT);
    for (Part& p : parts) {
        p.spec.x = -1;
        p.spec.y = -1;
        p.spec.full_width = width - 2;
        p.spec.full_height = height - 1;
        p.spec.attribute("compression", "piz");
    }
    spec.attribute("Copyright", "somebody");
    spec.attribute("framesPerSecond", 24.0F);
    const std::string from = folder.file("a.exr"), to = folder.file("b.exr");
    write(from, parts);

    FloatImage image = read_image(from);
    EXPECT_TRUE(image.premultiplied);
    EXPECT_EQ(image.depth, Depth::half);
    EXPECT_EQ(image.rgba[3], parts[1].values[3]);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        image.rgba[i] = 0.25F;
    }
    EXPECT_TRUE(write_image(to, image, keeping(image)).empty());
    const std::vector<Part> before = read(from), after = read(to);
    ASSERT_EQ(after.size(), 2U);
    EXPECT_EQ(after[0].values, before[0].values);
    for (std::size_t i = 0; i < after[1].values.size(); ++i) {
        EXPECT_EQ(after[1].values[i], i % 5 == 0 ? 0.25F : before[1].values[i]) << i;
    }
    for (std::size_t p = 0; p < 2; ++p) {
        EXPECT_EQ(after[p].spec.channelnames, before[p].spec.channelnames);
        EXPECT_EQ(after[p].spec.channelformats, before[p].spec.channelformats);
        EXPECT_EQ(after[p].spec.x, -1);
        EXPECT_EQ(after[p].spec.full_width, width - 2);
        EXPECT_EQ(after[p].spec.get_string_attribute("compression"), "piz");
        EXPECT_EQ(after[p].spec.get_string_attribute("oiio:subimagename"),
                  p == 0 ? "depth" : "rgba");
    }
    EXPECT_EQ(after[1].spec.get_string_attribute("Copyright"), "somebody");
    EXPECT_EQ(after[1].spec.get_float_attribute("framesPerSecond"), 24.0F);
}

TEST(KeptParts, that_another_type_does_not_hold_are_told) {
    const ScratchFolder folder;
    std::vector<Part> parts{part("", {"R", "G", "B", "A", "Z"}, OIIO::TypeDesc::HALF)};
    parts[0].spec.full_width = width + 4;
    const std::string from = folder.file("a.exr");
    write(from, parts);
    const FloatImage image = read_image(from);
    const auto said = [&](const char* name) {
        std::string all;
        for (const std::string& lost : write_image(
                 folder.file(name), image,
                 {.depth = Depth::uint8, .alpha = true, .text = {}, .keep = image.source.get()})) {
            all += lost + '\n';
        }
        return all;
    };
    const std::string tga = said("b.tga"), jpg = said("b.jpg"), png = said("b.png");
    for (const std::string& text : {tga, jpg, png}) {
        EXPECT_NE(text.find("the channels Z"), std::string::npos) << text;
        EXPECT_NE(text.find("the display window, 9x3"), std::string::npos) << text;
    }
    EXPECT_NE(jpg.find("the alpha"), std::string::npos) << jpg;
    EXPECT_EQ(tga.find("the alpha"), std::string::npos) << tga;
}

TEST(KeptParts, of_a_jpeg_are_its_orientation_profile_and_subsampling) {
    const ScratchFolder folder;
    std::vector<Part> parts{part("", {"R", "G", "B"}, OIIO::TypeDesc::UINT8)};
    OIIO::ImageSpec& spec = parts[0].spec;
    spec.attribute("Orientation", 6);
    spec.attribute("Make", "somebody");
    spec.attribute("jpeg:subsampling", "4:4:4");
    const std::string from = folder.file("a.jpg"), to = folder.file("b.jpg");
    write(from, parts);
    const FloatImage image = read_image(from);
    EXPECT_EQ(image.source->orientation, 6);
    EXPECT_TRUE(write_image(to, image, keeping(image)).empty());
    const std::vector<Part> after = read(to);
    ASSERT_EQ(after.size(), 1U);
    EXPECT_EQ(after[0].spec.get_int_attribute("Orientation"), 6);
    EXPECT_EQ(after[0].spec.get_string_attribute("Make"), "somebody");
    EXPECT_EQ(after[0].spec.get_string_attribute("jpeg:subsampling"), "4:4:4");
}

TEST(KeptParts, of_a_tiff_say_whether_its_colors_are_multiplied_by_alpha) {
    const ScratchFolder folder;
    for (const bool straight : {true, false}) {
        std::vector<Part> parts{part("", {"R", "G", "B", "A"}, OIIO::TypeDesc::UINT16)};
        if (straight) {
            parts[0].spec.attribute("oiio:UnassociatedAlpha", 1);
        }
        const std::string from = folder.file("a.tif"), to = folder.file("b.tif");
        write(from, parts);
        const FloatImage image = read_image(from);
        EXPECT_EQ(image.premultiplied, !straight);
        EXPECT_EQ(stores_premultiplied(to, image.source.get()), !straight);
        write_image(to, image, keeping(image));
        EXPECT_EQ(read_image(to).premultiplied, !straight);
        EXPECT_EQ(read_image(to).rgba, image.rgba);
    }
}

} // namespace
} // namespace lutlib::io
