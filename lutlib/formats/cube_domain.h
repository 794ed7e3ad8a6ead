// The inputs that a .cube's tables span, by either dialect's keywords.
#pragma once

#include "lutlib/lut.h"
#include "lutlib/text.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace lutlib {

/// A line of a text with where it stands, for errors.
struct PlacedLine {
    const std::string& file;
    std::size_t number;
    std::string_view text;
    const Words& words;

    [[noreturn]] void fail(const std::string& message) const;
    /// The word as a finite number, else throws Error.
    float number_at(std::size_t word) const;
};

class CubeDomains {
  public:
    /// Takes DOMAIN_MIN, DOMAIN_MAX, LUT_1D_INPUT_RANGE or LUT_3D_INPUT_RANGE; false for any other
    /// keyword. Throws Error for a count of numbers that is not the keyword's, and for a second
    /// one.
    bool take(const PlacedLine& line);

    /// Gives the look's tables their domains. Throws Error for one that is empty or inverted, for
    /// the two dialects in disagreement, and for a range of a table that the look does not have.
    void give_to(Lut& lut, const std::string& file) const;

  private:
    struct Range {
        std::optional<Rgb> min, max;
        std::size_t line = 0;
        std::string text; ///< of that line
    };
    static void apply(const Range& range, Domain& domain, const std::string& file);
    static void apply_range(const Range& range, Domain* domain, bool is_given, const char* keyword,
                            const std::string& file);

    Range adobe_, resolve_1d_, resolve_3d_;
};

} // namespace lutlib
