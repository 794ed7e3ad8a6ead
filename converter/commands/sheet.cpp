// lutconv sheet: a picture under many looks, side by side and measured.
#include "converter/sheet.h"
#include "converter/command.h"
#include "converter/many.h"
#include "converter/many_looks.h"
#include "converter/options.h"
#include "converter/placing.h"
#include "converter/raster_file.h"
#include "converter/recipe_options.h"
#include "converter/replaceable.h"
#include "converter/report.h"
#include "converter/sheet_look.h"
#include "converter/sheet_tile.h"
#include "converter/side_by_side.h"
#include "converter/unused.h"
#include "converter/usage.h"
#include "lutlib/error.h"
#include "lutlib/io/alpha.h"
#include "lutlib/io/file.h"
#include "lutlib/io/image.h"
#include "lutlib/io/orientation.h"
#include "lutlib/limits.h"
#include "terminal/table.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <vector>

namespace converter {
namespace {

namespace io = lutlib::io;

constexpr int least_width = 16, most_width = 8192;
/// What is taken for a look while it is read: a lattice of 129 nodes a side, as text and as
/// numbers.
constexpr std::size_t bytes_of_look = std::size_t{100} << 20;

struct SheetOptions {
    std::string picture, output, picture_encoding, layer;
    std::vector<std::string> looks;
    EngineOption engine;
    PlacingOptions placing;
    int columns = 0, width = 480;
    bool json = false;
};

struct Sheet {
    io::FloatImage picture; ///< upright and straight
    lutlib::Encoding encoding;
    bool is_guessed = false; ///< the encoding
    std::vector<SheetLook> looks;
    std::vector<std::string> names; ///< of the looks
    std::vector<Tile> tiles;        ///< the original's first
    const lutlib::Engine* engine = nullptr;
    plot::Raster whole{0, 0, {}};
};

void require_output(const SheetOptions& o) {
    require_raster_name(o.output, "a sheet");
    if (o.width < least_width || o.width > most_width) {
        throw lutlib::UsageError(
            fmt::format("--width must be {} to {} pixels", least_width, most_width));
    }
    if (o.columns < 0 || o.columns > most_width) {
        throw lutlib::UsageError(fmt::format("--columns must be 1 to {}", most_width));
    }
}

io::FloatImage read_upright(const SheetOptions& o) {
    io::FloatImage out = io::read_image(o.picture, {.layer = o.layer});
    make_straight(out);
    const int orientation = out.source ? out.source->orientation : 1;
    return orientation > 1 ? upright(out, orientation) : out;
}

std::string file_name(const std::string& path) {
    return std::filesystem::path(io::input_name(path)).filename().string();
}

std::string encoding_text(const Sheet& sheet) {
    const std::string name = sheet.encoding.name();
    return name == lutlib::srgb().name() ? name : name + ", shown as " + lutlib::srgb().name();
}

std::string reader_text(const lutlib::Engine& engine) {
    return fmt::format("each look as {} reads {} nodes of {} bits", engine.name,
                       engine.default_size, engine.default_bits);
}

// The looks are told apart by their tiles; the original's is there anyway.
plot::Raster drawn(const SheetOptions& o, const Sheet& sheet, int columns) {
    std::vector<LabelledTile> labelled{
        {sheet.tiles.front().picture, "original", encoding_text(sheet)}};
    for (std::size_t i = 0; i < sheet.looks.size(); ++i) {
        const Tile& tile = sheet.tiles[i + 1];
        labelled.push_back({tile.picture, sheet.names[i],
                            fmt::format("dE2000 mean {:.2f}, p99 {:.2f}", tile.delta_e_2000.mean,
                                        tile.delta_e_2000.p99)});
    }
    return sheet_of(file_name(o.picture) + (sheet.engine ? ": " + reader_text(*sheet.engine) : ""),
                    labelled, columns);
}

// One line, however many they are.
void tell_left_out(const std::vector<std::string>& files) {
    constexpr std::size_t most = 5;
    if (files.empty()) {
        return;
    }
    std::string names;
    for (std::size_t i = 0; i < std::min(files.size(), most); ++i) {
        names += (names.empty() ? "" : ", ") + file_name(files[i]);
    }
    tell_remarks(std::array{fmt::format(
        "left out {} {} of folders that {} no look{}: {}{}", files.size(),
        files.size() == 1 ? "file" : "files", files.size() == 1 ? "is" : "are",
        files.size() == 1 ? "" : "s", names, files.size() > most ? " and others" : "")});
}

Sheet make_sheet(const SheetOptions& o, const std::vector<SheetSource>& sources) {
    Sheet out;
    out.engine = o.engine.given() ? &o.engine.get() : nullptr;
    out.picture = read_upright(o);
    const std::optional<lutlib::Encoding> said =
        o.picture_encoding.empty()
            ? io::encoding_of(out.picture)
            : std::optional(encoding_of(o.picture_encoding, "--picture-encoding"));
    out.encoding = said.value_or(lutlib::srgb());
    out.is_guessed = !said;
    const SheetPlace place{out.encoding, o.placing.look(), o.placing.convert(),
                           o.placing.adaptation(), out.engine};
    SheetLooks opened = open_sheet_looks(sources, place, pieces_at_once(bytes_of_look));
    tell_left_out(opened.left_out);
    out.looks = std::move(opened.looks);
    std::vector<std::string> files;
    for (const SheetLook& look : out.looks) {
        files.push_back(io::input_name(look.path));
    }
    out.names = short_names_of(files);

    const TileSize size = tile_size_of(out.picture, o.width);
    const std::size_t count = out.looks.size() + 1;
    const int columns = o.columns ? o.columns : usual_columns(count);
    if (sheet_pixels(size.width, size.height, count, columns) > lutlib::limits::max_image_pixels) {
        throw lutlib::UsageError(fmt::format("{} tiles of {}x{} pixels make too large a sheet: "
                                             "choose a smaller --width",
                                             count, size.width, size.height));
    }
    const lutlib::Transform original = shown_without_look(place);
    std::vector<lutlib::Transform> shown{original};
    for (const SheetLook& look : out.looks) {
        shown.push_back(look.shown);
    }
    out.tiles = make_tiles(out.picture, original, shown, size, sheet_ground,
                           pieces_at_once(bytes_of_tile(out.picture, size)));
    out.whole = drawn(o, out, columns);
    return out;
}

// What stands around the looks, a line each.
std::vector<std::string> sheet_remarks(const Sheet& sheet) {
    std::vector<std::string> out;
    if (sheet.is_guessed) {
        out.emplace_back("the picture's encoding is not known and taken for srgb: if it is "
                         "another, name it with --picture-encoding");
    }
    std::string unknown;
    for (std::size_t i = 0; i < sheet.looks.size(); ++i) {
        const SheetLook& look = sheet.looks[i];
        if (!look.said.input || !look.said.output) {
            unknown += (unknown.empty() ? "" : ", ") + one_line(sheet.names[i]);
        }
        if (look.placement.converts()) {
            out.push_back(one_line(sheet.names[i]) + ": " + look.placement.text());
        }
    }
    if (!unknown.empty()) {
        out.push_back("what a look does not say of its encodings is taken for srgb (name it with "
                      "--look-input and --look-output): " +
                      unknown);
    }
    return out;
}

void print_sheet_text(const SheetOptions& o, const Sheet& sheet) {
    const plot::Raster& tile = sheet.tiles.front().picture;
    std::string text = fmt::format("{} <- {} under {} {}\n  {}x{} pixels, tiles of {}x{}{}\n",
                                   output_text(o.output), input_text(o.picture), sheet.looks.size(),
                                   sheet.looks.size() == 1 ? "look" : "looks", sheet.whole.width(),
                                   sheet.whole.height(), tile.width(), tile.height(),
                                   sheet.engine ? "; " + reader_text(*sheet.engine) : "");
    for (const std::string& remark : sheet_remarks(sheet)) {
        text += "  " + remark + "\n";
    }
    terminal::Table table;
    table.heading(
        "dE2000 of the picture's pixels from the original, as an sRGB display shows both:");
    table.row({"look", "mean", "p99", "max"});
    for (std::size_t i = 0; i < sheet.looks.size(); ++i) {
        const lutlib::ErrorStats& error = sheet.tiles[i + 1].delta_e_2000;
        table.row({sheet.names[i], fmt::format("{:.2f}", error.mean),
                   fmt::format("{:.2f}", error.p99), fmt::format("{:.2f}", error.max)});
    }
    print(text + table.text(), o.output);
}

void print_sheet_json(const SheetOptions& o, const Sheet& sheet) {
    nlohmann::ordered_json looks = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < sheet.looks.size(); ++i) {
        looks.push_back({{"look", io::input_name(sheet.looks[i].path)},
                         {"name", sheet.names[i]},
                         {"delta_e_2000", to_json(sheet.tiles[i + 1].delta_e_2000)}});
    }
    const plot::Raster& tile = sheet.tiles.front().picture;
    print(nlohmann::ordered_json{{"picture", io::input_name(o.picture)},
                                 {"output", io::output_name(o.output)},
                                 {"picture_encoding", sheet.encoding.name()},
                                 {"engine", sheet.engine ? sheet.engine->name : ""},
                                 {"width", sheet.whole.width()},
                                 {"height", sheet.whole.height()},
                                 {"tile_width", tile.width()},
                                 {"tile_height", tile.height()},
                                 {"remarks", sheet_remarks(sheet)},
                                 {"looks", looks}},
          o.output);
}

int run_sheet(const SheetOptions& o, const Verb& verb) {
    std::vector<std::string> inputs = o.looks;
    inputs.push_back(o.picture);
    require_one_standard_input(inputs);
    require_output(o);
    std::vector<SheetSource> sources;
    for (const LookRoute& route : routes_of_looks(o.looks, "")) {
        sources.push_back({route.route.from.path, route.route.from.in_folder});
        inputs.push_back(route.route.from.path);
    }
    require_replaceable(o.output, inputs);
    const Sheet sheet = make_sheet(o, sources);
    Part adaptation{"--adaptation", false, ""};
    bool would_convert = false;
    for (const SheetLook& look : sheet.looks) {
        if (!adaptation.has_part) {
            adaptation = adaptation_part(look.placement);
        }
        would_convert = would_convert || look.would_convert;
    }
    tell_unused(verb, {adaptation, no_convert_part(would_convert)});
    write_raster(o.output, sheet.whole, io::input_name(o.picture));
    o.json ? print_sheet_json(o, sheet) : print_sheet_text(o, sheet);
    return ok;
}

} // namespace

Run declare_sheet(Verb& verb) {
    const auto o = std::make_shared<SheetOptions>();
    verb.add_option("PICTURE", o->picture, "PNG, EXR or another picture, or - for standard input")
        .required();
    verb.add_option("LOOKS", o->looks,
                    "LUTs of any format and recipes, or - for standard input; folders of them")
        .required();
    verb.add_output("-o,--output", o->output,
                    "the sheet, a picture of 8 bits in sRGB, or - for a PNG to standard output")
        .required();
    o->engine.declare(verb, "");
    verb.add_option("--columns", o->columns,
                    "tiles side by side (default: as many as below each other)")
        .takes(Takes::count);
    verb.add_option("--width", o->width,
                    "of a tile in pixels; no tile is wider than the picture is")
        .capture_default_str();
    verb.add_option("--layer", o->layer,
                    "the picture to take in a file of several: a layer, or a part's name");
    verb.add_option("--picture-encoding", o->picture_encoding,
                    encoding_help("what the picture's codes are") +
                        " (default: what the file says, else srgb)");
    o->placing.declare(verb);
    verb.add_flag("--json", o->json, "print the results as JSON");
    verb.footer("The picture without a look comes first; under each look stand its dE2000 from "
                "that, the mean and what 99 % of the pixels do not exceed. With --engine each look "
                "is shown as the lookup of that engine reads it, baked at its default size.");
    return [o, &verb] { return run_sheet(*o, verb); };
}

} // namespace converter
