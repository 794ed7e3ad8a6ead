#include "converter/picture_facts.h"

#include "converter/report.h"
#include "converter/subject.h"
#include "lutlib/io/file.h"
#include "lutlib/io/lut_picture.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace converter {
namespace {

namespace io = lutlib::io;

// How the file stores its samples: "8 bits a sample, palette, alpha, interlaced".
std::string storage(const io::LutPicture& picture, const io::PngImage& image) {
    std::string out =
        picture.bits ? fmt::format("{} bits a sample", picture.bits) : "floats a sample";
    for (const auto& [there, word] : {std::pair{image.palette, ", palette"},
                                      {image.grey, ", grey"},
                                      {picture.alpha, ", alpha"},
                                      {image.interlaced, ", interlaced"}}) {
        out += there ? word : "";
    }
    return out;
}

template <class Names>
std::string listed(const Names& names) {
    std::string out;
    for (const auto& name : names) {
        out += (out.empty() ? "" : ", ") + std::string(name);
    }
    return out.empty() ? "none" : out;
}

} // namespace

Takers takers_of(const io::PngImage& image, const lutlib::Layout& layout, int size) {
    Takers out;
    for (const lutlib::Engine& engine : lutlib::engines()) {
        if (engine.layout != layout.name) {
            continue;
        }
        const std::vector<std::string> points = contract_points(image, engine, size);
        out.json[std::string(engine.name)] = points;
        (points.empty() ? out.names : out.others).push_back(engine.name);
        for (const std::string& point : points) {
            out.reasons.push_back(fmt::format("not for {}: {}", engine.name, point));
        }
    }
    return out;
}

std::string takers_text(const Takers& takers) {
    std::string out = "engines that take it as it is: " + listed(takers.names);
    if (!takers.others.empty()) {
        out += fmt::format("; 'lutconv bake LOOK -o strip.png --engine NAME' makes what {} {}",
                           listed(takers.others), takers.others.size() == 1 ? "takes" : "take");
    }
    return out;
}

std::optional<PictureFacts> picture_facts(const std::string& bytes, const io::Look& look) {
    if (!look.kind().layout) {
        return std::nullopt;
    }
    const std::string file = io::input_name(look.path());
    const io::LutPicture picture = io::read_lut_picture(bytes, file);
    const lutlib::Layout& layout = *look.kind().layout;
    const auto [size, rows] = *arrangement_in(layout, picture.picture.size());
    const bool png = io::is_png(bytes);
    io::PngImage image;
    if (png) {
        image = io::read_png(bytes, file);
    } else {
        image.depth.bits = picture.bits == 8 ? 8 : 16;
    }
    const Takers takers = rows > 1 ? Takers{} : takers_of(image, layout, size);
    const std::vector<std::string_view> chunks = color_chunks(image);
    PictureFacts out;
    out.text = fmt::format("  picture: {}x{} pixels, {}{}\n  layout: {}, {} nodes per axis{}\n",
                           picture.picture.width, picture.picture.height, storage(picture, image),
                           png ? ", colour chunks: " + listed(chunks) : "", layout.name, size,
                           rows > 1 ? fmt::format(", {} stacked", rows) : "");
    if (picture.engine) {
        out.text += fmt::format("  its text names the engine {}\n", picture.engine->name);
    }
    const std::vector<std::string>& remarks = look.files().front().remarks;
    for (const std::string& remark : remarks) {
        out.text += "  but: " + one_line(remark) + "\n";
    }
    out.text += "  engines that take it as it is: " + listed(takers.names) + "\n";
    for (const std::string& reason : takers.reasons) {
        out.text += "  " + one_line(reason) + "\n";
    }
    out.json = {{"width", picture.picture.width},
                {"height", picture.picture.height},
                {"bits", picture.bits},
                {"alpha", picture.alpha},
                {"palette", image.palette},
                {"grey", image.grey},
                {"interlaced", image.interlaced},
                {"colour_chunks", chunks},
                {"layout", layout.name},
                {"size", size},
                {"rows", rows},
                {"engine_in_text", picture.engine ? picture.engine->name : ""},
                {"remarks", remarks},
                {"engines", takers.json}};
    return out;
}

} // namespace converter
