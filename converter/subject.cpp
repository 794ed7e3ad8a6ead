#include "converter/subject.h"

#include "lutlib/engine/recognise.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/lut_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace converter {
namespace {

namespace io = lutlib::io;
using lutlib::Engine;

const Engine* engine_with_layout(std::string_view layout) {
    const auto all = lutlib::engines();
    const auto row =
        std::find_if(all.begin(), all.end(), [&](const Engine& e) { return e.layout == layout; });
    return row == all.end() ? nullptr : &*row;
}

void choose_engine(Subject& s, const std::string& name) {
    s.named_by = NamedBy::picture;
    s.engine = lutlib::engine_named(io::text_entry(s.image, "Engine").value_or(""));
    if (!s.engine) {
        s.named_by = NamedBy::content;
        const std::string_view layout = recognise_one(decoded(s.codes), name).reading.layout->name;
        s.engine = engine_with_layout(layout);
        if (!s.engine) {
            throw lutlib::Error(fmt::format("this is a {} picture, which no known engine reads as "
                                            "it is; name the engine with --engine",
                                            layout),
                                {name, 0, {}});
        }
    }
}

// The rows of pixels of one of the lattices that lie below each other.
void cut_out(io::PngImage& image, int rows, int row) {
    const auto part = static_cast<std::ptrdiff_t>(image.samples.size()) / rows;
    image.height /= rows;
    image.samples = {image.samples.begin() + row * part, image.samples.begin() + (row + 1) * part};
}

// The size of the lattice in the engine's layout, the picture cut to it where it holds several.
int take_lattice(Subject& s, std::optional<int> row) {
    const auto held =
        arrangement_in(*lutlib::layout_named(s.engine->layout), {s.codes.width, s.codes.height});
    const int rows = held ? held->rows : 1;
    if (row && (*row < 0 || *row >= rows)) {
        throw lutlib::UsageError(fmt::format(
            "--row {}: the picture has {} for this engine", *row,
            rows == 1 ? "one lattice" : fmt::format("{} lattices, 0 to {}", rows, rows - 1)));
    }
    if (rows > 1 && !row) {
        const lutlib::Layout& vertical = *lutlib::layout_named("strip-vertical");
        const auto upright = vertical.lattice({s.codes.width, s.codes.height});
        s.contract.push_back(
            upright ? fmt::format("the picture is a vertical strip of {} nodes per axis; the "
                                  "engine reads the layout {}: bake it again for the engine",
                                  *upright, s.engine->layout)
                    : fmt::format("the picture holds {} lattices below each other; verify one of "
                                  "them with --row 0 to {}, from the top",
                                  rows, rows - 1));
        return 0;
    }
    if (rows > 1) {
        cut_out(s.image, rows, *row);
        s.codes = io::code_picture(s.image);
    }
    return held ? held->size : 0;
}

std::string wrong_size(const Subject& s) {
    std::string words = fmt::format("wrong size: {}x{} pixels is not a size of a {} picture",
                                    s.codes.width, s.codes.height, s.engine->layout);
    for (const lutlib::Recognition& reading : recognise(decoded(s.codes))) {
        words += fmt::format("; they could be {} of size {}", reading.layout->name, reading.size);
    }
    return words;
}

void check_shape(const io::PngImage& image, const Engine& engine, int size,
                 std::vector<std::string>& points) {
    try {
        check_contract(engine, size, image.depth.bits);
    } catch (const lutlib::UsageError& error) {
        points.push_back(error.message());
    }
}

// Every engine of the table loads RGB; what a loader does with other alphas is its own affair.
void check_alpha(const io::PngImage& image, std::vector<std::string>& points) {
    const auto step = static_cast<std::size_t>(image.channels);
    std::size_t clear = 0;
    for (std::size_t i = 3; step == 4 && i < image.samples.size(); i += step) {
        clear += image.samples[i] < image.depth.maximum();
    }
    if (clear > 0) {
        points.push_back(fmt::format("{} texels are not opaque; the engine wants RGB, and a loader "
                                     "may multiply the codes by alpha",
                                     clear));
    }
}

std::string joined(const std::vector<std::string_view>& words) {
    std::string out;
    for (std::size_t i = 0; i < words.size(); ++i) {
        out += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + std::string(words[i]);
    }
    return out;
}

std::string engines_that(lutlib::ColorChunks use) {
    std::vector<std::string_view> names;
    for (const Engine& engine : lutlib::engines()) {
        if (engine.color_chunks == use) {
            names.push_back(engine.name);
        }
    }
    return joined(names);
}

// gAMA, cHRM and iCCP.
std::vector<std::string_view> converting_chunks(const io::PngImage& image) {
    std::vector<std::string_view> out = color_chunks(image);
    std::erase(out, "sRGB");
    return out;
}

constexpr std::string_view strip_advice =
    "'lutconv convert IN.png -o OUT.png --strip-tags' takes them out and leaves the texels";

// What of the chunks is wrong for the engine, in words; empty: nothing.
std::string harmful_tags(const io::PngImage& image, const Engine& engine) {
    const bool wants_tag = engine.srgb_tag == lutlib::SrgbTag::present;
    if (wants_tag != image.srgb_tag) {
        return wants_tag ? fmt::format("the sRGB chunk is missing; {} needs it", engine.label)
                         : fmt::format("the PNG carries the chunk sRGB, by which {} would decode "
                                       "the codes; {}",
                                       engine.label, strip_advice);
    }
    const std::vector<std::string_view> found = converting_chunks(image);
    if (found.empty() || engine.color_chunks == lutlib::ColorChunks::ignored) {
        return {};
    }
    const bool surely = engine.color_chunks == lutlib::ColorChunks::converted;
    return fmt::format("the PNG carries {}, by which {} {} convert the codes ({} ignore that); {}",
                       joined(found), engine.label, surely ? "would" : "may",
                       engines_that(lutlib::ColorChunks::ignored), strip_advice);
}

std::string harmless_tags(const io::PngImage& image, const Engine& engine) {
    const std::vector<std::string_view> found = converting_chunks(image);
    return found.empty() || engine.color_chunks != lutlib::ColorChunks::ignored
               ? std::string()
               : fmt::format(
                     "the PNG carries {}, which {} ignores ({} would convert the codes); {}",
                     joined(found), engine.label, engines_that(lutlib::ColorChunks::converted),
                     strip_advice);
}

// What is no PNG says nothing of its colours that we know of.
io::PngImage image_of(lutlib::CodeImage codes) {
    io::PngImage out;
    static_cast<lutlib::CodeImage&>(out) = std::move(codes);
    return out;
}

} // namespace

std::vector<std::string_view> color_chunks(const io::PngImage& image) {
    std::vector<std::string_view> out;
    for (const auto& [there, name] : {std::pair{image.srgb_tag, "sRGB"},
                                      {image.gamma_tag, "gAMA"},
                                      {image.primaries_tag, "cHRM"},
                                      {image.profile_tag, "iCCP"}}) {
        if (there) {
            out.emplace_back(name);
        }
    }
    return out;
}

std::vector<std::string> contract_points(const io::PngImage& image, const Engine& engine,
                                         int size) {
    std::vector<std::string> out;
    if (size > 0) {
        check_shape(image, engine, size, out);
    }
    check_alpha(image, out);
    if (std::string tags = harmful_tags(image, engine); !tags.empty()) {
        out.push_back(std::move(tags));
    }
    return out;
}

bool Subject::fitted() const {
    return io::text_entry(image, "Lattice") == "fitted";
}

Subject open_subject(const std::string& path, const Engine* engine, std::optional<int> row) {
    Subject s;
    const std::string name = io::input_name(path);
    const std::string bytes = io::read_file(path);
    if (io::is_png(bytes)) {
        s.image = io::read_png(bytes, name);
    } else {
        const io::LutPicture picture = io::read_lut_picture(bytes, name);
        s.image = image_of(io::code_picture(picture));
        s.notes = picture.remarks;
    }
    s.codes = io::code_picture(s.image);
    s.engine = engine;
    if (!engine) {
        choose_engine(s, name);
    }
    s.size = take_lattice(s, row);
    s.tags = harmful_tags(s.image, *s.engine);
    if (s.size == 0 && s.contract.empty()) {
        s.contract.push_back(wrong_size(s));
    }
    const std::vector<std::string> points = contract_points(s.image, *s.engine, s.size);
    s.contract.insert(s.contract.end(), points.begin(), points.end());
    if (std::string words = harmless_tags(s.image, *s.engine); !words.empty()) {
        s.notes.push_back(std::move(words));
    }
    return s;
}

} // namespace converter
