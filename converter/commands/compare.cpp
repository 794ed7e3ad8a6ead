// lutconv compare: how far apart two looks are, and where most.
#include "lutlib/metrics/compare.h"
#include "converter/command.h"
#include "converter/look_files.h"
#include "converter/options.h"
#include "converter/recipe_options.h"
#include "converter/report.h"
#include "converter/result.h"
#include "converter/usage.h"
#include "lutlib/error.h"
#include "lutlib/io/bake_report.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <memory>

namespace converter {
namespace {

struct Options {
    std::string a, b, encoding = "srgb";
    InterpolationOption interpolation;
    int samples = 100000;
    std::vector<float> domain;
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
};

Compared opened(const std::string& name, const Options& o) {
    if (name == "identity") {
        return {};
    }
    const lutlib::io::Look look = open_look(name, {.interpolation = o.interpolation.get()});
    return {look.exact(), look.domain()};
}

int run(const Options& o) {
    if (o.samples < 1 || o.samples > 100000000) {
        throw lutlib::UsageError("--samples must be a number from 1 to 100000000");
    }
    require_one_standard_input(std::array{o.a, o.b});
    const lutlib::Encoding encoding = encoding_of(o.encoding, "--encoding");
    const Compared a = opened(o.a, o), b = opened(o.b, o);
    lutlib::Domain domain = united(a.domain, b.domain);
    if (!o.domain.empty()) {
        domain = domain_of(o.domain);
    }
    constexpr int lattice = 17;
    const std::vector<lutlib::Rgb> inputs = samples_over(domain, lattice, o.samples);
    const lutlib::Difference d = compare(a.exact, b.exact, inputs, encoding);
    if (o.json) {
        nlohmann::ordered_json out{{"a", o.a}, {"b", o.b}, {"samples", inputs.size()}};
        out.update(to_json(d));
        print(out, "");
        return ok;
    }
    print(fmt::format("{} against {}, {} colours over {}\n{}", input_text(o.a), input_text(o.b),
                      inputs.size(), lutlib::io::domain_text(domain), to_text(d, "  ")),
          "");
    return ok;
}

} // namespace

Run declare_compare(CLI::App& app) {
    const auto o = std::make_shared<Options>();
    app.add_option("A", o->a, "a LUT or recipe file, or the word identity")->required();
    app.add_option("B", o->b, "the other, or the word identity")->required();
    o->interpolation.declare(app, "how LUTs are read between their nodes");
    app.add_option("--encoding", o->encoding,
                   std::string("encoding of the looks' outputs, for colour differences: ") +
                       encoding_help)
        ->capture_default_str();
    app.add_option("--samples", o->samples, "colours spread over the domain, besides a lattice")
        ->capture_default_str();
    app.add_option("--domain", o->domain,
                   "inputs to compare on: minimum and maximum (default: both looks' domains)")
        ->expected(2);
    app.add_flag("--json", o->json, "print the results as JSON");
    return [o] { return run(*o); };
}

} // namespace converter
