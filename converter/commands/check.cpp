// lutconv check: what is broken, folded, steep or flat in a look, and what can be repaired.
#include "converter/command.h"
#include "converter/explain.h"
#include "converter/look_files.h"
#include "converter/many_looks.h"
#include "converter/report.h"
#include "converter/unused.h"
#include "converter/usage.h"
#include "lutlib/error.h"
#include "lutlib/health/health.h"
#include "lutlib/health/repair.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/describe.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/recipe_file.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace converter {
namespace {

namespace io = lutlib::io;
using lutlib::Severity;

struct CheckOptions {
    std::vector<std::string> inputs;
    std::string output_template;
    std::string input, output; ///< of one look
    bool strict = false, repair = false, explain = false, json = false;
    double tolerance = lutlib::SimplifyOptions{}.tolerance;
    lutlib::RepairOptions repairs;
};

/// A look as a table, and what it is a table of.
struct Checked {
    lutlib::Lut lut;
    lutlib::ExamineOptions options;
};

// As every verb reads a look, except that a file may hold values that are no numbers: they are
// what is looked for.
Checked read_to_check(const std::string& path) {
    const std::string bytes = io::read_file(path);
    const std::string name = io::input_name(path);
    if (!io::is_recipe(bytes)) {
        const lutlib::FileFormat& format = io::recognise_format(bytes, name);
        if (format.read_broken) {
            Checked out{format.read_broken(bytes, name), {}};
            tell_of(out.lut, path);
            return out;
        }
    }
    const io::Look look = open_look(bytes, path);
    Checked out{*table_of(look), {.encodings = look.encodings()}};
    if (!look.is_table()) {
        out.options.exact = look.exact();
    }
    return out;
}

std::string place_text(const std::optional<lutlib::Rgb>& where) {
    return where ? fmt::format(", at {:.4g} {:.4g} {:.4g}", where->r, where->g, where->b) : "";
}

std::string verdict_text(const lutlib::Health& health) {
    int faults = 0, warnings = 0;
    for (const lutlib::HealthCheck& check : lutlib::health_checks()) {
        const Severity severity = check.judge(health).severity;
        faults += severity == Severity::fault;
        warnings += severity == Severity::warning;
    }
    const auto count = [](int n, const char* what) {
        return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
    };
    return (faults ? "unhealthy: " + count(faults, "fault") + ", " : "healthy: ") +
           count(warnings, "warning");
}

std::string findings_text(const lutlib::Health& health) {
    std::string out;
    for (const lutlib::HealthCheck& check : lutlib::health_checks()) {
        const lutlib::Finding finding = check.judge(health);
        out += fmt::format("  {:<8} {:<18} {}{}\n", name_of(finding.severity), check.name,
                           finding.words, place_text(finding.where));
    }
    return out + verdict_text(health) + "\n";
}

nlohmann::ordered_json findings_json(const lutlib::Health& health) {
    nlohmann::ordered_json checks = nlohmann::ordered_json::array();
    for (const lutlib::HealthCheck& check : lutlib::health_checks()) {
        const lutlib::Finding finding = check.judge(health);
        nlohmann::ordered_json row{{"check", check.name},
                                   {"severity", name_of(finding.severity)},
                                   {"figure", finding.figure},
                                   {"unit", check.unit},
                                   {"words", finding.words}};
        if (finding.where) {
            row["at"] = {finding.where->r, finding.where->g, finding.where->b};
        }
        checks.push_back(row);
    }
    nlohmann::ordered_json lattices = nlohmann::ordered_json::array();
    for (const lutlib::LatticeError& e : health.lattices) {
        if (e.measured) {
            lattices.push_back(
                {{"nodes", e.nodes},
                 {"absolute", to_json(e.code)},
                 {health.results == lutlib::Results::hdr ? "delta_e_itp" : "delta_e_2000",
                  to_json(e.to_eye)}});
        }
    }
    const auto spread = [](const lutlib::Spread& s, const lutlib::Extreme& most) {
        return nlohmann::ordered_json{{"p50", s.p50}, {"p99", s.p99}, {"max", most.value}};
    };
    return {{"verdict", verdict_text(health)},
            {"healthy", verdict(health) < Severity::fault},
            {"lattices", lattices},
            {"gain", spread(health.gain_spread, health.gain)},
            {"condition", spread(health.condition_spread, health.condition)},
            {"checks", checks}};
}

std::string repair_text(const lutlib::Repaired& repaired) {
    std::string out;
    for (const lutlib::RepairStep& step : repaired.steps) {
        out += fmt::format("  repaired: {}: {} values, changed by {:.4g} at most; to the eye by dE "
                           "{:.3g} at most, mean {:.3g} of {} colours\n",
                           step.words, step.changed, step.largest, step.to_eye.max,
                           step.to_eye.mean, step.to_eye.count);
    }
    for (const std::string& left : repaired.left) {
        out += "  left: " + left + "\n";
    }
    return out.empty() ? "  nothing to repair\n" : out;
}

nlohmann::ordered_json repair_json(const lutlib::Repaired& repaired) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const lutlib::RepairStep& step : repaired.steps) {
        out.push_back({{"repair", step.name},
                       {"words", step.words},
                       {"changed_values", step.changed},
                       {"largest_change", step.largest},
                       {"to_eye", to_json(step.to_eye)}});
    }
    return out;
}

int check_one(const CheckOptions& o) {
    const Checked checked = read_to_check(o.input);
    const lutlib::Lut& lut = checked.lut;
    lutlib::Health health = examine(lut, checked.options);
    std::string text = fmt::format("{}: {}, input {}\n{}", input_text(o.input), io::shape_of(lut),
                                   io::domain_text(lut.domain()), findings_text(health));
    nlohmann::ordered_json json{{"input", o.input}};
    json.update(findings_json(health));
    lutlib::Repaired repaired{lut, {}, {}};
    if (o.repair) {
        repaired = repair(lut, o.repairs);
        tell_losses(write_look(repaired.lut, o.output), o.output);
        health = examine(repaired.lut, {.encodings = checked.options.encodings});
        text += fmt::format("{}\n{}{}", output_text(o.output), repair_text(repaired),
                            findings_text(health));
        json["output"] = o.output;
        json["repairs"] = repair_json(repaired);
        json["left"] = repaired.left;
        json["after"] = findings_json(health);
    }
    if (o.explain) {
        // What holds values that are no numbers is beyond simplifying.
        if (health.non_finite > 0) {
            throw lutlib::Error(
                "--explain needs a look without NaN and infinities; repair it with --repair first",
                {io::input_name(o.input), 0, {}});
        }
        const Explanation explanation = explain(repaired.lut, o.tolerance);
        text += "what it does not need:\n" + to_text(explanation);
        json["explanation"] = to_json(explanation);
    }
    o.json ? print(json, o.output) : print(text, o.output);
    const bool healthy = verdict(health) < Severity::fault;
    return o.strict && !healthy ? verification_failed : ok;
}

int run_check(const CheckOptions& o, const Verb& verb) {
    if (o.repairs.clamp && !o.repair) {
        throw lutlib::UsageError("--clamp works with --repair only; add --repair, or drop --clamp");
    }
    if (o.repair == o.output_template.empty()) {
        throw lutlib::UsageError(o.repair ? "--repair needs -o LUT, the file to write"
                                          : "-o names the repaired LUT; add --repair, or drop -o");
    }
    tell_unused(verb, {{"--tolerance", o.explain, "it is --explain that takes it"}});
    return run_over(routes_of_looks(o.inputs, o.output_template), [&](const LookRoute& route) {
        CheckOptions one = o;
        one.input = route.route.from.path;
        one.output = route.route.to;
        return check_one(one);
    });
}

std::string check_list() {
    std::string out = "Checks:\n";
    for (const lutlib::HealthCheck& check : lutlib::health_checks()) {
        out += fmt::format("  {:<18} {} ({})\n", check.name, check.help, check.unit);
    }
    out += "Repairs:\n";
    for (const lutlib::RepairInfo& row : lutlib::repairs()) {
        out += fmt::format("  {:<18} {}\n", row.name, row.help);
    }
    return out;
}

} // namespace

Run declare_check(Verb& verb) {
    const auto o = std::make_shared<CheckOptions>();
    verb.add_option("LUTS", o->inputs,
                    "LUT or recipe files, or - for standard input; folders of them")
        .required();
    verb.add_flag("--strict", o->strict, "exit with status 1 if a fault remains");
    verb.add_flag("--repair", o->repair, "repair what can be repaired and write the result to -o");
    verb.add_flag("--clamp", o->repairs.clamp, "with --repair: clamp outputs to 0..1");
    verb.add_output("-o,--output", o->output_template,
                    "the repaired LUT, or - for standard output; of several a name with {name} in "
                    "it",
                    OutputName::is_template);
    verb.add_flag("--explain", o->explain,
                  "list the parts that the look does not need; convert --explain drops them");
    verb.add_option("--tolerance", o->tolerance,
                    "with --explain: the largest difference of a channel that is ignored")
        .takes(Takes::zero_or_more)
        .capture_default_str();
    verb.add_flag("--json", o->json, "print the results as JSON");
    verb.footer(check_list());
    return [o, &verb] { return run_check(*o, verb); };
}

} // namespace converter
