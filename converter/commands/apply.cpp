// lutconv apply: a picture through a LUT, on the codes or floats as the file stores them. What else
// the file holds goes into the new one.
#include "lutlib/interpolation/apply.h"
#include "converter/command.h"
#include "converter/look_files.h"
#include "converter/options.h"
#include "converter/placing.h"
#include "converter/recipe_options.h"
#include "converter/report.h"
#include "converter/unused.h"
#include "converter/usage.h"
#include "lutlib/error.h"
#include "lutlib/io/alpha.h"
#include "lutlib/io/file.h"
#include "lutlib/io/image.h"
#include "lutlib/io/orientation.h"
#include "lutlib/named.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace converter {
namespace {

namespace io = lutlib::io;

// How a picture's alpha stands to its colours.
struct AlphaRule {
    std::string_view name, help;
    std::optional<bool> premultiplied; ///< unset: as the file type says
    bool ignored = false;              ///< the look sees the stored colours
};
constexpr std::array<AlphaRule, 4> alpha_rules{{
    {"auto", "as the file type says: EXR premultiplied, PNG straight", std::nullopt},
    {"straight", "colours are not multiplied by it", false},
    {"premultiplied", "colours are multiplied by it", true},
    {"ignore", "the look sees the colours as they are stored", std::nullopt, true},
}};

struct Options {
    std::string lut, picture, output, depth, picture_encoding, output_encoding, layer;
    std::string alpha{alpha_rules.front().name};
    InterpolationOption interpolation;
    PlacingOptions placing;
    bool json = false;
};

struct Report {
    int width = 0, height = 0;
    std::size_t outside_domain = 0; ///< pixels whose input was clamped to the LUT's domain
    std::size_t clamped = 0;        ///< pixels whose output an integer file clamps to 0..1
    std::size_t not_a_number = 0;   ///< pixels that a conversion read as 0
    const io::DepthInfo* depth = nullptr;
    lutlib::LookPlace place;
    std::vector<std::string> remarks{}; ///< of channels that were chosen
    std::vector<std::string> lost{};    ///< of the picture's file, a phrase each
};

// Where a look keeps its encoding, the result goes back to the picture's; one that changes it, as
// camera LUTs do, is left to say what comes out.
lutlib::LookPlace place_of(const Options& o, const lutlib::LookEncodings& look,
                           const io::FloatImage& image) {
    lutlib::LookPlace place{
        look, encoding_of(image), {}, o.placing.convert(), &o.placing.adaptation()};
    if (!o.picture_encoding.empty()) {
        place.given = encoding_of(o.picture_encoding, "--picture-encoding");
    }
    if (!o.output_encoding.empty()) {
        place.wanted = encoding_of(o.output_encoding, "--output-encoding");
    } else if (look.input && look.input == look.output) {
        place.wanted = place.given;
    }
    return place;
}

std::string picture_text(const Options& o, const lutlib::LookPlace& place) {
    if (!o.picture_encoding.empty()) {
        return {};
    }
    if (place.given) {
        const bool is_known = place.look.input || place.look.output;
        return "the picture holds " + place.given->name() +
               " by its file type, profile or tag (--picture-encoding names another)" +
               (is_known ? ""
                         : "; the look does not say what it takes, and gets that as it is: name "
                           "it with --look-input and --look-output");
    }
    return place.look.input
               ? "the picture's encoding is not known and taken for the look's input, " +
                     place.look.input->name() +
                     ": if it is another, name it with "
                     "--picture-encoding"
               : "neither the picture's nor the look's encoding is known; the codes are looked up "
                 "as they are";
}

std::string result_text(const Options& o, const lutlib::LookPlace& place) {
    const std::optional<lutlib::Encoding> holds = place.shown().output;
    const std::string type = io::extension_of(o.output);
    const bool is_light = type == "exr" || type == "hdr";
    if (!holds) {
        return is_light && place.given ? "what the result holds is not known, and readers expect "
                                         "linear light in ." +
                                             type + " files: name it with --look-output"
                                       : "";
    }
    const bool misread = is_light && holds->curve->name != "linear";
    return "the result holds " + holds->name() +
           (misread ? ", but readers expect linear light in ." + type +
                          " files: write that with --output-encoding linear"
                    : "");
}

// A line each.
std::vector<std::string> encodings_text(const Options& o, const lutlib::LookPlace& place) {
    std::vector<std::string> out{picture_text(o, place)};
    if (place.given && (place.look.input || place.look.output)) {
        out.push_back(sentence_of(place, "the picture"));
    } else if (place.applied().converts()) {
        out.push_back(place.applied().text());
    }
    out.push_back(result_text(o, place));
    std::erase(out, "");
    return out;
}

// The depth that was asked for, which the file type must hold, else the nearest to the picture's.
io::Depth choose_depth(const Options& o, std::span<const io::Depth> held, io::Depth usual) {
    const std::string& name = o.depth;
    if (name.empty()) {
        return io::nearest_depth(usual, held);
    }
    std::vector<const io::DepthInfo*> rows;
    for (const io::Depth depth : held) {
        rows.push_back(&io::info_of(depth));
    }
    if (const auto* const row = lutlib::find_named(rows, name)) {
        return row->depth;
    }
    throw lutlib::UsageError('.' + io::extension_of(o.output) + " files cannot store --depth " +
                             name + "; they store " + lutlib::names_of(rows));
}

std::size_t pixels_with_nan(const float* rgba, std::size_t pixels) {
    std::size_t out = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        const float* const c = rgba + 4 * i;
        out += std::isnan(c[0]) || std::isnan(c[1]) || std::isnan(c[2]);
    }
    return out;
}

// What no table holds, colour by colour.
void apply_exactly(const lutlib::Transform& look, float* rgba, std::size_t pixels) {
    constexpr std::size_t at_once = 1 << 16;
    std::vector<lutlib::RgbD> colors;
    for (std::size_t first = 0; first < pixels; first += at_once) {
        colors.resize(std::min(at_once, pixels - first));
        float* const part = rgba + 4 * first;
        for (std::size_t i = 0; i < colors.size(); ++i) {
            colors[i] = lutlib::to_double({part[4 * i], part[4 * i + 1], part[4 * i + 2]});
        }
        lutlib::apply_in_parallel(look, colors);
        for (std::size_t i = 0; i < colors.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                part[4 * i + c] = static_cast<float>(colors[i][c]);
            }
        }
    }
}

Report apply(const io::Look& look, const lutlib::LookPlace& place, io::FloatImage& image,
             io::Depth depth) {
    const std::size_t pixels = image.rgba.size() / 4;
    float* const rgba = image.rgba.data();
    Report report{
        .width = image.width, .height = image.height, .depth = &io::info_of(depth), .place = place};
    const lutlib::Placement placement = place.applied();
    if (placement.before) {
        report.not_a_number = pixels_with_nan(rgba, pixels);
        apply_exactly(conversion(*placement.before, *placement.adaptation), rgba, pixels);
    }
    if (const std::optional<lutlib::Domain> domain = look.clamps_to()) {
        report.outside_domain = lutlib::pixels_outside(*domain, rgba, pixels, 4);
    }
    if (look.is_table()) {
        lutlib::apply(lutlib::StoredLut(*look.table().lut), lutlib::lookup_of(look.interpolation()),
                      rgba, rgba, pixels, 4);
    } else {
        apply_exactly(look.exact(), rgba, pixels);
    }
    if (placement.after) {
        apply_exactly(conversion(*placement.after, *placement.adaptation), rgba, pixels);
    }
    report.clamped = report.depth->integer ? lutlib::pixels_outside({}, rgba, pixels, 4) : 0;
    return report;
}

void print_report(const Options& o, const Report& r) {
    const auto pixels = static_cast<std::size_t>(r.width) * static_cast<std::size_t>(r.height);
    if (o.json) {
        print(nlohmann::ordered_json{{"lut", io::input_name(o.lut)},
                                     {"picture", io::input_name(o.picture)},
                                     {"output", io::output_name(o.output)},
                                     {"width", r.width},
                                     {"height", r.height},
                                     {"depth", r.depth->name},
                                     {"pixels_outside_domain", r.outside_domain},
                                     {"pixels_not_a_number", r.not_a_number},
                                     {"pixels_clamped", r.clamped},
                                     {"encodings", to_json(r.place)},
                                     {"remarks", r.remarks},
                                     {"not_kept", r.lost}},
              o.output);
        return;
    }
    std::string text = fmt::format("{} -> {}\n  {}x{} pixels, {}\n", input_text(o.picture),
                                   output_text(o.output), r.width, r.height, r.depth->name);
    for (const std::string& line : encodings_text(o, r.place)) {
        text += "  encodings: " + line + '\n';
    }
    const auto share = [&](std::size_t count, const char* what) {
        return count == 0
                   ? ""
                   : fmt::format("  {} pixels ({:.3g} %) {}\n", count,
                                 100 * static_cast<double>(count) / static_cast<double>(pixels),
                                 what);
    };
    text += share(r.outside_domain, "lay outside the LUT's input and were clamped to it");
    text += share(r.not_a_number, "hold NaN, which was read as 0");
    text += share(r.clamped, "came out outside 0..1 and were clamped, as the file stores integers");
    for (const std::string& remark : r.remarks) {
        text += "  " + remark + '\n';
    }
    for (const std::string& lost : r.lost) {
        text += "  not kept, as the new file does not hold it: " + lost + '\n';
    }
    print(text, o.output);
}

const AlphaRule& alpha_rule(const Options& o) {
    return lutlib::require_named(alpha_rules, "alpha rule", o.alpha);
}

// Straight colours through the look; then as the new file stores them.
Report graded(const Options& o, const io::Look& look, const lutlib::LookPlace& place,
              io::FloatImage& image, io::Depth depth) {
    const AlphaRule& rule = alpha_rule(o);
    image.premultiplied = rule.premultiplied.value_or(image.premultiplied);
    const bool was_premultiplied = image.premultiplied;
    const io::LightOnly light = rule.ignored ? io::LightOnly{} : make_straight(image);
    Report report = apply(look, place, image, depth);
    if (rule.ignored) {
        image.premultiplied = was_premultiplied;
    } else if (image.alpha && io::stores_premultiplied(o.output, image.source.get())) {
        premultiply(image, light);
    }
    return report;
}

// Whether tags that say what the codes are hold for the result too.
bool keeps_encoding(const lutlib::LookPlace& place) {
    const std::optional<lutlib::Encoding> holds = place.shown().output;
    return !place.given || !holds || *holds == *place.given;
}

int run(const Options& o, const Verb& verb) {
    require_one_standard_input(std::array{o.lut, o.picture});
    alpha_rule(o);
    const std::vector<io::Depth> held = io::depths_of(o.output);
    choose_depth(o, held, held.front());
    const io::Look look =
        open_look(o.lut, {.interpolation = o.interpolation.get(), .encodings = o.placing.look()});
    io::FloatImage image = io::read_image(o.picture, o.layer);
    const std::shared_ptr<const io::PictureSource> source = image.source;
    const lutlib::LookPlace place = place_of(o, look.encodings(), image);
    const io::Depth depth = choose_depth(o, held, image.depth);
    tell_unused(verb, {interpolation_part(has_lattice(look)),
                       adaptation_part(place.applied()),
                       {"--alpha", image.alpha, "the picture has no alpha"}});
    Report report = graded(o, look, place, image, depth);
    report.remarks = source->remarks;
    if (source->orientation > 1 && !io::holds_orientation(o.output)) {
        image = upright(image, source->orientation);
        report.remarks.push_back("written upright, as the new file cannot say which way up it is");
        report.width = image.width;
        report.height = image.height;
    }
    report.lost = io::write_image(o.output, image,
                                  {.depth = depth,
                                   .alpha = image.alpha,
                                   .text = {{"Source", io::input_name(o.picture)}},
                                   .keep = source.get(),
                                   .keep_color = keeps_encoding(place)});
    print_report(o, report);
    return ok;
}

} // namespace

Run declare_apply(Verb& verb) {
    const auto o = std::make_shared<Options>();
    verb.add_option("LUT", o->lut, "a LUT of any format or a recipe, or - for standard input")
        .required();
    verb.add_option("PICTURE", o->picture, "PNG, EXR or another picture, or - for standard input")
        .required();
    verb.add_option("-o,--output", o->output,
                    "the picture to write, or - for a PNG to standard output")
        .required();
    verb.add_option("--depth", o->depth,
                    "uint8, uint16, half or float, as far as the file type holds it (default: the "
                    "nearest to the picture's own)");
    o->interpolation.declare(verb, "of the LUT's cube");
    verb.add_option(
        "--layer", o->layer,
        "the picture to grade in a file of several: a layer, or a part's name (default: "
        "R, G, B, else Combined, beauty or rgba, else the first)");
    std::string alpha_help = "how the picture's alpha stands to its colours:";
    for (const AlphaRule& rule : alpha_rules) {
        alpha_help += fmt::format(" {} ({}){}", rule.name, rule.help,
                                  &rule == &alpha_rules.back() ? "" : ",");
    }
    verb.add_option("--alpha", o->alpha, alpha_help).capture_default_str();
    verb.add_option("--picture-encoding", o->picture_encoding,
                    encoding_help("what the picture's codes are"));
    verb.add_option("--output-encoding", o->output_encoding,
                    "what the written picture's codes are to be (default: the picture's own where "
                    "the look keeps its encoding, else what the look gives)");
    o->placing.declare(verb);
    verb.add_flag("--json", o->json, "print the results as JSON");
    return [o, &verb] { return run(*o, verb); };
}

} // namespace converter
