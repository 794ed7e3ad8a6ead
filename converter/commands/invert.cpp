// lutconv invert: a LUT that undoes a look, and what of the look cannot be undone.
#include "converter/command.h"
#include "converter/look_files.h"
#include "converter/recipe_options.h"
#include "converter/report.h"
#include "converter/result.h"
#include "converter/unused.h"
#include "converter/usage.h"
#include "lutlib/error.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/limits.h"
#include "lutlib/metrics/compare.h"
#include "lutlib/named.h"
#include "lutlib/resample/invert_closely.h"
#include "lutlib/resample/invert_shaper.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <array>
#include <memory>
#include <optional>

namespace converter {
namespace {

constexpr std::array channel_names{"red", "green", "blue"};

struct InvertOptions {
    std::string input, output;
    int size = 0, shaper_size = 0;
    std::vector<std::string> domain;
    std::string outside = std::string(lutlib::outside_choices()[1].name), shaper, gives;
    bool json = false;
};

// How near look and inverse, one after the other, come to changing nothing.
struct RoundTrip {
    lutlib::Viewing viewing;  ///< of the look's inputs
    lutlib::Difference whole; ///< over all of them
    std::optional<lutlib::Difference> undoable;
};

RoundTrip measured(const lutlib::Lut& look, const lutlib::Inversion& inversion,
                   const WrittenLook& written, const lutlib::Viewing& viewing) {
    const lutlib::Transform both = lutlib::in_sequence(
        {lutlib::Transform::of(look, lutlib::Interpolation::tetrahedral), written.read});
    // Where the inverse bends, as inputs of the look, is not known.
    const lutlib::Breaks breaks = united(breaks_of(look), lutlib::no_breaks());
    RoundTrip out{
        viewing, measure({}, both, lutlib::error_samples(look.domain(), breaks), viewing), {}};
    if (!inversion.undoable.empty() && inversion.inputs.undoable < 1) {
        out.undoable = compare({}, both, inversion.undoable, viewing);
        for (lutlib::ErrorStats* stats :
             {&out.undoable->absolute, &out.undoable->delta_e_2000, &out.undoable->delta_e_itp}) {
            stats->at = inversion.undoable[stats->worst];
            stats->largest_seen = true;
        }
    }
    return out;
}

nlohmann::ordered_json region_json(const lutlib::InverseRegion& region, std::size_t nodes) {
    return {{"nodes", region.count},
            {"share", static_cast<double>(region.count) / static_cast<double>(nodes)},
            {"low", {region.low.r, region.low.g, region.low.b}},
            {"high", {region.high.r, region.high.g, region.high.b}},
            {"worst", {region.worst.r, region.worst.g, region.worst.b}},
            {"extent", region.extent}};
}

std::string region_text(const char* what, const char* extent, const lutlib::InverseRegion& region,
                        std::size_t nodes) {
    if (region.count == 0) {
        return fmt::format("  {}: none\n", what);
    }
    return fmt::format("  {}: {:.3g} % of the nodes ({}), within {} to {}; worst {}, {} {:.4g}\n",
                       what, 100 * static_cast<double>(region.count) / static_cast<double>(nodes),
                       region.count, color_text(to_double(region.low)),
                       color_text(to_double(region.high)), color_text(to_double(region.worst)),
                       extent, region.extent);
}

std::string cube_text(const lutlib::Inversion& inversion) {
    const lutlib::InputShares& inputs = inversion.inputs;
    return fmt::format("  {} nodes per axis, input {}{}\n"
                       "  of the look's inputs {:.4g} % can be undone, {:.4g} % are flat (their "
                       "neighbours give the same), {:.4g} % folded (others do)\n",
                       inversion.lut.cube->size, lutlib::io::domain_text(inversion.lut.domain()),
                       inversion.lut.shaper
                           ? fmt::format(", behind a 1D table of {} entries, for readers of both "
                                         "(--shaper none: no table)",
                                         inversion.lut.shaper->size())
                           : "",
                       100 * inputs.undoable, 100 * inputs.flat, 100 * inputs.folded) +
           region_text("outside the look's gamut: no input gives these colours, so the nearest "
                       "reachable one is used",
                       "distance", inversion.out_of_gamut, inversion.nodes) +
           region_text("flat: a range of inputs gives these colours, so the one nearest to the "
                       "colour itself is used",
                       "it lies away by", inversion.flat, inversion.nodes) +
           (inversion.extrapolated > 0
                ? fmt::format("  {} nodes of both kinds go on from the colours beside them that "
                              "can be undone, so that those are right (--outside nearest: none)\n",
                              inversion.extrapolated)
                : "") +
           region_text("folded: several inputs give these colours, so the nearest of them is used",
                       "the inputs differ by", inversion.folded, inversion.nodes);
}

using Channels = std::array<lutlib::CurveInversion::Channel, 3>;

std::string three(const Channels& channels, double lutlib::CurveInversion::Channel::*member) {
    return fmt::format("{:.4g}, {:.4g}, {:.4g}", channels[0].*member, channels[1].*member,
                       channels[2].*member);
}

std::string curve_text(const lutlib::Lut& inverse, const Channels& channels) {
    using Channel = lutlib::CurveInversion::Channel;
    std::string out = fmt::format(
        "  a 1D table of {} entries, input {}\n"
        "  slope of red, green, blue at its low end {}; at its high end {}; held beyond both\n",
        inverse.shaper->size(), lutlib::io::domain_text(inverse.domain()),
        three(channels, &Channel::slope_low), three(channels, &Channel::slope_high));
    for (std::size_t c = 0; c < 3; ++c) {
        const Channel& channel = channels[c];
        if (channel.flat > 0) {
            out += fmt::format("  lost: {} is flat over {:.4g} units of input; of the inputs that "
                               "give one value the inverse takes the nearest to it\n",
                               channel_names[c], channel.flat);
        }
        if (channel.turned > 0) {
            out += fmt::format("  lost: {} turns back over {:.4g} units of input, by {:.4g} at "
                               "most; of several inputs the inverse takes the first\n",
                               channel_names[c], channel.turned, channel.depth);
        }
    }
    return out;
}

nlohmann::ordered_json curve_json(const Channels& channels) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const auto& channel : channels) {
        out.push_back({{"flat", channel.flat},
                       {"turned", channel.turned},
                       {"depth", channel.depth},
                       {"slope_low", channel.slope_low},
                       {"slope_high", channel.slope_high}});
    }
    return out;
}

// Why the inverse has the size that it has, where nobody said.
std::string choice_text(const lutlib::ClosestInversion& found) {
    if (found.attempts.empty()) {
        return "";
    }
    std::string out = "  dE2000 p99 of the round trip is";
    const char* between = "";
    for (const auto& [size, p99, shaper] : found.attempts) {
        out += fmt::format(
            "{} {:.3g} with {} nodes per axis{}", between, p99, size,
            shaper == lutlib::outputs_shaper ? " behind a 1D table by the look's outputs" : "");
        between = ",";
    }
    return out + (found.kept ? fmt::format("; {:g} is aimed at\n", lutlib::RoundTripAim().p99)
                             : fmt::format("; {:g} is aimed at and not reached, so the nearest is "
                                           "taken; --size and --shaper choose another\n",
                                           lutlib::RoundTripAim().p99));
}

nlohmann::ordered_json choice_json(const lutlib::ClosestInversion& found) {
    nlohmann::ordered_json attempts = nlohmann::ordered_json::array();
    for (const auto& [size, p99, shaper] : found.attempts) {
        attempts.push_back(
            {{"size", size}, {"p99", p99}, {"shaper", shaper.empty() ? "none" : shaper}});
    }
    return {
        {"aimed_at_p99", lutlib::RoundTripAim().p99}, {"kept", found.kept}, {"attempts", attempts}};
}

nlohmann::ordered_json inversion_json(const InvertOptions& o, const lutlib::Inversion& inversion) {
    nlohmann::ordered_json out{{"input", o.input}, {"output", o.output}};
    if (inversion.curve) {
        out["entries"] = inversion.lut.shaper->size();
        out["channels"] = curve_json(*inversion.curve);
    } else {
        out["size"] = inversion.lut.cube->size;
        out["shaper_size"] = inversion.lut.shaper ? inversion.lut.shaper->size() : 0;
        out["nodes"] = inversion.nodes;
        out["out_of_gamut"] = region_json(inversion.out_of_gamut, inversion.nodes);
        out["extrapolated"] = inversion.extrapolated;
        out["flat"] = region_json(inversion.flat, inversion.nodes);
        out["folded"] = region_json(inversion.folded, inversion.nodes);
        out["inputs"] = {{"undoable", inversion.inputs.undoable},
                         {"flat", inversion.inputs.flat},
                         {"folded", inversion.inputs.folded}};
    }
    return out;
}

lutlib::Outside outside_of(const std::string& name) {
    return lutlib::require_named(lutlib::outside_choices(), "choice of --outside", name).kind;
}

// Whether a file of this name keeps a 1D table before a cube.
bool keeps_shaper(const std::string& output) {
    lutlib::Lut both;
    both.cube = lutlib::identity_cube(lutlib::limits::min_cube_size);
    both.shaper = lutlib::Lut1D{{}, {{0, 0, 0}, {1, 1, 1}}};
    return lutlib::io::format_for_writing(output, both).holds.curve_and_cube;
}

void take_shaper(const InvertOptions& o, const lutlib::Lut& look, lutlib::InvertOptions& options) {
    options.shaper = o.shaper.empty() && !keeps_shaper(o.output) ? "none" : o.shaper;
    const bool shapes = !o.shaper.empty() && o.shaper != "none";
    if (shapes && !look.cube) {
        throw lutlib::UsageError(
            "--shaper stands before a cube, and the inverse of a 1D table is a "
            "1D table; drop --shaper");
    }
    if (shapes && o.shaper != lutlib::outputs_shaper && !lutlib::transfer_curve_named(o.shaper)) {
        std::vector<std::string_view> names = lutlib::name_list(lutlib::transfer_curves());
        names.insert(names.begin(), {"none", lutlib::outputs_shaper});
        lutlib::refuse_name("shaper", o.shaper, names);
    }
    if (o.shaper_size) {
        if (!shapes) {
            throw lutlib::UsageError("--shaper-size needs a --shaper that makes a table");
        }
        options.shaper_size = o.shaper_size;
    }
    // The codes that the inverse gets are those that the look gives.
    options.input = !o.gives.empty()
                        ? encoding_of(o.gives, "--encoding")
                        : lutlib::encoding_named(look.encodings.output).value_or(lutlib::srgb());
}

int run_invert(const InvertOptions& o, const Verb& verb) {
    lutlib::InvertOptions options;
    if (o.size) {
        options.size = o.size;
    }
    if (!o.domain.empty()) {
        options.domain = domain_of(o.domain);
    }
    options.outside = outside_of(o.outside);
    const auto look = read_table(o.input);
    if (look->cube && o.size > lutlib::limits::max_cube_size) {
        throw lutlib::UsageError(fmt::format(
            "--size {} is for curves; the inverse of a cube takes {} to {} nodes per axis", o.size,
            lutlib::limits::min_cube_size, lutlib::limits::max_cube_size));
    }
    take_shaper(o, *look, options);
    tell_unused(verb, {{"--outside", look->cube.has_value(), "the inverse of a curve is a curve"},
                       {"--encoding", lutlib::transfer_curve_named(o.shaper) != nullptr,
                        "it is what the curve of a --shaper is fed"}});
    const lutlib::Viewing viewing{
        lutlib::encoding_named(look->encodings.input).value_or(lutlib::srgb())};
    const lutlib::ClosestInversion found = invert_closely(*look, options, viewing);
    const lutlib::Inversion& inversion = found.inversion;
    const WrittenLook written = write_look(inversion.lut, o.output);
    const RoundTrip trip = measured(*look, inversion, written, viewing);
    if (o.json) {
        nlohmann::ordered_json json = inversion_json(o, inversion);
        if (!found.attempts.empty()) {
            json["size_choice"] = choice_json(found);
        }
        json["losses"] = to_json(written.losses);
        json["viewing"] = to_json(trip.viewing);
        json["round_trip"] = to_json(trip.whole);
        if (trip.undoable) {
            json["round_trip_undoable"] = to_json(*trip.undoable);
        }
        print(json, o.output);
        return ok;
    }
    std::string text =
        fmt::format("{} <- inverse of {}\n", output_text(o.output), input_text(o.input));
    text += inversion.curve ? curve_text(inversion.lut, *inversion.curve) : cube_text(inversion);
    text += choice_text(found) + to_text(written.losses);
    text += fmt::format("  the look, then {}, against changing nothing; p99 and mean over "
                        "{} colours spread evenly; as colours of {}\n{}",
                        written.losses.empty() ? "its inverse" : "the file as it is read",
                        trip.whole.absolute.count, lutlib::io::text_of(trip.viewing),
                        to_text(trip.whole, "    "));
    if (viewing.output.decode(1) > 1) {
        text +=
            fmt::format("    note: dE2000 means little above diffuse white, and {} goes to {:.3g} "
                        "times that\n",
                        viewing.output.name(), viewing.output.decode(1));
    }
    if (trip.undoable) {
        text += fmt::format(
            "  the same over {} inputs that can be undone, of a sample of their own\n{}",
            trip.undoable->absolute.count, to_text(*trip.undoable, "    "));
    }
    print(text, o.output);
    return ok;
}

} // namespace

Run declare_invert(Verb& verb) {
    const auto o = std::make_shared<InvertOptions>();
    verb.add_option("LUT", o->input, "a LUT or recipe file, or - for standard input").required();
    verb.add_output("-o,--output", o->output, "the inverse, or - for standard output").required();
    verb.add_option(
            "--size", o->size,
            fmt::format(
                "lattice size of the inverse: nodes per axis (default: the look's, or up to {} "
                "nodes, or {} where that promises to do, while dE2000 p99 of the round trip is "
                "else above {:g}); of a curve, which stays a curve, entries (default: as many as "
                "it needs)",
                lutlib::RoundTripAim().largest, lutlib::RoundTripAim().furthest,
                lutlib::RoundTripAim().p99))
        .takes(Takes::shaper_size);
    verb.add_option("--domain", o->domain,
                    "colours to invert: minimum and maximum, each a number or \"r,g,b\" (default: "
                    "0..1, widened to the look's; of a curve its own)")
        .expected(2);
    std::string choices;
    for (const lutlib::OutsideInfo& row : lutlib::outside_choices()) {
        choices += fmt::format("{}{}, {}", choices.empty() ? "" : "; ", row.name, row.help);
    }
    verb.add_option("--outside", o->outside,
                    "where no input of the look gives a colour: " + choices)
        .capture_default_str();
    verb.add_option("--shaper", o->shaper,
                    "1D table before the inverse's cube: none; look, which puts the nodes where "
                    "the look's outputs crowd; or a curve of `lutconv encodings`, such as log for "
                    "an inverse that is fed light (default: none, or look where that comes nearer "
                    "and the file holds it)");
    verb.add_option("--shaper-size", o->shaper_size, "entries of that table (default 4096)")
        .takes(Takes::shaper_size);
    verb.add_option("--encoding", o->gives,
                    encoding_help("what the look gives, for --shaper (default: as its file says, "
                                  "else srgb)"));
    verb.add_flag("--json", o->json, "print the results as JSON");
    return [o, &verb] { return run_invert(*o, verb); };
}

} // namespace converter
