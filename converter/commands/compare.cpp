// lutconv compare: how far apart two looks are, and where most.
#include "lutlib/metrics/compare.h"
#include "converter/command.h"
#include "converter/look_files.h"
#include "converter/options.h"
#include "converter/recipe_options.h"
#include "converter/report.h"
#include "converter/result.h"
#include "converter/unused.h"
#include "converter/usage.h"
#include "lutlib/error.h"
#include "lutlib/io/bake_report.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

namespace converter {
namespace {

struct CompareOptions {
    std::string a, b, encoding;
    double reference_white = lutlib::reference_white_nits;
    InterpolationOption interpolation;
    int samples = 100000;
    double max_delta_e = -1; ///< below 0: no limit
    std::vector<std::string> domain;
    bool json = false;
};

lutlib::Domain united(const lutlib::Domain& a, const lutlib::Domain& b) {
    lutlib::Domain out = a;
    for (std::size_t c = 0; c < 3; ++c) {
        out.min[c] = std::min(a.min[c], b.min[c]);
        out.max[c] = std::max(a.max[c], b.max[c]);
    }
    return out;
}

struct Compared {
    lutlib::Transform exact;
    lutlib::Domain domain;
    lutlib::Breaks breaks;
    std::optional<lutlib::Encoding> output;
    bool lattice = false;
};

Compared opened_for_compare(const std::string& name, const CompareOptions& o) {
    if (name == "identity") {
        return {};
    }
    const lutlib::io::Look look = open_look(name, {.interpolation = o.interpolation.get()});
    return {look.exact(), look.domain(), look.breaks(), look.encodings().output, has_lattice(look)};
}

std::string limit_text(const CompareOptions& o, const lutlib::ErrorStats& error) {
    return o.max_delta_e < 0 ? ""
           : error.max <= o.max_delta_e
               ? fmt::format("within dE2000 {:g}\n", o.max_delta_e)
               : fmt::format("FAILED: dE2000 {:.4g} is above {:g}\n", error.max, o.max_delta_e);
}

int run_compare(const CompareOptions& o, const Verb& verb) {
    if (o.samples < 1 || o.samples > 100000000) {
        throw lutlib::UsageError("--samples must be a number from 1 to 100000000");
    }
    require_one_standard_input(std::array{o.a, o.b});
    const Compared a = opened_for_compare(o.a, o), b = opened_for_compare(o.b, o);
    tell_unused(verb, {interpolation_part(a.lattice || b.lattice)});
    lutlib::Domain domain = united(a.domain, b.domain);
    if (!o.domain.empty()) {
        domain = domain_of(o.domain);
    }
    const lutlib::Viewing viewing{o.encoding.empty()
                                      ? a.output.value_or(b.output.value_or(lutlib::srgb()))
                                      : encoding_of(o.encoding, "--encoding"),
                                  o.reference_white};
    const lutlib::ErrorSamples samples = error_samples(
        domain, united(a.breaks, b.breaks), {.even = static_cast<std::size_t>(o.samples)});
    const lutlib::Difference d = measure(a.exact, b.exact, samples, viewing);
    const bool within = o.max_delta_e < 0 || d.delta_e_2000.max <= o.max_delta_e;
    const int exit_code = within ? ok : verification_failed;
    if (o.json) {
        nlohmann::ordered_json out{
            {"a", o.a}, {"b", o.b}, {"samples", o.samples}, {"viewing", to_json(viewing)}};
        out.update(to_json(d));
        if (o.max_delta_e >= 0) {
            out["max_delta_e"] = {{"limit", o.max_delta_e}, {"kept", within}};
        }
        print(out, "");
        return exit_code;
    }
    print(fmt::format("{} against {} over {}; p99 and mean over {} colours spread evenly\n"
                      "  as colours of {}\n{}{}",
                      input_text(o.a), input_text(o.b), lutlib::io::domain_text(domain), o.samples,
                      lutlib::io::text_of(viewing), to_text(d, "  "),
                      limit_text(o, d.delta_e_2000)),
          "");
    return exit_code;
}

} // namespace

Run declare_compare(Verb& verb) {
    const auto o = std::make_shared<CompareOptions>();
    verb.add_option("A", o->a, "a LUT or recipe file, or the word identity").required();
    verb.add_option("B", o->b, "the other, or the word identity").required();
    o->interpolation.declare(verb, "how LUTs are read between their nodes");
    verb.add_option(
        "--encoding", o->encoding,
        encoding_help("encoding of the looks' outputs, for colour differences (default: "
                      "what they say, else srgb)"));
    declare_reference_white(verb, o->reference_white);
    verb.add_option("--samples", o->samples,
                    "colours spread evenly over the domain, for the mean and the percentiles")
        .capture_default_str();
    verb.add_option("--domain", o->domain,
                    "inputs to compare on: minimum and maximum (default: both looks' domains)")
        .expected(2);
    verb.add_option("--max-delta-e", o->max_delta_e,
                    "exit with status 1 where the looks differ by more than this dE2000 anywhere")
        .takes(Takes::zero_or_more);
    verb.add_flag("--json", o->json, "print the results as JSON");
    return [o, &verb] { return run_compare(*o, verb); };
}

} // namespace converter
