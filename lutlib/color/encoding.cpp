#include "lutlib/color/encoding.h"

#include "lutlib/color/transfer.h"

#include <array>

namespace lutlib {
namespace {

double unchanged(double x) {
    return x;
}

template <double F(double)>
void each(std::span<RgbD> colours) {
    for (RgbD& c : colours) {
        c = {F(c.r), F(c.g), F(c.b)};
    }
}

template <double Decode(double), double Encode(double)>
constexpr Encoding row(std::string_view name, std::string_view label, std::string_view source,
                       const Primaries& primaries) {
    return {name, label, source, primaries, Decode, Encode, each<Decode>, each<Encode>};
}

constexpr std::array<Encoding, 6> table{
    row<srgb_decode, srgb_encode>("srgb", "sRGB", "IEC 61966-2-1", rec709),
    row<gamma24_decode, gamma24_encode>("gamma24", "Rec.709, gamma 2.4", "ITU-R BT.1886", rec709),
    row<unchanged, unchanged>("linear", "Linear, Rec.709 primaries", "", rec709),
    row<logc3_decode, logc3_encode>("logc3", "ARRI LogC3 EI 800, ARRI Wide Gamut 3",
                                    "ARRI, ALEXA Log C Curve, Usage in VFX", arri_wide_gamut3),
    row<acescct_decode, acescct_encode>("acescct", "ACEScct, AP1 primaries", "S-2016-001",
                                        aces_ap1),
    row<pq_decode, pq_encode>("pq", "PQ, Rec.2020 primaries", "SMPTE ST 2084, ITU-R BT.2100",
                              rec2020),
};

} // namespace

std::span<const Encoding> encodings() {
    return table;
}

const Encoding* encoding_named(std::string_view name) {
    for (const Encoding& row : table) {
        if (row.name == name) {
            return &row;
        }
    }
    return nullptr;
}

const Encoding& srgb() {
    return table.front();
}

} // namespace lutlib
