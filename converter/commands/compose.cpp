// lutconv compose: looks one after the other, as one LUT.
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

#include <memory>

namespace converter {
namespace {

struct ComposeOptions {
    std::vector<std::string> inputs;
    NewLutOptions made;
};

// A look that gives other codes than the next one takes.
std::vector<std::string> mismatches(const std::vector<std::string>& paths,
                                    const std::vector<const lutlib::Lut*>& looks) {
    std::vector<std::string> out;
    for (std::size_t i = 0; i + 1 < looks.size(); ++i) {
        const auto given = encodings_of(looks[i]->encodings).output;
        const auto taken = encodings_of(looks[i + 1]->encodings).input;
        if (given && taken && *given != *taken) {
            out.push_back(fmt::format(
                "{} gives {} and {} takes {}; nothing converts between them: compose with the LUT "
                "of 'edit identity --input-encoding {} --output-encoding {}' in between",
                input_text(paths[i]), given->name(), input_text(paths[i + 1]), taken->name(),
                given->name(), taken->name()));
        }
    }
    return out;
}

int run_compose(const ComposeOptions& o, const Verb& verb) {
    if (o.inputs.size() < 2) {
        throw lutlib::UsageError("compose takes two looks or more, the first to apply first");
    }
    require_one_standard_input(o.inputs);
    const lutlib::Encoding encoding = o.made.results();
    const lutlib::ResamplingMethod& method = o.made.method.get();
    std::vector<std::shared_ptr<const lutlib::Lut>> looks;
    std::string order;
    for (const std::string& path : o.inputs) {
        looks.push_back(read_table(path));
        order += (order.empty() ? "" : ", then ") + input_text(path);
    }
    std::vector<const lutlib::Lut*> chain;
    for (const auto& look : looks) {
        chain.push_back(look.get());
    }
    const lutlib::Lut lut = compose(chain, o.made.sampling.sampling_of(chain), method);
    const bool any_cube = std::any_of(
        chain.begin(), chain.end(), [](const lutlib::Lut* look) { return look->cube.has_value(); });
    tell_unused(verb, {interpolation_part(any_cube), shaper_part(lut)});
    const double clamped = clamped_share(chain, method);
    std::vector<std::string> notes = mismatches(o.inputs, chain);
    if (const std::string chosen = o.made.sampling.choice_text(lut); !chosen.empty()) {
        notes.push_back(chosen);
    }
    if (clamped > 0) {
        notes.push_back(fmt::format("lost: {:.3g} % of the input's colours leave a later look's "
                                    "domain and are clamped to it",
                                    100 * clamped));
    }
    write_and_report(
        {lut, o.made.output, o.made.output, order, composition(chain, method), encoding, notes},
        o.made.json, {{"inputs", o.inputs}, {"clamped_share", clamped}});
    return ok;
}

} // namespace

Run declare_compose(Verb& verb) {
    const auto o = std::make_shared<ComposeOptions>();
    verb.add_option("LUT", o->inputs, "the looks; the first gets the input")
        .required()
        .expected(1, -1);
    o->made.declare(verb);
    verb.footer("compose A B -o C: C(x) = B(A(x)), on A's domain, with the largest size of all.");
    return [o, &verb] { return run_compose(*o, verb); };
}

} // namespace converter
