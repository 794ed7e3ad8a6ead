// lutconv show: what a look does, or two, in figures.
#include "converter/command.h"
#include "converter/figure_json.h"
#include "converter/look_files.h"
#include "converter/options.h"
#include "converter/placing.h"
#include "converter/raster_file.h"
#include "converter/report.h"
#include "converter/sheet.h"
#include "converter/show_page.h"
#include "converter/unused.h"
#include "converter/usage.h"
#include "lutlib/error.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/extension.h"
#include "lutlib/io/file.h"
#include "lutlib/limits.h"
#include "lutlib/named.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <vector>

namespace converter {
namespace {

namespace io = lutlib::io;

constexpr int narrowest = 320, widest = 8192;

struct ShowOptions {
    std::vector<std::string> looks;
    std::string output, panels;
    LookEncodingOptions encodings;
    InterpolationOption interpolation;
    int size = 1920;
    bool json = false;
};

struct OpenedLooks {
    std::vector<ShownLook> looks;
    std::vector<lutlib::LookEncodings> said; ///< what is known of each
    bool has_lattice = false;
};

// A kind of file that figures go into.
struct ShowKind {
    std::string_view extension, what;
    void (*write)(const ShowOptions& o, const Shown& shown);
};

void write_as_page(const ShowOptions& o, const Shown& shown) {
    io::write_file(o.output, show_html(shown));
}

void write_as_svg(const ShowOptions& o, const Shown& shown) {
    constexpr int usual = 1920; // a drawing is as sharp at any size
    io::write_file(o.output, svg(show_drawing(shown, usual), o.size));
}

void write_as_picture(const ShowOptions& o, const Shown& shown) {
    const plot::Drawing drawing = show_drawing(shown, o.size);
    const auto pixels =
        static_cast<std::size_t>(o.size) * static_cast<std::size_t>(raster_height(drawing, o.size));
    if (pixels > lutlib::limits::max_image_pixels) {
        throw lutlib::UsageError(fmt::format("a picture {} pixels wide becomes too large: choose "
                                             "a smaller --size or fewer --panels",
                                             o.size));
    }
    write_raster(o.output, raster(drawing, o.size), shown.title);
}

constexpr std::array<ShowKind, 4> show_kinds{{
    {"html", "a page", write_as_page},
    {"htm", "a page", write_as_page},
    {"svg", "a drawing", write_as_svg},
    {"", "a picture", write_as_picture}, // any other
}};

const ShowKind& kind_of(const std::string& path) {
    const std::string extension = io::extension_of(path);
    const auto* const row =
        std::find_if(show_kinds.begin(), show_kinds.end() - 1,
                     [&](const ShowKind& kind) { return kind.extension == extension; });
    return *row;
}

std::vector<const Panel*> chosen_panels(const std::string& list) {
    if (list.empty()) {
        return {panels().begin(), panels().end()};
    }
    std::vector<const Panel*> out;
    for (const std::string& name : names_in_list(list)) {
        const Panel* const row = &lutlib::require_named(panels(), "panel", name);
        if (std::find(out.begin(), out.end(), row) == out.end()) {
            out.push_back(row);
        }
    }
    return out;
}

OpenedLooks open_looks(const ShowOptions& o) {
    OpenedLooks out;
    std::vector<std::string> files;
    for (const std::string& path : o.looks) {
        files.push_back(io::input_name(path));
    }
    const std::vector<std::string> names = short_names_of(files);
    for (std::size_t i = 0; i < o.looks.size(); ++i) {
        const io::Look look = open_look(
            o.looks[i], {.interpolation = o.interpolation.get(), .encodings = o.encodings.look()});
        const lutlib::LookEncodings said = look.encodings();
        out.said.push_back(said);
        out.has_lattice = out.has_lattice || has_lattice(look);
        out.looks.push_back({one_line(names[i]), look.exact(), look.domain(),
                             said.input.value_or(lutlib::srgb()),
                             said.output.value_or(lutlib::srgb())});
    }
    // The same file twice is one look by two interpolations' or encodings' names no more.
    if (out.looks.size() == 2 && out.looks[0].name == out.looks[1].name) {
        out.looks[1].name += " (2)";
    }
    return out;
}

// What each look takes and gives, and what of that is a guess.
std::vector<std::string> show_remarks(const OpenedLooks& opened) {
    std::vector<std::string> out;
    std::string unknown;
    for (std::size_t i = 0; i < opened.looks.size(); ++i) {
        const ShownLook& look = opened.looks[i];
        out.push_back(fmt::format("{}: {} to {}, input {}", look.name, look.input.name(),
                                  look.output.name(), io::domain_text(look.domain)));
        if (!opened.said[i].input || !opened.said[i].output) {
            unknown += (unknown.empty() ? "" : ", ") + look.name;
        }
    }
    if (!unknown.empty()) {
        out.push_back("what a look does not say of its encodings is taken for srgb (name it with "
                      "--look-input and --look-output): " +
                      unknown);
    }
    return out;
}

Shown shown_of(const std::vector<const Panel*>& chosen, const OpenedLooks& opened) {
    Shown out;
    for (const ShownLook& look : opened.looks) {
        out.title += (out.title.empty() ? "" : " and ") + look.name;
    }
    out.remarks = show_remarks(opened);
    for (const Panel* panel : chosen) {
        out.panels.push_back({panel, panel->figures(opened.looks)});
    }
    return out;
}

void print_show_text(const ShowOptions& o, const Shown& shown, const ShowKind& kind) {
    std::string names, text;
    for (const ShownPanel& panel : shown.panels) {
        names += (names.empty() ? "" : ", ") + std::string(panel.panel->name);
    }
    for (const std::string& look : o.looks) {
        text += (text.empty() ? "" : " and ") + input_text(look);
    }
    text = fmt::format("{} <- {}\n  {} of {}\n", output_text(o.output), text, kind.what, names);
    for (const std::string& remark : shown.remarks) {
        text += "  " + remark + "\n";
    }
    print(text, o.output);
}

void print_show_json(const ShowOptions& o, const OpenedLooks& opened, const Shown& shown) {
    nlohmann::ordered_json looks = nlohmann::ordered_json::array(), list = looks;
    for (std::size_t i = 0; i < opened.looks.size(); ++i) {
        const ShownLook& look = opened.looks[i];
        const lutlib::Domain& d = look.domain;
        looks.push_back({{"look", io::input_name(o.looks[i])},
                         {"name", look.name},
                         {"input", look.input.name()},
                         {"input_is_guessed", !opened.said[i].input},
                         {"output", look.output.name()},
                         {"output_is_guessed", !opened.said[i].output},
                         {"domain_min", {d.min.r, d.min.g, d.min.b}},
                         {"domain_max", {d.max.r, d.max.g, d.max.b}}});
    }
    for (const ShownPanel& panel : shown.panels) {
        nlohmann::ordered_json figures = nlohmann::ordered_json::array();
        for (const plot::Figure& figure : panel.figures) {
            figures.push_back(to_json(figure));
        }
        list.push_back({{"name", panel.panel->name},
                        {"label", panel.panel->label},
                        {"figures", std::move(figures)}});
    }
    print(nlohmann::ordered_json{{"looks", std::move(looks)}, {"panels", std::move(list)}},
          o.output);
}

int run_show(const ShowOptions& o, const Verb& verb) {
    require_one_standard_input(o.looks);
    if (o.output.empty() && !o.json) {
        throw lutlib::UsageError("show needs -o FILE to draw into, --json to print the numbers, "
                                 "or both");
    }
    if (o.size < narrowest || o.size > widest) {
        throw lutlib::UsageError(fmt::format("--size must be {} to {} pixels", narrowest, widest));
    }
    const std::vector<const Panel*> chosen = chosen_panels(o.panels);
    const ShowKind& kind = kind_of(o.output);
    if (!o.output.empty() && kind.write == write_as_picture) {
        require_raster_name(o.output, "what is neither .svg nor .html");
    }
    const OpenedLooks opened = open_looks(o);
    tell_unused(verb, {interpolation_part(opened.has_lattice),
                       {"--size", !o.output.empty() && kind.write != write_as_page,
                        "no picture is drawn; a page is as wide as its window"}});
    const Shown shown = shown_of(chosen, opened);
    if (!o.output.empty()) {
        kind.write(o, shown);
    }
    o.json ? print_show_json(o, opened, shown) : print_show_text(o, shown, kind);
    return ok;
}

std::string panel_list() {
    std::string out = "Panels:\n";
    for (const Panel* panel : panels()) {
        out += fmt::format("  {:<12} {}\n", panel->name, panel->label);
    }
    return out;
}

} // namespace

Run declare_show(Verb& verb) {
    const auto o = std::make_shared<ShowOptions>();
    verb.add_option("LOOKS", o->looks,
                    "a LUT or recipe file, or - for standard input; or two, on the same axes")
        .required()
        .expected(1, 2);
    verb.add_output("-o,--output", o->output,
                    "an .html page, an .svg drawing or a picture of 8 bits, such as .png; - is a "
                    "PNG to standard output");
    verb.add_option("--panels", o->panels,
                    "only these, with commas between: " + lutlib::names_of(panels()));
    verb.add_option("--size", o->size, "how many pixels wide a picture or drawing is")
        .capture_default_str();
    o->encodings.declare(verb);
    o->interpolation.declare(verb, "how LUTs are read between their nodes");
    verb.add_flag("--json", o->json, "print the numbers behind the panels as JSON");
    verb.footer(panel_list());
    return [o, &verb] { return run_show(*o, verb); };
}

} // namespace converter
