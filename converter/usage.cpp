#include "converter/usage.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/output_names.h"

#include <CLI/StringTools.hpp>
#include <CLI/TypeTools.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace converter {
namespace {

using lutlib::UsageError;

std::ptrdiff_t standard_streams(std::span<const std::string> paths) {
    return std::count(paths.begin(), paths.end(), lutlib::io::standard_stream);
}

lutlib::Rgb end_of_domain(const std::string& text) {
    std::vector<float> channels;
    for (const std::string& part : CLI::detail::split(text, ',')) {
        float value = 0;
        if (!CLI::detail::lexical_cast(CLI::detail::trim_copy(part), value)) {
            throw UsageError(
                fmt::format("--domain takes two numbers, or two of \"r,g,b\", not '{}'", text));
        }
        channels.push_back(value);
    }
    if (channels.size() == 1) {
        return {channels[0], channels[0], channels[0]};
    }
    if (channels.size() != 3) {
        throw UsageError(
            fmt::format("--domain takes two numbers, or two of \"r,g,b\", not '{}'", text));
    }
    return {channels[0], channels[1], channels[2]};
}

} // namespace

lutlib::Domain domain_of(const std::vector<std::string>& ends) {
    const lutlib::Domain domain{end_of_domain(ends[0]), end_of_domain(ends[1])};
    for (std::size_t c = 0; c < 3; ++c) {
        const double low = domain.min[c], high = domain.max[c];
        if (!(low < high) || !std::isfinite(high - low)) {
            throw UsageError(fmt::format(
                "--domain takes a minimum and a maximum above it, not {} and {}", low, high));
        }
    }
    return domain;
}

void require_png_name(const std::string& path, const std::string& what) {
    const std::string extension = lutlib::io::extension_of(path);
    if (path != lutlib::io::standard_stream && !extension.empty() && extension != "png") {
        throw UsageError(what + " writes PNG, but -o names '" + path +
                         "'; use a .png name, or convert for other formats");
    }
}

void require_one_standard_input(std::span<const std::string> inputs) {
    if (standard_streams(inputs) > 1) {
        throw UsageError("only one input can come from standard input; name files for the others");
    }
}

std::string standard_output_of(std::span<const std::string> outputs) {
    const auto count = standard_streams(outputs);
    if (count > 1) {
        throw UsageError("only one output can go to standard output; name files for the others");
    }
    std::vector<std::string> files;
    std::copy_if(outputs.begin(), outputs.end(), std::back_inserter(files),
                 [](const std::string& output) {
                     return !output.empty() && output != lutlib::io::standard_stream;
                 });
    lutlib::io::require_distinct(files);
    return count > 0 ? std::string(lutlib::io::standard_stream) : std::string();
}

} // namespace converter
