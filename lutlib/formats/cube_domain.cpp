#include "lutlib/formats/cube_domain.h"

#include "lutlib/error.h"

namespace lutlib {

void PlacedLine::fail(const std::string& message) const {
    throw Error(message, {file, number, std::string(text)});
}

float PlacedLine::number_at(std::size_t word) const {
    const std::string_view written = words.items[word];
    float value = 0;
    switch (parse_float(written, value)) {
    case NumberStatus::ok:
        return value;
    case NumberStatus::not_finite:
        fail("'" + std::string(written) + "' is not a finite number");
    case NumberStatus::not_a_number:
        break;
    }
    fail("'" + std::string(written) + "' is not a number");
}

bool CubeDomains::take(const PlacedLine& line) {
    const std::string keyword = upper(line.words.items[0]);
    const bool is_min = keyword == "DOMAIN_MIN", is_max = keyword == "DOMAIN_MAX";
    const bool is_1d = keyword == "LUT_1D_INPUT_RANGE", is_3d = keyword == "LUT_3D_INPUT_RANGE";
    if (!is_min && !is_max && !is_1d && !is_3d) {
        return false;
    }
    const std::string name(line.words.items[0]);
    const bool is_bound = is_min || is_max;
    if (line.words.count != (is_bound ? 4 : 3)) {
        line.fail(name + (is_bound ? " needs 3 numbers"
                                   : " needs 2 numbers, the minimum and the maximum"));
    }
    Range& range = is_bound ? adobe_ : is_1d ? resolve_1d_ : resolve_3d_;
    if (is_max ? range.max : range.min) {
        line.fail("a second " + name + "; a file has one");
    }
    if (is_bound) {
        (is_min ? range.min : range.max) =
            Rgb{line.number_at(1), line.number_at(2), line.number_at(3)};
    } else {
        const float low = line.number_at(1), high = line.number_at(2);
        range.min = Rgb{low, low, low};
        range.max = Rgb{high, high, high};
    }
    // A bound that is missing has its default; that the interval is sound is checked at the end,
    // when both are known, and told with this line.
    range.line = line.number;
    range.text = line.text;
    return true;
}

void CubeDomains::apply(const Range& range, Domain& domain, const std::string& file) {
    domain.min = range.min.value_or(domain.min);
    domain.max = range.max.value_or(domain.max);
    try {
        check_domain(domain);
    } catch (const Error& error) {
        throw Error(error.message(), {file, range.line, range.text});
    }
}

// `is_given`: DOMAIN_MIN or DOMAIN_MAX has said it already.
void CubeDomains::apply_range(const Range& range, Domain* domain, bool is_given,
                              const char* keyword, const std::string& file) {
    if (range.line == 0) {
        return;
    }
    Domain own;
    const Domain before = domain ? *domain : own;
    apply(range, domain ? *domain : own, file);
    if (!domain && !own.is_unit()) {
        throw Error(std::string(keyword) + " speaks of a table that this file does not have",
                    {file, range.line, range.text});
    }
    if (is_given && !(before == *domain)) {
        throw Error("DOMAIN_MIN/MAX and an INPUT_RANGE of the same table disagree; keep one",
                    {file, range.line, range.text});
    }
}

void CubeDomains::give_to(Lut& lut, const std::string& file) const {
    Domain* const curve = lut.shaper ? &lut.shaper->domain : nullptr;
    Domain* const cube = lut.cube ? &lut.cube->domain : nullptr;
    const bool is_adobe = adobe_.line > 0;
    if (is_adobe) {
        apply(adobe_, curve ? *curve : *cube, file);
    }
    apply_range(resolve_1d_, curve, is_adobe && curve, "LUT_1D_INPUT_RANGE", file);
    apply_range(resolve_3d_, cube, is_adobe && !curve, "LUT_3D_INPUT_RANGE", file);
}

} // namespace lutlib
