#include "preview/finish/probe.h"

#include "lutlib/codes.h"
#include "lutlib/color/difference.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstring>

namespace preview {

namespace {

std::string line(std::string_view name, lutlib::RgbD color) {
    const Codes codes = codes_of(color);
    return fmt::format("{:<8} {:>3} {:>3} {:>3}   {:.5f} {:.5f} {:.5f}", name, codes.r, codes.g,
                       codes.b, color.r, color.g, color.b);
}

nlohmann::json json_of(lutlib::RgbD color) {
    const Codes codes = codes_of(color);
    return {{"codes", {codes.r, codes.g, codes.b}}, {"values", {color.r, color.g, color.b}}};
}

} // namespace

bool operator==(const Probe& a, const Probe& b) {
    return std::memcmp(&a, &b, sizeof(Probe)) == 0;
}

std::optional<Probe> probe_from(std::span<const std::byte> bytes) {
    std::array<float, 12> values{};
    if (bytes.size() != sizeof values) {
        return std::nullopt;
    }
    std::memcpy(values.data(), bytes.data(), sizeof values);
    const auto color = [&](std::size_t at) {
        return lutlib::to_double(lutlib::Rgb{values[at], values[at + 1], values[at + 2]});
    };
    return Probe{.before = color(0),
                 .a = color(4),
                 .b = color(8),
                 .light = lutlib::to_double(lutlib::Rgb{values[3], values[7], values[11]})};
}

Codes codes_of(lutlib::RgbD color) {
    constexpr lutlib::CodeDepth depth{8};
    return {depth.code(color.r), depth.code(color.g), depth.code(color.b)};
}

ProbeDifferences differences_of(const Probe& probe) {
    const lutlib::RgbD before = lutlib::saturate(probe.before), a = lutlib::saturate(probe.a),
                       b = lutlib::saturate(probe.b);
    return {lutlib::delta_e_2000(before, a), lutlib::delta_e_2000(before, b),
            lutlib::delta_e_2000(a, b)};
}

std::string probe_table(const Probe& probe, ProbePlace place) {
    const ProbeDifferences differences = differences_of(probe);
    return fmt::format("{:<8} codes         values of texel {}, {}\n{}\n{}   dE2000 from before "
                       "{:.3f}\n{}   dE2000 from before {:.3f}, from A {:.3f}\n",
                       "", place.x, place.y, line("before", probe.before), line("A", probe.a),
                       differences.before_a, line("B", probe.b), differences.before_b,
                       differences.a_b);
}

std::string probe_json(const Probe& probe, ProbePlace place) {
    const ProbeDifferences differences = differences_of(probe);
    const nlohmann::json all = {{"x", place.x},
                                {"y", place.y},
                                {"before", json_of(probe.before)},
                                {"a", json_of(probe.a)},
                                {"b", json_of(probe.b)},
                                {"delta_e_2000",
                                 {{"before_a", differences.before_a},
                                  {"before_b", differences.before_b},
                                  {"a_b", differences.a_b}}}};
    return all.dump(2, ' ', true, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace preview
