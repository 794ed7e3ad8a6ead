#include "lutlib/color/encoding.h"

#include "lutlib/color/rows/all.h"
#include "lutlib/named.h"

#include <array>
#include <cctype>
#include <vector>

namespace lutlib {
namespace {

constexpr std::array curve_table{
    &curve::srgb,
    &curve::rec709,
    &curve::gamma22,
    &curve::gamma24,
    &curve::gamma26,
    &curve::linear,
    &curve::pq,
    &curve::hlg,
    &curve::acescc,
    &curve::acescct,
    &curve::cineon,
    &curve::logc3,
    &curve::logc3_ei160,
    &curve::logc3_ei200,
    &curve::logc3_ei250,
    &curve::logc3_ei320,
    &curve::logc3_ei400,
    &curve::logc3_ei500,
    &curve::logc3_ei640,
    &curve::logc3_ei1000,
    &curve::logc3_ei1280,
    &curve::logc3_ei1600,
    &curve::logc4,
    &curve::slog2,
    &curve::slog3,
    &curve::vlog,
    &curve::clog,
    &curve::clog2,
    &curve::clog3,
    &curve::log3g10,
    &curve::flog,
    &curve::flog2,
    &curve::nlog,
    &curve::dlog,
    &curve::blackmagic_film5,
    &curve::davinci_intermediate,
    &curve::applelog,
    &curve::protune,
    &curve::o3de_log2,
};

constexpr std::array gamut_table{
    &gamut::rec709,
    &gamut::rec2020,
    &gamut::p3_d65,
    &gamut::p3_dci,
    &gamut::display_p3,
    &gamut::adobe_rgb,
    &gamut::ap0,
    &gamut::ap1,
    &gamut::arri_wide_gamut3,
    &gamut::arri_wide_gamut4,
    &gamut::sgamut3,
    &gamut::sgamut3_cine,
    &gamut::vgamut,
    &gamut::cinema_gamut,
    &gamut::red_wide_gamut,
    &gamut::dgamut,
    &gamut::blackmagic_wide_gamut,
    &gamut::davinci_wide_gamut,
    &gamut::protune_native,
};

constexpr std::array adaptation_table{&bradford, &cat02};

// The next letter or digit, in lower case; 0 at the end.
char next_sign(std::string_view& text) {
    while (!text.empty()) {
        const auto c = static_cast<unsigned char>(text.front());
        text.remove_prefix(1);
        if (std::isalnum(c)) {
            return static_cast<char>(std::tolower(c));
        }
    }
    return 0;
}

bool spelt_alike(std::string_view a, std::string_view b) {
    for (;;) {
        const char x = next_sign(a), y = next_sign(b);
        if (x != y || x == 0) {
            return x == y;
        }
    }
}

template <class Row>
const Row* named(std::span<const Row* const> rows, std::string_view name) {
    const auto found = std::find_if(
        rows.begin(), rows.end(), [name](const Row* row) { return spelt_alike(row->name, name); });
    return found == rows.end() ? nullptr : *found;
}

void hold_all(std::span<RgbD> colors) {
    for (RgbD& c : colors) {
        c = {held(c.r), held(c.g), held(c.b)};
    }
}

} // namespace

std::span<const TransferCurve* const> transfer_curves() {
    return curve_table;
}

const TransferCurve* transfer_curve_named(std::string_view name) {
    return named(transfer_curves(), name);
}

std::span<const Gamut* const> gamuts() {
    return gamut_table;
}

const Gamut* gamut_named(std::string_view name) {
    return named(gamuts(), name);
}

std::span<const Adaptation* const> adaptations() {
    return adaptation_table;
}

const Adaptation* adaptation_named(std::string_view name) {
    return named(adaptations(), name);
}

std::string Encoding::name() const {
    const std::string own(curve->name);
    return gamut == curve->gamut ? own : own + '/' + std::string(gamut->name);
}

std::string Encoding::label() const {
    return std::string(curve->label) + ", " + std::string(gamut->label);
}

void Encoding::decode_all(std::span<RgbD> colors) const {
    hold_all(colors);
    curve->decode_all(colors);
}

void Encoding::encode_all(std::span<RgbD> colors) const {
    hold_all(colors);
    curve->encode_all(colors);
}

std::span<const Encoding> encodings() {
    static const std::vector<Encoding> rows = [] {
        std::vector<Encoding> out;
        for (const TransferCurve* curve : curve_table) {
            out.push_back({curve, curve->gamut});
        }
        return out;
    }();
    return rows;
}

std::optional<Encoding> encoding_named(std::string_view name) {
    const std::size_t slash = name.find('/');
    const TransferCurve* const curve = transfer_curve_named(name.substr(0, slash));
    if (!curve) {
        const std::size_t blank = name.find(' ');
        const bool two = slash == name.npos && blank != name.npos;
        return two ? encoding_named(std::string(name.substr(0, blank)) + '/' +
                                    std::string(name.substr(blank + 1)))
                   : std::nullopt;
    }
    const Gamut* const gamut =
        slash == name.npos ? curve->gamut : gamut_named(name.substr(slash + 1));
    return gamut ? std::optional(Encoding{curve, gamut}) : std::nullopt;
}

Encoding require_encoding(std::string_view name) {
    if (const std::optional<Encoding> found = encoding_named(name)) {
        return *found;
    }
    const std::size_t slash = name.find('/');
    if (!transfer_curve_named(name.substr(0, slash))) {
        refuse_name("curve", name.substr(0, slash), name_list(transfer_curves()));
    }
    refuse_name("gamut", name.substr(slash + 1), name_list(gamuts()));
}

EncodingNames names_of(const LookEncodings& encodings) {
    const auto name = [](const std::optional<Encoding>& encoding) {
        return encoding ? encoding->name() : std::string();
    };
    return {name(encodings.input), name(encodings.output)};
}

LookEncodings encodings_of(const EncodingNames& names) {
    return {encoding_named(names.input), encoding_named(names.output)};
}

const Encoding& srgb() {
    static constexpr Encoding row{&curve::srgb, &gamut::rec709};
    return row;
}

Matrix3 light_to_light(const Encoding& from, const Encoding& to, const Adaptation& how) {
    return from.gamut == to.gamut ? Matrix3{} : rgb_to_rgb(from.primaries(), to.primaries(), how);
}

} // namespace lutlib
