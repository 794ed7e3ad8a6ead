// lutconv blend: a mixture of two looks, as one LUT.
#include "converter/command.h"
#include "converter/look_files.h"
#include "converter/recipe_options.h"
#include "converter/report.h"
#include "converter/result.h"
#include "converter/unused.h"
#include "converter/usage.h"
#include "lutlib/error.h"
#include "lutlib/resample/combine.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <memory>

namespace converter {
namespace {

struct BlendOptions {
    std::string a, b;
    double amount = 0.5;
    NewLutOptions made;
};

std::string encodings_text(const lutlib::Lut& lut) {
    const auto name = [](const std::string& text) {
        return text.empty() ? std::string("unknown") : text;
    };
    return name(lut.encodings.input) + " to " + name(lut.encodings.output);
}

int run_blend(const BlendOptions& o, const Verb& verb) {
    if (!(std::abs(o.amount) <= 100)) {
        throw lutlib::UsageError("--amount must be a number from -100 to 100; 0 is the first look, "
                                 "1 the second");
    }
    require_one_standard_input(std::array{o.a, o.b});
    const lutlib::Encoding encoding = o.made.results();
    const lutlib::ResamplingMethod& method = o.made.method.get();
    const auto opened = [](const std::string& name) {
        return name == "identity" ? std::make_shared<const lutlib::Lut>() : read_table(name);
    };
    const auto a = opened(o.a), b = opened(o.b);
    const lutlib::Lut lut =
        blend(*a, *b, o.amount, o.made.sampling.sampling_of({a.get(), b.get()}), method);
    tell_unused(verb, {interpolation_part(a->cube || b->cube), shaper_part(lut)});
    const std::string made_of =
        fmt::format("{} and {:.4g} of {}", input_text(o.a), o.amount, input_text(o.b));
    std::vector<std::string> notes;
    if (const std::string chosen = o.made.sampling.choice_text(lut); !chosen.empty()) {
        notes.push_back(chosen);
    }
    if (a->encodings != b->encodings && a->encodings.any() && b->encodings.any()) {
        notes.push_back(fmt::format("the looks are made for other codes ({} and {}), which a blend "
                                    "does not convert; the result says only what they share",
                                    encodings_text(*a), encodings_text(*b)));
    }
    write_and_report({lut, o.made.output, o.made.output, made_of, mixture(*a, *b, o.amount, method),
                      encoding, notes},
                     o.made.json, {{"a", o.a}, {"b", o.b}, {"amount", o.amount}});
    return ok;
}

} // namespace

Run declare_blend(Verb& verb) {
    const auto o = std::make_shared<BlendOptions>();
    verb.add_option("A", o->a, "the look at amount 0, or the word identity").required();
    verb.add_option("B", o->b, "the look at amount 1, or the word identity").required();
    verb.add_option("--amount", o->amount, "share of B; beyond 0..1 extrapolates")
        .capture_default_str();
    o->made.declare(verb);
    return [o, &verb] { return run_blend(*o, verb); };
}

} // namespace converter
