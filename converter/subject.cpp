#include "converter/subject.h"

#include "lutlib/engine/recognise.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/limits.h"

#include <fmt/core.h>

#include <algorithm>

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
        s.engine = engine_with_layout(recognise_one(decoded(s.codes), name).layout->name);
    }
}

int size_in_layout(const Engine& engine, const lutlib::CodeImage& codes) {
    const lutlib::Layout& layout = *lutlib::layout_named(engine.layout);
    const lutlib::PictureSize wanted{codes.width, codes.height};
    for (int n = lutlib::limits::min_cube_size; n <= lutlib::limits::max_cube_size; ++n) {
        if (layout.picture(n) == wanted) {
            return n;
        }
    }
    return 0;
}

std::string wrong_size(const Subject& s) {
    std::string words = fmt::format("wrong size: {}x{} pixels are no {} picture", s.codes.width,
                                    s.codes.height, s.engine->layout);
    for (const lutlib::Recognition& reading : recognise(decoded(s.codes))) {
        words += fmt::format("; they could be {} of size {}", reading.layout->name, reading.size);
    }
    return words;
}

void check_shape(Subject& s) {
    if (s.size == 0) {
        s.contract.push_back(wrong_size(s));
        return;
    }
    try {
        check_contract(*s.engine, s.size, s.codes.depth.bits);
    } catch (const lutlib::UsageError& error) {
        s.contract.push_back(error.message());
    }
}

// Every engine of the table loads RGB; what a loader does with other alphas is its own affair.
void check_alpha(Subject& s) {
    const auto step = static_cast<std::size_t>(s.image.channels);
    std::size_t clear = 0;
    for (std::size_t i = 3; step == 4 && i < s.image.samples.size(); i += step) {
        clear += s.image.samples[i] < s.image.depth.maximum();
    }
    if (clear > 0) {
        s.contract.push_back(
            fmt::format("{} texels are not opaque; the engine wants RGB, and a loader may "
                        "multiply the codes by alpha",
                        clear));
    }
}

void check_tags(Subject& s) {
    const bool wants_tag = s.engine->srgb_tag == lutlib::SrgbTag::present;
    if (wants_tag != s.image.srgb_tag) {
        s.contract.emplace_back(wants_tag ? "the sRGB tag is missing; the engine needs it"
                                          : "it is tagged sRGB; the engine would decode the codes");
    }
    if (s.image.profile_tag || s.image.gamma_tag || s.image.primaries_tag) {
        s.contract.emplace_back(
            "it carries a colour profile, gamma or primaries (iCCP, gAMA, cHRM); "
            "a loader may convert the codes");
    }
}

} // namespace

bool Subject::fitted() const {
    return io::text_entry(image, "Lattice") == "fitted";
}

Subject open_subject(const std::string& path, const Engine* engine) {
    Subject s;
    const std::string name = io::input_name(path);
    s.image = io::read_png(io::read_file(path), name);
    s.codes = io::code_picture(s.image);
    s.engine = engine;
    if (!engine) {
        choose_engine(s, name);
    }
    s.size = size_in_layout(*s.engine, s.codes);
    check_shape(s);
    check_alpha(s);
    check_tags(s);
    return s;
}

} // namespace converter
