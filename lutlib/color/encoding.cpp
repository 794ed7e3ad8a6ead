#include "lutlib/color/encoding.h"

#include "lutlib/color/transfer.h"
#include "lutlib/color/transfer_all.h"
#include "lutlib/named.h"

#include <array>

namespace lutlib {
namespace {

double unchanged(double x) {
    return x;
}

void unchanged_all(std::span<RgbD>) {}

constexpr std::array<Encoding, 6> table{{
    {"srgb", "sRGB", "IEC 61966-2-1", rec709, srgb_decode, srgb_encode, srgb_decode_all,
     srgb_encode_all},
    {"gamma24", "Rec.709, gamma 2.4", "ITU-R BT.1886", rec709, gamma24_decode, gamma24_encode,
     gamma24_decode_all, gamma24_encode_all},
    {"linear", "Linear, Rec.709 primaries", "", rec709, unchanged, unchanged, unchanged_all,
     unchanged_all},
    {"logc3", "ARRI LogC3 EI 800, ARRI Wide Gamut 3", "ARRI, ALEXA Log C Curve, Usage in VFX",
     arri_wide_gamut3, logc3_decode, logc3_encode, logc3_decode_all, logc3_encode_all},
    {"acescct", "ACEScct, AP1 primaries", "S-2016-001", aces_ap1, acescct_decode, acescct_encode,
     acescct_decode_all, acescct_encode_all},
    {"pq", "PQ, Rec.2020 primaries", "SMPTE ST 2084, ITU-R BT.2100", rec2020, pq_decode, pq_encode,
     pq_decode_all, pq_encode_all},
}};

} // namespace

std::span<const Encoding> encodings() {
    return table;
}

const Encoding* encoding_named(std::string_view name) {
    return find_named(table, name);
}

const Encoding& srgb() {
    return table.front();
}

} // namespace lutlib
