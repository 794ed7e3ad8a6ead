#include "converter/options.h"

#include "converter/usage.h"

#include "lutlib/engine/engine_names.h"
#include "lutlib/named.h"

#include <algorithm>

namespace converter {
void EngineOption::declare(Verb& verb, const std::string& default_name) {
    name_ = default_name;
    verb.add_option("--engine", name_, "one of: " + lutlib::names_of(lutlib::engines()))
        .capture_default_str();
}

const lutlib::Engine& EngineOption::get() const {
    return lutlib::require_engine(name_);
}

std::vector<const lutlib::Engine*> EngineOption::all() const {
    std::vector<const lutlib::Engine*> out;
    for (const std::string& name : names_in_list(name_)) {
        out.push_back(&lutlib::require_engine(name));
    }
    return out;
}

void InterpolationOption::declare(Verb& verb, const std::string& help) {
    verb.add_option("--interpolation", name_,
                    help + ": " + lutlib::names_of(lutlib::interpolations()) +
                        " (default: as the look asks for, else tetrahedral)");
}

std::optional<lutlib::Interpolation> InterpolationOption::get() const {
    if (name_.empty()) {
        return std::nullopt;
    }
    return lutlib::require_named(lutlib::interpolations(), "interpolation", name_).kind;
}

std::vector<std::string> names_in_list(const std::string& list) {
    std::vector<std::string> out;
    for (std::size_t at = 0; at <= list.size();) {
        const std::size_t comma = std::min(list.find(',', at), list.size());
        out.push_back(list.substr(at, comma - at));
        at = comma + 1;
    }
    return out;
}

void declare_reference_white(Verb& verb, double& nits) {
    verb.add_option("--reference-white", nits,
                    "cd/m2 of diffuse white, for colour differences; PQ codes say their own light")
        .takes(Takes::above_zero)
        .capture_default_str();
}

} // namespace converter
