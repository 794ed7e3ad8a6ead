// lutconv extract: the look out of a picture that was graded with a neutral strip in it.
#include "converter/command.h"
#include "converter/heat_png.h"
#include "converter/look_files.h"
#include "converter/options.h"
#include "converter/paint_picture.h"
#include "converter/report.h"
#include "converter/result.h"
#include "converter/usage.h"
#include "lutlib/bake/bake.h"
#include "lutlib/error.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/file.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/named.h"
#include "lutlib/paint/denoise.h"
#include "lutlib/paint/find_mark.h"
#include "lutlib/paint/on_picture.h"
#include "lutlib/paint/whole.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <optional>

namespace converter {
namespace {

namespace io = lutlib::io;

struct ExtractOptions {
    std::string input, output, original, heat, layout, around;
    EngineOption engine;
    int size = 0, bits = 0;
    bool denoise = false, damaged = false, json = false;
};

struct Extracted {
    lutlib::FoundStrip strip;
    lutlib::Picture upright;
    lutlib::Wholeness whole;
    int reduced_by = 1;
    lutlib::Lut lut;
    std::optional<lutlib::Denoised> denoised;
    lutlib::ErrorStats denoised_to_eye;
    std::optional<lutlib::OnPicture> on_original;
    std::vector<std::string> notes;
};

std::optional<lutlib::Pixel> pixel_of(const std::string& text) {
    if (text.empty()) {
        return std::nullopt;
    }
    lutlib::Pixel out;
    const char *const end = text.data() + text.size(), *at = text.data();
    const auto x = std::from_chars(at, end, out.x);
    if (x.ec == std::errc() && x.ptr != end && *x.ptr == ',') {
        const auto y = std::from_chars(x.ptr + 1, end, out.y);
        if (y.ec == std::errc() && y.ptr == end) {
            return out;
        }
    }
    throw lutlib::UsageError("--around takes a pixel, as 640,1100, not '" + text + "'");
}

std::string words_of(const lutlib::FoundStrip& strip) {
    const lutlib::Area area = lutlib::strip_area(strip);
    const std::string turn = lutlib::words_of(strip.turn);
    return fmt::format("a strip {} a mark, {} of {} nodes, at {},{}{}",
                       strip.mark_at ? "with" : "without", strip.framed.layout->name,
                       strip.framed.size, area.left, area.top,
                       turn.empty() ? "" : " of the picture once it is " + turn);
}

[[noreturn]] void refuse(const std::string& sentence, const std::string& path) {
    throw lutlib::Error(sentence, {io::input_name(path), 0, {}});
}

lutlib::FoundStrip the_strip(const std::vector<lutlib::FoundStrip>& found,
                             const ExtractOptions& o) {
    if (found.empty()) {
        refuse(o.around.empty()
                   ? "no neutral strip was found in it: place one with 'lutconv identity --into' "
                     "before grading; one without a mark must have its own size and at least 8 "
                     "nodes, and a look without colours its --layout"
                   : "no neutral strip was found around " + o.around,
               o.input);
    }
    if (found.size() > 1) {
        refuse(fmt::format("it holds {} strips; name a pixel of one with --around X,Y: {}; {}{}",
                           found.size(), words_of(found[0]), words_of(found[1]),
                           found.size() > 2 ? "; and others" : ""),
               o.input);
    }
    return found.front();
}

void take_strip(const ExtractOptions& o, PaintPicture& graded, Extracted& out) {
    lutlib::StripSearch search{.around = pixel_of(o.around),
                               .bits = graded.image.depth == io::Depth::uint16 ? 16 : 8};
    if (!o.layout.empty()) {
        search.layout = &lutlib::require_named(lutlib::layouts(), "layout", o.layout);
    }
    search.size = o.size;
    std::vector<lutlib::FoundStrip> found = find_strips(graded.colors, search);
    if (found.empty() || found.front().scale != 1) {
        if (std::optional<lutlib::Reduced> small = lutlib::reduced(graded.colors)) {
            std::vector<lutlib::FoundStrip> again = find_strips(small->picture, search);
            if (!again.empty() && again.front().scale == 1) {
                found = std::move(again);
                graded.colors = std::move(small->picture);
                graded.alpha.clear();
                out.reduced_by = small->by;
            }
        }
    }
    out.strip = the_strip(found, o);
    out.upright = turned(graded.colors, out.strip.turn);
    const std::vector<float> alpha =
        graded.alpha.empty() ? graded.alpha
                             : turned(graded.alpha, graded.colors.size(), out.strip.turn);
    out.whole = wholeness_of(out.upright, out.strip, alpha, graded.lossy);
}

void tell_of_strip(const PaintPicture& graded, Extracted& out) {
    if (out.reduced_by > 1) {
        out.notes.push_back(fmt::format("the picture was enlarged {0} times without smoothing; one "
                                        "pixel of each {0}x{0} was taken",
                                        out.reduced_by));
    }
    if (out.strip.falls) {
        out.notes.emplace_back("it is read as a negative, in which brighter inputs become darker");
    }
    if (out.strip.may_be_negative) {
        out.notes.emplace_back("it is read as turned by 180 degrees; were the look a negative, it "
                               "would stand upright: a mark tells (lutconv identity --into)");
    }
    if (!graded.profile.empty()) {
        out.notes.push_back("the picture carries " + graded.profile +
                            ", and codes are taken as they are: where the editor converted them, "
                            "the look holds the conversion too; export as sRGB without conversion");
    }
    for (const lutlib::Harm& harm : out.whole.harms) {
        out.notes.push_back((harm.spoils ? "not whole: " : "") + harm.words);
    }
}

/// What a lossy file or damage made of the look stands in it everywhere.
void doubt_edits(const PaintPicture& graded, Extracted& out) {
    if (graded.lossy.empty() && out.whole.harms.empty()) {
        return;
    }
    for (std::string& edit : out.on_original->edits) {
        edit += "; or that is what " +
                (graded.lossy.empty() ? std::string("was said of the strip") : "the lossy file") +
                " did to the look and the picture";
    }
}

void check_original(const ExtractOptions& o, const PaintPicture& graded,
                    const PaintPicture& original, Extracted& out) {
    const lutlib::Picture &before = original.colors, &after = out.upright;
    const lutlib::Area frame = lutlib::frame_area(out.strip);
    // As identity places it: below, or to the right.
    const bool below = frame.left == 0 && frame.top == before.height &&
                       after.height == frame.bottom &&
                       after.width == std::max(before.width, frame.right);
    const bool right = frame.top == 0 && frame.left == before.width && after.width == frame.right &&
                       after.height == std::max(before.height, frame.bottom);
    if (before.size() == after.size() || below || right) {
        out.on_original =
            on_picture(before, after, frame, lutlib::Transform::of(out.lut), lutlib::Viewing{});
        doubt_edits(graded, out);
        return;
    }
    const std::string sizes =
        fmt::format("{} has {}x{} pixels and this picture {}x{} with its strip at {},{}",
                    input_text(o.original), before.width, before.height, after.width, after.height,
                    frame.left, frame.top);
    if (out.whole.is_spoilt()) {
        out.notes.push_back("the look was not checked on the screenshot: " + sizes);
        return;
    }
    refuse(sizes + ": give the screenshot that the strip was placed in, and this picture as it was "
                   "then, not cropped",
           o.input);
}

void clean(Extracted& out) {
    const lutlib::Lut3D before = *out.lut.cube;
    out.denoised = lutlib::denoised(before, out.whole.noise);
    out.lut.cube = out.denoised->cube;
    std::vector<lutlib::RgbD> was, is;
    for (std::size_t i = 0; i < before.nodes.size(); ++i) {
        was.push_back(to_double(before.nodes[i]));
        is.push_back(to_double(out.lut.cube->nodes[i]));
    }
    std::vector<double> errors(was.size());
    lutlib::Eye{lutlib::Viewing{}}(lutlib::Metric::delta_e_2000, was, is, errors);
    out.denoised_to_eye = lutlib::error_stats(std::move(errors));
}

Extracted extract(const ExtractOptions& o) {
    Extracted out;
    PaintPicture graded = read_paint_picture(o.input);
    std::optional<PaintPicture> original;
    if (!o.original.empty()) {
        original = read_paint_picture(o.original);
    }
    take_strip(o, graded, out);
    tell_of_strip(graded, out);
    if (!lutlib::strip_area(out.strip).is_within(out.upright.size()) || out.strip.scale != 1) {
        return out; // nothing to read
    }
    out.lut.cube = lattice_in(out.upright, out.strip);
    out.lut.encodings = {"srgb", "srgb"};
    out.lut.provenance = io::input_name(o.input);
    if (o.denoise) {
        clean(out);
    }
    const double slack = (0.6 + out.whole.noise) / 255;
    if (const std::optional<lutlib::Harm> harm = lutlib::conversion_in(*out.lut.cube, slack)) {
        out.notes.push_back(harm->words);
        out.whole.harms.push_back(*harm);
    }
    if (original) {
        check_original(o, graded, *original, out);
    }
    return out;
}

std::string made_picture(const ExtractOptions& o, Extracted& found) {
    const lutlib::Engine& engine = o.engine.get();
    const lutlib::LookPlace place = io::place_in(engine, encodings_of(found.lut.encodings));
    const lutlib::Bake picture =
        bake(place.applied().around(lutlib::Transform::of(found.lut)), engine, engine.default_size,
             o.bits ? o.bits : engine.default_bits);
    if (place.applied().converts()) {
        found.notes.push_back(sentence_of(place, engine.name));
    }
    return io::picture_bytes(picture, {.source = io::input_name(o.input),
                                       .title = "",
                                       .interpolation = "tetrahedral",
                                       .encodings = names_of(place.shown()),
                                       .look = names_of(place.look)});
}

nlohmann::ordered_json extraction_json(const ExtractOptions& o, const Extracted& found,
                                       bool written) {
    const lutlib::Area area = lutlib::strip_area(found.strip);
    nlohmann::ordered_json out{
        {"graded", o.input},
        {"output", written ? nlohmann::ordered_json(o.output) : nlohmann::ordered_json()},
        {"strip",
         {{"marked", found.strip.mark_at.has_value()},
          {"layout", found.strip.framed.layout->name},
          {"size", found.strip.framed.size},
          {"x", area.left},
          {"y", area.top},
          {"turn", lutlib::words_of(found.strip.turn)},
          {"scale", found.strip.scale},
          {"noise", found.whole.noise}}}};
    out["harms"] = nlohmann::ordered_json::array();
    for (const lutlib::Harm& harm : found.whole.harms) {
        out["harms"].push_back(
            {{"name", harm.name}, {"words", harm.words}, {"spoils", harm.spoils}});
    }
    out["notes"] = found.notes;
    if (found.denoised) {
        out["denoised"] = {{"moved", found.denoised->moved},
                           {"mean", found.denoised->mean},
                           {"largest", found.denoised->largest},
                           {"delta_e_2000", to_json(found.denoised_to_eye)}};
    }
    if (found.on_original) {
        out["on_original"] = {{"delta_e_2000", to_json(found.on_original->delta_e_2000)},
                              {"edits", found.on_original->edits}};
    }
    return out;
}

std::string extraction_text(const ExtractOptions& o, const Extracted& found, bool readable,
                            bool written) {
    std::string out = fmt::format("{} <- {}\n  {}\n", written ? output_text(o.output) : "nothing",
                                  input_text(o.input), words_of(found.strip));
    for (const std::string& note : found.notes) {
        out += "  " + one_line(note) + "\n";
    }
    if (const auto& d = found.denoised) {
        out += fmt::format("  denoised: {} of {} nodes moved, by {:.2f} codes of 8 bits in the "
                           "mean and {:.2f} at most; dE2000 mean {:.2f}, largest {:.2f}\n",
                           d->moved, d->cube.nodes.size(), d->mean, d->largest,
                           found.denoised_to_eye.mean, found.denoised_to_eye.max);
    }
    if (const auto& on = found.on_original) {
        out += fmt::format("  the look on {}, against what was graded: dE2000 mean {:.3g}, p99 "
                           "{:.3g}, largest {:.3g} over {} pixels outside the strip\n",
                           input_text(o.original), on->delta_e_2000.mean, on->delta_e_2000.p99,
                           on->delta_e_2000.max, on->delta_e_2000.count);
        for (const std::string& edit : on->edits) {
            out += "  " + edit + "\n";
        }
    }
    if (!written) {
        out += readable ? "  nothing was written; --damaged takes the strip as it is\n"
                        : "  nothing was written\n";
    }
    return out;
}

int run_extract(const ExtractOptions& o) {
    const std::string shown = standard_output_of(std::array{o.output, o.heat});
    require_one_standard_input(std::array{o.input, o.original});
    if (!o.heat.empty() && o.original.empty()) {
        throw lutlib::UsageError("--heat shows where the look misses --original: add that");
    }
    if (o.engine.given()) {
        require_png_name(o.output, "--engine");
        check_contract(o.engine.get(), o.engine.get().default_size,
                       o.bits ? o.bits : o.engine.get().default_bits);
    } else if (o.bits) {
        throw lutlib::UsageError("--bits is for pictures: add --engine");
    }
    Extracted found = extract(o);
    const bool readable = found.lut.cube.has_value();
    const bool written = readable && (o.damaged || !found.whole.is_spoilt());
    std::string heat;
    std::vector<io::FileToWrite> others;
    if (!o.heat.empty() && found.on_original) {
        heat = heat_png(*found.on_original);
        others.push_back({o.heat, heat});
    }
    if (written && o.engine.given()) {
        const std::string picture = made_picture(o, found);
        others.push_back({o.output, picture});
        io::write_files(others);
    } else if (written) {
        tell_losses(write_look(found.lut, o.output, others), o.output);
    } else if (!others.empty()) {
        io::write_files(others);
    }
    if (o.json) {
        print(extraction_json(o, found, written), shown);
    } else {
        print(extraction_text(o, found, readable, written),
              written ? shown : std::string(io::standard_stream));
    }
    return written ? ok : verification_failed;
}

} // namespace

Run declare_extract(Verb& verb) {
    const auto o = std::make_shared<ExtractOptions>();
    verb.add_option("GRADED", o->input,
                    "the graded picture of any type, with the strip in it, or - for standard "
                    "input")
        .required();
    verb.add_output("-o,--output", o->output,
                    "a LUT file of any extension, or with --engine a PNG; - for standard output")
        .required();
    o->engine.declare(verb, "");
    verb.add_option("--bits", o->bits, "bits per sample of the engine's picture: 8 or 16")
        .takes(Takes::picture_bits);
    verb.add_flag("--denoise", o->denoise,
                  "take off what dithering, lossy files and 8 bits left: smooth rows, that rise "
                  "where they rise but for noise, within three times the noise that was measured");
    verb.add_option("--original", o->original,
                    "the screenshot before it was graded, to check the look on: dE2000 outside the "
                    "strip, and what was edited in places");
    verb.add_output("--heat", o->heat,
                    "a PNG of where the look misses the graded picture, dE2000 from 0 (blue) to "
                    "10 (yellow); needs --original");
    verb.add_option("--layout", o->layout,
                    "of a strip without a mark, where its content does not tell: " +
                        lutlib::names_of(lutlib::layouts()));
    verb.add_option("--size", o->size, "nodes per axis of a strip without a mark (default: any)")
        .takes(Takes::cube_size);
    verb.add_option("--around", o->around, "X,Y: a pixel of the strip, where there are several");
    verb.add_flag("--damaged", o->damaged, "write the look of a strip that is not whole, too");
    verb.add_flag("--json", o->json, "print the results as JSON");
    verb.footer("Exit code 1, and nothing written, where the strip was blurred, cropped, scaled or "
                "edited in places.");
    return [o] { return run_extract(*o); };
}

} // namespace converter
