// Lines and words of a text file, with line numbers for errors. All of it ignores the locale.
#pragma once

#include "lutlib/byte_source.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib {

/// Walks over the lines of a text. A line ends with LF, CR LF or a lone CR; the last may lack its
/// end. A UTF-8 byte order mark before the first line is skipped.
class LineScanner {
  public:
    explicit LineScanner(std::string_view bytes);
    /// Of a text that begins with `head` and goes on with what `more` gives. Lines and rest() hold
    /// until the next call of next() or fetch().
    LineScanner(std::string_view head, ByteSource& more);
    LineScanner(LineScanner&&) = default;
    LineScanner& operator=(LineScanner&&) = default;

    /// False at the end. The line excludes its end.
    bool next(std::string_view& line);

    /// Brings text into rest() when it has fewer than `least` bytes and there is more. True if it
    /// did.
    bool fetch(std::size_t least);

    /// Bytes of the whole text from rest() on, as far as is known.
    std::size_t remaining() const;

    /// Number of the line that next() returned last, from 1; 0 before the first.
    std::size_t line_number() const { return line_; }

    /// Text from the start of the line that the next next() returns.
    std::string_view rest() const { return rest_; }

    /// Steps over `bytes` bytes of rest() that hold `lines` whole lines.
    void skip(std::size_t bytes, std::size_t lines);

  private:
    bool fetch_more();

    std::string_view rest_;
    std::size_t line_ = 0;
    ByteSource* more_ = nullptr; ///< null: rest_ is all there is
    std::vector<char> buffer_;   ///< what rest_ views, of a text in pieces
};

/// Without blanks at both ends. Blanks are tabs and all spaces, no-break spaces among them.
std::string_view trimmed(std::string_view text);

/// ASCII letters in upper case, whatever the locale.
char upper(char c);
std::string upper(std::string_view word);

/// A line's first words, split at blanks. `count` may exceed `items`' size, whose further
/// words are then not kept.
struct Words {
    std::array<std::string_view, 8> items;
    std::size_t count = 0;
};
Words words_of(std::string_view line);

/// The same text in UTF-8, of text that is UTF-16 by its byte order mark or by its zero bytes;
/// nullopt for any other.
std::optional<std::string> utf8_of_utf16(std::string_view bytes);

enum class NumberStatus { ok, not_a_number, not_finite };

/// A whole word as a float, correctly rounded: digits with a point or a decimal comma, an optional
/// sign and exponent. Magnitudes below the smallest float become 0; above the largest, and
/// spellings of infinity and NaN ("inf", "nan", "1.#INF", ...), are not_finite.
NumberStatus parse_float(std::string_view word, float& value);

} // namespace lutlib
