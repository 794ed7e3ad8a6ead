// lutconv convert: a LUT from any format to any other, saying what the target cannot hold.
#include "converter/command.h"
#include "converter/explain.h"
#include "converter/look_files.h"
#include "converter/many_looks.h"
#include "converter/picture_facts.h"
#include "converter/placing.h"
#include "converter/report.h"
#include "converter/result.h"
#include "converter/subject.h"
#include "converter/unused.h"
#include "converter/usage.h"
#include "converter/watch.h"
#include "lutlib/error.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/describe.h"
#include "lutlib/io/file.h"
#include "lutlib/io/fit_format.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/formats/picture.h"
#include "lutlib/io/look.h"
#include "lutlib/limits.h"
#include "lutlib/resample/sample_lut.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <optional>

namespace converter {
namespace {

namespace io = lutlib::io;

struct ConvertOptions {
    std::vector<std::string> inputs;
    std::string output_template, from, format;
    std::string input, output; ///< of one look
    lutlib::WriteOptions save;
    PlacingOptions placing;
    WatchOption watch;
    int row = 0;
    bool strict = false, explain = false, json = false, strip_tags = false;
};

std::string format_list() {
    std::string out = "Formats:\n";
    for (const lutlib::FileFormat* const row : io::file_formats()) {
        const char* const ways = !row->write ? "read" : !row->read ? "write" : "read, write";
        out += fmt::format("  {:<18} {:<12} .{:<7} {}\n", row->name, ways, row->extensions.first(),
                           row->label);
    }
    return out;
}

const lutlib::FileFormat& target_of(const ConvertOptions& o, const lutlib::Lut& lut) {
    return o.format.empty() ? io::format_for_writing(o.output, lut)
                            : io::require_file_format(o.format);
}

// A name that nobody knows here is kept.
void take_names(const lutlib::LookPlace& place, lutlib::EncodingNames& names) {
    const lutlib::EncodingNames known = names_of(place.shown());
    names.input = known.input.empty() ? names.input : known.input;
    names.output = known.output.empty() ? names.output : known.output;
}

// What is known of the look's encodings goes into the file. A LUT picture is read by engines, which
// feed it what their rows say.
lutlib::LookPlace put_in_place(const ConvertOptions& o, const io::Look& look, lutlib::Lut& lut) {
    lutlib::LookPlace place{look.encodings(), {}, {}, o.placing.convert(), &o.placing.adaptation()};
    take_names(place, lut.encodings);
    const lutlib::FileFormat& format = target_of(o, lut);
    if (!format.layout) {
        return place;
    }
    place.given = place.wanted = lutlib::encoding_named(encoding_fed_through(*format.layout));
    const lutlib::Placement placement = place.applied();
    if (placement.converts()) {
        const int size = lutlib::formats::picture_cube_size(*format.layout, lut, o.save.size);
        lut.cube = lutlib::sample_cube(placement.around(look.exact()), {}, size);
        lut.shaper.reset();
        lut.interpolation.reset();
        take_names(place, lut.encodings);
    }
    return place;
}

// The look without what it does not need, where the format can hold that as it is; a file needs a
// table even of an identity. Returns what was left out.
std::optional<Explanation> leave_out(lutlib::Lut& lut, const ConvertOptions& o) {
    if (!o.explain) {
        return std::nullopt;
    }
    Explanation out = explain(lut, lutlib::SimplifyOptions{}.tolerance);
    lutlib::Lut less = out.simplified.lut;
    if (!less.shaper && !less.cube) {
        less.cube = lutlib::identity_cube(lutlib::limits::min_cube_size, lut.domain());
    }
    const lutlib::FileFormat& format = target_of(o, less);
    if (io::can_hold(less, format.holds)) {
        lut = std::move(less);
        out.left_out = true;
    } else {
        out.kept = fmt::format("{} cannot store it in that form", format.label);
    }
    return out;
}

nlohmann::ordered_json conversion_json(const ConvertOptions& o, const lutlib::FileFormat& format,
                                       const io::Encoded& file) {
    return {{"input", io::input_name(o.input)},
            {"output", io::output_name(o.output)},
            {"format", format.name},
            {"holds", io::shape_of(file.lut)},
            {"domain", io::domain_text(file.lut.domain())},
            {"losses", to_json(file.losses)}};
}

std::string as_text(const ConvertOptions& o, const lutlib::FileFormat& format,
                    const io::Encoded& file, const std::vector<std::string>& notes) {
    std::string out =
        fmt::format("{} -> {}\n  {}\n  {}, input {}\n", input_text(o.input), output_text(o.output),
                    format.layout ? fmt::format("PNG picture of layout {}", format.layout->name)
                                  : std::string(format.label),
                    io::shape_of(file.lut), io::domain_text(file.lut.domain()));
    for (const std::string& note : notes) {
        out += "  " + one_line(note) + '\n';
    }
    return out + (file.losses.empty() ? "  nothing was lost\n" : to_text(file.losses));
}

// The picture without the chunks that say how its codes are meant; everything else as it is.
int strip_tags(const ConvertOptions& o) {
    const std::string name = io::input_name(o.input);
    const std::string bytes = io::read_file(o.input);
    if (!io::is_png(bytes)) {
        throw lutlib::UsageError("--strip-tags takes PNG files; " + name + " is not one");
    }
    require_png_name(o.output, "convert --strip-tags");
    io::PngImage image = io::read_png(bytes, name);
    const std::vector<std::string_view> chunks = color_chunks(image);
    image.srgb_tag = false; // the others are never written
    io::write_file(o.output, io::write_png(image));
    std::string listed;
    for (const std::string_view chunk : chunks) {
        listed += (listed.empty() ? "" : ", ") + std::string(chunk);
    }
    if (o.json) {
        print({{"input", name}, {"output", io::output_name(o.output)}, {"removed", chunks}},
              o.output);
    } else {
        print(fmt::format("{} -> {}\n  removed: {}; texels and text are as they were\n",
                          input_text(o.input), output_text(o.output),
                          listed.empty() ? "nothing" : listed),
              o.output);
    }
    return ok;
}

// What becomes of a look, before any of it is written or printed.
struct Converted {
    lutlib::LookPlace place;
    std::optional<Explanation> explanation;
    const lutlib::FileFormat* format = nullptr;
    io::Encoded file; ///< with the losses of the reading before its own
    std::vector<std::string> notes;
};

std::vector<lutlib::Loss> losses_before(const io::Look& look, const io::LookTable& table,
                                        const lutlib::Placement& placement) {
    std::vector<lutlib::Loss> out;
    for (const io::LookFile& read : look.files()) {
        out.insert(out.end(), read.losses.begin(), read.losses.end());
    }
    out.insert(out.end(), table.losses.begin(), table.losses.end());
    if (const io::Reach reach = io::reach_of(look.domain(), placement);
        placement.before && reach.reached < 1) {
        out.push_back({"inputs beyond what the engine feeds: of the look's domain " +
                           io::domain_text(reach.domain) + " it reaches",
                       100 * reach.reached, "%"});
    }
    return out;
}

std::vector<std::string> notes_of(const io::Look& look, const io::Encoded& file,
                                  const lutlib::FileFormat& format,
                                  const lutlib::LookPlace& place) {
    std::vector<std::string> out;
    for (const io::LookFile& read : look.files()) {
        out.insert(out.end(), read.remarks.begin(), read.remarks.end());
        for (const std::string& keyword : read.keywords) {
            out.push_back("not acted on: " + keyword);
        }
    }
    out.insert(out.end(), file.readers.begin(), file.readers.end());
    if (format.layout) {
        out.push_back(takers_text(takers_of(io::read_png(file.bytes, "the picture"), *format.layout,
                                            file.lut.cube->size)));
    }
    if (const std::string said = sentence_of(place, "an engine that reads this layout");
        !said.empty()) {
        out.push_back("encodings: " + said);
    }
    return out;
}

Converted converted(const ConvertOptions& o, const io::Look& look) {
    const io::LookTable table = look.table(o.save.size);
    lutlib::Lut lut = *table.lut;
    Converted out;
    out.place = put_in_place(o, look, lut);
    out.explanation = leave_out(lut, o);
    out.format = &target_of(o, lut);
    out.file = io::encode_lut(lut, *out.format, o.save);
    const std::vector<lutlib::Loss> before = losses_before(look, table, out.place.applied());
    out.file.losses.insert(out.file.losses.begin(), before.begin(), before.end());
    out.notes = notes_of(look, out.file, *out.format, out.place);
    return out;
}

// Throws Error for the first of them that counts.
void refuse(const std::vector<lutlib::Loss>& losses, const std::string& output) {
    const auto counts = [](const lutlib::Loss& loss) { return !is_float_rounding(loss); };
    const auto first = std::find_if(losses.begin(), losses.end(), counts);
    if (first == losses.end()) {
        return;
    }
    const auto more = std::count_if(first, losses.end(), counts) - 1;
    throw lutlib::Error("--strict: not written, because this would be lost: " + loss_text(*first) +
                            (more > 0 ? fmt::format(" (and {} more)", more) : ""),
                        {io::output_name(output), 0, {}});
}

// Of what is lost, how far the file's colours are from the look's.
lutlib::Difference error_of(const io::Look& look, const Converted& made) {
    const lutlib::Placement placement = made.place.applied();
    const WrittenLook written = written_as(*made.format, made.file);
    const lutlib::Domain domain = placement.converts() ? written.lut->domain() : look.domain();
    return measure(
        placement.around(look.exact()), written.read,
        error_samples(domain, united(io::placed(look.breaks(), placement), written.breaks)),
        made.place.shown().output.value_or(lutlib::srgb()));
}

void print_conversion(const ConvertOptions& o, const Converted& made,
                      const std::optional<lutlib::Difference>& error) {
    if (!o.json) {
        print(as_text(o, *made.format, made.file, made.notes) +
                  (error ? figures_of_file(made.file.losses, *error) : "") +
                  (made.explanation ? to_text(*made.explanation) : ""),
              o.output);
        return;
    }
    nlohmann::ordered_json json = conversion_json(o, *made.format, made.file);
    if (error) {
        json["error"] = to_json(*error);
    }
    json["notes"] = made.notes;
    json["encodings"] = to_json(made.place);
    if (made.explanation) {
        json["explanation"] = to_json(*made.explanation);
    }
    print(json, o.output);
}

void tell_unused_beside_tags(const Verb& verb) {
    const std::string why_not = "--strip-tags keeps every texel";
    tell_unused(verb, {{"--bits", false, why_not},
                       {"--look-input", false, why_not},
                       {"--look-output", false, why_not},
                       {"--adaptation", false, why_not},
                       {"--no-convert", false, why_not},
                       {"--strict", false, why_not}});
}

int convert_one(const ConvertOptions& o, const Verb& verb) {
    if (o.strip_tags) {
        tell_unused_beside_tags(verb);
        return strip_tags(o);
    }
    const io::Look look =
        open_quietly(o.input, {.format = o.from, .row = o.row, .encodings = o.placing.look()});
    const Converted made = converted(o, look);
    tell_unused(verb, {{"--bits", made.format->picture, "the file is no picture"},
                       {"--size", made.file.lut.cube.has_value(), "the file holds a curve"},
                       {"--title", made.format->holds.title, "this format holds no title"},
                       {"--row", look.kind().layout != nullptr, "the look is no picture"},
                       adaptation_part(made.place.applied()),
                       no_convert_part(made.place)});
    if (o.strict) {
        refuse(made.file.losses, o.output);
    }
    io::write_file(o.output, made.file.bytes);
    print_conversion(o, made,
                     made.file.losses.empty() ? std::nullopt : std::optional(error_of(look, made)));
    return ok;
}

int convert_route(const ConvertOptions& o, const LookRoute& route, const Verb& verb) {
    ConvertOptions one = o;
    one.input = route.route.from.path;
    one.output = route.route.to;
    return convert_one(one, verb);
}

std::vector<WatchedWork> watched_conversions(const ConvertOptions& o, const Verb& verb) {
    std::vector<WatchedWork> out;
    for (const LookRoute& route : routes_of_looks(o.inputs, o.output_template)) {
        out.push_back({{route.route.from.path}, route.route.to, [&o, &verb, route] {
                           return convert_route(o, route, verb);
                       }});
    }
    return out;
}

int run_convert(const ConvertOptions& o, const Verb& verb) {
    if (o.watch.given()) {
        o.watch.run(o.inputs, o.output_template, [&] { return watched_conversions(o, verb); });
    }
    return run_over(routes_of_looks(o.inputs, o.output_template),
                    [&](const LookRoute& route) { return convert_route(o, route, verb); });
}

} // namespace

Run declare_convert(Verb& verb) {
    const auto o = std::make_shared<ConvertOptions>();
    verb.add_option("LUTS", o->inputs,
                    "LUTs of any format or recipes, or - for standard input; folders of them")
        .required();
    verb.add_output("-o,--output", o->output_template,
                    "the file to write, or - for standard output; of several looks a name with "
                    "{name} in it",
                    OutputName::is_template)
        .required();
    verb.add_option("--from", o->from, "the input's format (default: recognised)");
    verb.add_option("--row", o->row,
                    "which of the lattices stacked in a picture, from the top (ReShade's multi-LUT "
                    "files)")
        .takes(Takes::count)
        .capture_default_str();
    verb.add_option("--format", o->format, "the output's format (default: by its extension)");
    verb.add_option("--size", o->save.size,
                    "lattice size: nodes per axis (default: the input's, or 65 for a new cube)")
        .takes(Takes::cube_size);
    verb.add_option("--bits", o->save.bits, "bits per sample of a picture: 8 or 16")
        .takes(Takes::picture_bits)
        .capture_default_str();
    o->placing.declare(verb);
    verb.add_option("--title", o->save.title, "title to write instead of the input's");
    verb.add_flag("--strict", o->strict,
                  "write nothing, and exit with status 2, if anything would be lost but the "
                  "rounding of floats (1e-6)");
    verb.add_flag("--explain", o->explain,
                  "drop what the look does not need, and list it with the error bound");
    verb.add_flag("--strip-tags", o->strip_tags,
                  "only rewrite a PNG without its chunks sRGB, gAMA, cHRM and iCCP, by which some "
                  "engines convert the codes; every texel stays as it is")
        .excludes({"--from", "--row", "--format", "--size", "--title", "--explain"});
    verb.add_flag("--json", o->json, "print the results as JSON");
    o->watch.declare(verb);
    verb.footer(format_list());
    return [o, &verb] { return run_convert(*o, verb); };
}

} // namespace converter
