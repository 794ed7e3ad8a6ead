// lutconv eval: colours through a LUT or a recipe, nine significant digits.
#include "converter/command.h"
#include "converter/look_files.h"
#include "converter/options.h"
#include "converter/report.h"
#include "converter/unused.h"
#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/text.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace converter {
namespace {

using lutlib::Rgb;

struct EvalOptions {
    std::string lut;
    InterpolationOption interpolation;
    bool json = false;
};

// NaN and infinities are inputs like any other here: a LUT defines what becomes of them.
float number(std::string_view word, const lutlib::Where& where) {
    float value = 0;
    const lutlib::NumberStatus status = lutlib::parse_float(word, value);
    if (status == lutlib::NumberStatus::not_finite) {
        const bool nan = word.find_first_of("nN") < word.find_first_of("iI");
        const bool negative = word.starts_with('-');
        return nan ? std::numeric_limits<float>::quiet_NaN()
                   : (negative ? -1.0F : 1.0F) * std::numeric_limits<float>::infinity();
    }
    if (status == lutlib::NumberStatus::not_a_number) {
        throw lutlib::Error("'" + std::string(word) + "' is not a number", where);
    }
    return value;
}

bool is_number(std::string_view word) {
    float ignored = 0;
    return lutlib::parse_float(word, ignored) != lutlib::NumberStatus::not_a_number;
}

std::vector<Rgb> from_arguments(const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        if (word.starts_with('-') && !is_number(word)) {
            throw lutlib::UsageError("there is no flag '" + word +
                                     "'; lutconv eval --help lists them");
        }
    }
    if (words.size() % 3 != 0) {
        throw lutlib::UsageError("expected groups of three numbers, R G B, got " +
                                 std::to_string(words.size()));
    }
    std::vector<Rgb> out;
    for (std::size_t i = 0; i < words.size(); i += 3) {
        try {
            out.push_back(
                {number(words[i], {}), number(words[i + 1], {}), number(words[i + 2], {})});
        } catch (const lutlib::Error& error) {
            throw lutlib::UsageError(error.message());
        }
    }
    return out;
}

std::vector<Rgb> from_standard_input() {
    std::vector<Rgb> out;
    std::string line;
    for (std::size_t n = 1; std::getline(std::cin, line); ++n) {
        if (!line.empty() && line.back() == '\r') {
            line.pop_back();
        }
        const lutlib::Words words = lutlib::words_of(line);
        if (words.count == 0) {
            continue;
        }
        const lutlib::Where where{"standard input", n, line};
        if (words.count != 3) {
            throw lutlib::Error("a colour is three numbers", where);
        }
        out.push_back({number(words.items[0], where), number(words.items[1], where),
                       number(words.items[2], where)});
    }
    return out;
}

int run_eval(const EvalOptions& o, const Verb& verb) {
    const std::vector<std::string> words = verb.words();
    if (o.lut == "-" && words.empty()) {
        throw lutlib::UsageError("the LUT and the colours cannot both come from standard input");
    }
    const lutlib::io::Look look = open_look(o.lut, {.interpolation = o.interpolation.get()});
    tell_unused(verb, {interpolation_part(has_lattice(look))});
    const lutlib::Transform exact = look.exact();
    const std::vector<Rgb> inputs = words.empty() ? from_standard_input() : from_arguments(words);
    const std::vector<lutlib::RgbD> outputs = images_of(exact, inputs);
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    std::string text;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const Rgb in = inputs[i], out = to_float(outputs[i]);
        if (o.json) {
            list.push_back({{"in", {in.r, in.g, in.b}}, {"out", {out.r, out.g, out.b}}});
        } else {
            text += fmt::format("{:.9g} {:.9g} {:.9g}\n", out.r, out.g, out.b);
        }
    }
    o.json ? print(list, "") : print(text, "");
    return ok;
}

} // namespace

Run declare_eval(Verb& verb) {
    const auto o = std::make_shared<EvalOptions>();
    verb.add_option("LUT", o->lut, "a LUT or recipe file, or - for standard input").required();
    o->interpolation.declare(verb, "how the cube is read between its nodes");
    verb.add_flag("--json", o->json, "print inputs and outputs as JSON");
    verb.allow_words();
    verb.footer("R G B...: colours; without any, lines of three numbers from standard input");
    return [o, &verb] { return run_eval(*o, verb); };
}

} // namespace converter
