#include "converter/placing.h"
#include "converter/report.h"
#include "converter/verify_result.h"
#include "lutlib/io/bake_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace converter {
namespace {

namespace io = lutlib::io;

std::string texels_text(const lutlib::TexelCheck& t) {
    std::string out = fmt::format("  texels: {} of {} right", t.texels - t.wrong, t.texels);
    return out + (t.wrong == 0
                      ? "\n"
                      : fmt::format("; off by {} codes at most (at {},{}), {:.3g} on average\n",
                                    t.max_difference, t.worst.x, t.worst.y, t.mean_difference));
}

std::string diagnosis_text(const lutlib::Verification& result) {
    if (!result.diagnosis) {
        constexpr double worth_saying = 0.005;
        return "  why: no known mistake explains it; check that --against names the look it was "
               "baked from" +
               (result.nearest.explained < worth_saying
                    ? std::string()
                    : fmt::format(" (nearest: {}, {:.1f} % of the texels)", result.nearest.words,
                                  100 * result.nearest.explained)) +
               '\n';
    }
    const double explained = result.diagnosis->explained;
    return fmt::format(
        "  why: {}{}\n", result.diagnosis->words,
        explained > 0 ? fmt::format(" (explains {:.1f} % of the texels)", 100 * explained) : "");
}

std::string fitted_text(const lutlib::FittedCheck& check) {
    const auto figures = [](const lutlib::Difference& error) { return to_text(error.absolute); };
    std::string out =
        fmt::format("  the lattice is fitted, so its texels are not the look's values: {} of {} "
                    "are where a fit "
                    "made anew puts them\n"
                    "    over {} colours {}; the new fit {}; point samples {}\n",
                    check.texels - check.moved, check.texels, check.result.absolute.count,
                    figures(check.result), figures(check.refit), figures(check.point_sampled));
    for (const std::string& fault : check.faults) {
        out += "  why: " + fault + "\n";
    }
    return out;
}

std::string lookup_text(const Subject& s, const lutlib::Difference& error,
                        const lutlib::Viewing& viewing) {
    return fmt::format("  {}'s lookup ({}) against the look; p99 and mean over {} colours spread "
                       "evenly:\n{}",
                       s.engine->name, s.engine->lookup_help, error.absolute.count,
                       io::figures_text(error, viewing, "    "));
}

} // namespace

std::string ignored_text(const lutlib::LookPlace& place, const lutlib::Engine& engine) {
    lutlib::LookPlace left = place;
    left.convert = false;
    return sentence_of(left, engine.name) + ": bake it without --no-convert";
}

const NamedByWords& words_of(NamedBy by) {
    static constexpr std::array<NamedByWords, 3> table{{
        {NamedBy::option, "option", ""},
        {NamedBy::picture, "picture", ", the engine that the picture names"},
        {NamedBy::content, "content",
         ", which is what the content looks like; for another engine name it with --engine"},
    }};
    return *std::find_if(table.begin(), table.end(),
                         [by](const NamedByWords& row) { return row.by == by; });
}

std::string verdict_text(const Subject& s, const Verdict& v) {
    const std::string taken = !v.claimed.empty()     ? v.claimed
                              : v.place.is_unknown() ? v.place.given->name()
                                                     : "";
    const std::string unless =
        v.passed && !taken.empty() ? "; right if the look is made for " + taken : "";
    return fmt::format("{} as {} ({}){}{}", v.passed ? "passed" : "FAILED", s.engine->label,
                       s.engine->name, words_of(s.named_by).words, unless);
}

bool is_a_matter_of_tags(const Subject& s, const Verdict& v) {
    const bool right = v.result && (v.fitted ? v.fitted->right() : v.result->texels.wrong == 0);
    return right && s.contract.size() == 1 && s.contract.front() == s.tags;
}

std::string to_text(const Subject& s, const Verdict& v) {
    std::string out = fmt::format("{} against {}{} by {}\n", v.picture, v.against,
                                  !v.config.empty() ? " behind " + v.config : "", v.oracle);
    const std::string nodes = s.size > 0 ? fmt::format("{} nodes per axis, ", s.size) : "";
    out += fmt::format("  layout {}, {}x{}, {}{} bits: {}\n", s.engine->layout, s.codes.width,
                       s.codes.height, nodes, s.codes.depth.bits, s.engine->label);
    if (!v.refusal.empty()) {
        out += "  OpenColorIO evaluates what lutlib read of the look: " + v.refusal + "\n";
    }
    if (is_a_matter_of_tags(s, v)) {
        out += "  why: the texels are right; " + s.tags + "\n";
    }
    if (!v.scale.empty()) {
        out +=
            fmt::format("  {}\n  so OpenColorIO evaluates what lutlib read of the look\n", v.scale);
    }
    for (const std::string& point : s.contract) {
        if (!is_a_matter_of_tags(s, v)) {
            out += "  contract: " + point + "\n";
        }
    }
    if (v.place.is_wrong()) {
        out += "  encodings: " + sentence_of(v.place, s.engine->name) +
               ": --no-convert takes that as meant\n";
    } else if (const std::string said = sentence_of(v.place, s.engine->name); !said.empty()) {
        out += "  encodings: " + said + "\n";
    }
    if (!v.claimed.empty()) {
        out += "  the look does not say its encodings; " + v.claimed +
               " is what the picture's text says of it\n";
    }
    for (const std::string& note : s.notes) {
        out += "  note: " + note + "\n";
    }
    if (v.result) {
        out += texels_text(v.result->texels);
        if (v.fitted) {
            out += fitted_text(*v.fitted);
        } else if (v.result->texels.wrong > 0) {
            out += diagnosis_text(*v.result);
        }
        out += lookup_text(s, v.result->lookup, v.viewing);
    }
    return out + verdict_text(s, v) + "\n";
}

} // namespace converter
