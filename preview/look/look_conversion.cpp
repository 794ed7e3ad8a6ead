#include "preview/look/look_conversion.h"

namespace preview {

namespace {

bool is_linear(const lutlib::Encoding& encoding) {
    return encoding.curve == lutlib::transfer_curve_named("linear");
}

std::array<float, 4> row_of(lutlib::RgbD c) {
    return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b), 0};
}

void append_matrix(std::vector<std::array<float, 4>>& rows, const lutlib::Encoding& from,
                   const lutlib::Encoding& to) {
    const lutlib::Matrix3 matrix = lutlib::light_to_light(from, to);
    const lutlib::RgbD r = matrix * lutlib::RgbD{1, 0, 0}, g = matrix * lutlib::RgbD{0, 1, 0},
                       b = matrix * lutlib::RgbD{0, 0, 1};
    for (std::size_t c = 0; c < 3; ++c) {
        rows.push_back(row_of({r[c], g[c], b[c]}));
    }
}

} // namespace

std::uint32_t place_bits(const LookConversion& conversion) {
    const auto& [codes, fed, gives, is_picture] = conversion;
    const bool opens = codes && *codes != fed;
    const bool encodes = (!codes || opens) && !is_linear(fed);
    const bool decodes = is_picture ? gives != lutlib::srgb() : !is_linear(gives);
    const std::uint32_t bits = (codes ? 0 : PlaceBits::before) | (opens ? PlaceBits::opens : 0) |
                               (encodes ? PlaceBits::encodes : 0) |
                               (decodes ? PlaceBits::decodes : 0);
    return codes && bits == 0 ? 0 : bits | (is_picture ? PlaceBits::is_picture : 0);
}

std::vector<std::array<float, 4>> conversion_rows(const LookConversion& conversion) {
    const lutlib::Encoding light = *lutlib::encoding_named("linear");
    const lutlib::Encoding from = conversion.codes.value_or(light);
    std::vector<std::array<float, 4>> rows;
    rows.reserve(conversion_row_count);
    append_matrix(rows, from, conversion.fed);
    append_matrix(rows, conversion.gives, light);
    const CubicCurve fed(*conversion.fed.curve), gives(*conversion.gives.curve), codes(*from.curve);
    rows.push_back({gives.low, gives.high, codes.low, codes.high});
    for (const auto& pieces : {fed.encoding, gives.decoding, codes.decoding}) {
        rows.insert(rows.end(), pieces.begin(), pieces.end());
    }
    return rows;
}

} // namespace preview
