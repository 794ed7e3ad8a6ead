#include "lutlib/formats/integer_codes.h"

#include "lutlib/text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

constexpr std::array usual_depths{8, 10, 12, 14, 16};
constexpr int vlt_bits = 12;

/// The largest value of a table of whole numbers; nullopt where one is negative or not whole.
std::optional<float> largest_whole(const std::vector<Rgb>& values) {
    float largest = 0;
    for (const Rgb& value : values) {
        for (std::size_t c = 0; c < 3; ++c) {
            if (!(value[c] >= 0) || value[c] != std::floor(value[c])) {
                return std::nullopt;
            }
            largest = std::max(largest, value[c]);
        }
    }
    return largest;
}

bool is_vlt(const Lut& lut) {
    return upper(lut.provenance).ends_with(".VLT") ||
           std::any_of(lut.comments.begin(), lut.comments.end(), [](const std::string& comment) {
               return upper(comment).starts_with("PANASONIC VLT");
           });
}

/// The depth of which an input range is all codes.
std::optional<int> depth_of(const Domain& domain) {
    const auto depth = std::find_if(usual_depths.begin(), usual_depths.end(), [&](int bits) {
        const auto top = static_cast<float>(largest_code(bits));
        return domain == Domain{{0, 0, 0}, {top, top, top}};
    });
    return depth == usual_depths.end() ? std::nullopt : std::optional(*depth);
}

bool stays_inside(float largest, const Domain& domain) {
    return !domain.is_unit() && largest <= std::max({domain.max.r, domain.max.g, domain.max.b});
}

void scale(std::vector<Rgb>& values, int bits) {
    const double top = largest_code(bits);
    for (Rgb& value : values) {
        for (std::size_t c = 0; c < 3; ++c) {
            value[c] = static_cast<float>(static_cast<double>(value[c]) / top);
        }
    }
}

std::string whole_numbers_text(const char* which, float largest) {
    return std::string("the values of the ") + which + " table are all whole numbers, up to " +
           std::to_string(static_cast<long>(largest));
}

void scale_table(std::vector<Rgb>& values, Domain& domain, bool vlt, const char* which,
                 std::vector<std::string>& notes) {
    const std::optional<float> largest = largest_whole(values);
    if (!largest || (!vlt && *largest <= 1)) {
        return;
    }
    const std::optional<int> of_input = depth_of(domain);
    if (!vlt && !of_input && *largest < float{least_largest_code}) {
        if (!stays_inside(*largest, domain)) {
            notes.push_back(whole_numbers_text(which, *largest) +
                            ": read as they are; if they are codes, write the range of the codes "
                            "into the file (DOMAIN_MIN 0 0 0, DOMAIN_MAX 1023 1023 1023)");
        }
        return;
    }
    const std::optional<int> needed = depth_of_codes(*largest);
    if (!needed) {
        return;
    }
    const bool declared = vlt && *needed <= vlt_bits;
    const int bits = declared ? vlt_bits : std::max(*needed, of_input.value_or(0));
    if (!declared && !of_input && stays_inside(*largest, domain)) {
        return;
    }
    scale(values, bits);
    const std::string depth = std::to_string(bits) + "-bit codes";
    std::string note = declared ? std::string("the values are ") + depth + ", as in every .vlt"
                                : whole_numbers_text(which, *largest) + ": guessed to be " + depth;
    if (of_input) {
        domain = {};
        note += ", as is its input range";
    }
    notes.push_back(std::move(note));
}

} // namespace

double largest_code(int bits) {
    return std::ldexp(1.0, bits) - 1;
}

std::optional<int> depth_of_codes(double largest) {
    const auto depth = std::find_if(usual_depths.begin(), usual_depths.end(),
                                    [&](int bits) { return largest <= largest_code(bits); });
    return depth == usual_depths.end() ? std::nullopt : std::optional(*depth);
}

void scale_integer_codes(Lut& lut) {
    const bool vlt = is_vlt(lut);
    if (lut.shaper) {
        scale_table(lut.shaper->entries, lut.shaper->domain, vlt, "1D", lut.notes);
    }
    if (lut.cube) {
        scale_table(lut.cube->nodes, lut.cube->domain, vlt, "3D", lut.notes);
    }
}

} // namespace lutlib
