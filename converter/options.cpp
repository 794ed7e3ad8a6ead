#include "converter/options.h"

#include "converter/report.h"
#include "lutlib/error.h"
#include "lutlib/io/formats.h"

#include <fmt/core.h>

#include <cstdio>

namespace converter {
namespace {

template <class Rows>
std::string listed(const Rows& rows) {
    std::string out;
    for (const auto& row : rows) {
        out += (out.empty() ? "" : ", ") + std::string(row.name);
    }
    return out;
}

} // namespace

void EngineOption::declare(CLI::App& app, const std::string& default_name) {
    name_ = default_name;
    app.add_option("--engine", name_, "one of: " + listed(lutlib::engines()))
        ->capture_default_str();
}

const lutlib::Engine& EngineOption::get() const {
    const lutlib::Engine* const engine = lutlib::engine_named(name_);
    if (!engine) {
        throw lutlib::UsageError("there is no engine '" + name_ + "'; there are " +
                                 listed(lutlib::engines()));
    }
    return *engine;
}

void InterpolationOption::declare(CLI::App& app, const std::string& help) {
    app.add_option_function<std::string>(
           "--interpolation",
           [this](const std::string& name) {
               name_ = name;
               given_ = true;
           },
           help + ": " + listed(lutlib::interpolations()))
        ->default_str(name_);
}

lutlib::Interpolation InterpolationOption::get() const {
    const auto how = lutlib::interpolation_named(name_);
    if (!how) {
        throw lutlib::UsageError("there is no interpolation '" + name_ + "'; there are " +
                                 listed(lutlib::interpolations()));
    }
    return *how;
}

lutlib::Lut read_look(const std::string& path) {
    lutlib::io::Reading reading = lutlib::io::read_lut(path);
    for (const lutlib::Loss& loss : reading.losses) {
        std::fputs(("lutconv: " + reading.lut.provenance + ": " + loss_text(loss) + '\n').c_str(),
                   stderr);
    }
    return std::move(reading.lut);
}

std::string domain_text(const lutlib::Domain& domain) {
    const auto channel = [&](std::size_t c) {
        return fmt::format("{:.6g}..{:.6g}", domain.min[c], domain.max[c]);
    };
    const std::string r = channel(0), g = channel(1), b = channel(2);
    return r == g && g == b ? r : r + ", " + g + ", " + b;
}

} // namespace converter
