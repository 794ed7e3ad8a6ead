#include "lutlib/formats/cube.h"

#include "lutlib/error.h"
#include "lutlib/formats/cube_domain.h"
#include "lutlib/formats/decimal.h"
#include "lutlib/formats/encoding_comment.h"
#include "lutlib/formats/integer_codes.h"
#include "lutlib/formats/mistaken.h"
#include "lutlib/limits.h"
#include "lutlib/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>

namespace lutlib {
namespace {

bool is_letter(char c) {
    return (upper(c) >= 'A' && upper(c) <= 'Z') || c == '_';
}

bool is_control(char c) {
    const auto code = static_cast<unsigned char>(c);
    return code < 0x20 || code == 0x7f;
}

// Whether a line's first word may be a keyword that we do not know. Written first into a file,
// bytes that are no text could make it another format's.
bool may_be_keyword(std::string_view word) {
    return word.size() > 1 && is_letter(word.front()) &&
           word.find_first_of(".,") == std::string_view::npos &&
           std::none_of(word.begin(), word.end(), is_control);
}

std::size_t decimals_of(std::string_view number) {
    const std::size_t point = number.find_first_of(".,");
    return point == std::string_view::npos ? 0 : number.size() - point - 1;
}

bool is_number(std::string_view word) {
    float value = 0;
    return parse_float(word, value) != NumberStatus::not_a_number;
}

constexpr std::string_view title_keyword = "TITLE";

class CubeReader {
  public:
    // `head` is the whole text, or its first bytes.
    CubeReader(LineScanner lines, std::string_view head, const std::string& file,
               bool keep_non_finite = false)
        : lines_(std::move(lines)), file_(file), keep_non_finite_(keep_non_finite) {
        if (head.empty()) {
            throw Error("the file is empty; a .cube needs at least LUT_3D_SIZE or LUT_1D_SIZE",
                        {file_, 0, {}});
        }
        refuse_mistaken_file(head, file_);
        if (head.substr(0, 4096).find('\0') != std::string_view::npos) {
            throw Error("this is a binary file, not a .cube text", {file_, 0, {}});
        }
    }

    Lut read() {
        std::string_view line;
        for (;;) {
            take_plain_rows();
            if (!lines_.next(line)) {
                break;
            }
            read_line(line);
        }
        return finish();
    }

  private:
    [[noreturn]] void fail(const std::string& message, std::string_view text) const {
        throw Error(message, {file_, lines_.line_number(), std::string(text)});
    }

    // Lines of plain numbers, which are nearly all of a file, without looking for keywords.
    void take_plain_rows() {
        if (!table_ || filled_ == table_->size()) {
            return;
        }
        do {
            const RowRun run =
                parse_rows(lines_.rest(), table_->data() + filled_, table_->size() - filled_);
            lines_.skip(run.bytes, run.rows);
            filled_ += run.rows;
        } while (filled_ < table_->size() && lines_.fetch(rows_look_ahead + 1));
        next_table_when_full();
    }

    void read_line(std::string_view whole) {
        if (whole.find('\0') != std::string_view::npos) {
            fail("a NUL byte: this is a binary file, not a .cube text", {});
        }
        const std::string_view line = trimmed(whole);
        if (line.empty()) {
            return;
        }
        if (line.front() == '#') {
            read_comment(trimmed(line.substr(1)));
            return;
        }
        if (upper(words_of(line).items[0]) == title_keyword) {
            read_title(line.substr(title_keyword.size()));
            return;
        }
        const Words words = words_of(without_comment(line));
        if (looks_like_number(words.items[0])) {
            read_row(words, line);
        } else {
            read_keyword(words, line);
        }
    }

    // OpenColorIO refuses a Resolve file with a TITLE, so writers hide the title in a comment.
    void read_comment(std::string_view comment) {
        constexpr std::string_view quoted_title = "TITLE \"";
        if (lut_.title.empty() && comment.substr(0, quoted_title.size()) == quoted_title &&
            comment.size() <= limits::max_title_bytes) {
            read_title(comment.substr(title_keyword.size()));
        } else if (!take_encoding(comment, lut_.encodings)) {
            if (std::string note = encoding_contradiction(comment, lut_.encodings); !note.empty()) {
                lut_.notes.push_back(std::move(note));
            }
            lut_.comments.emplace_back(comment);
        }
    }

    // The "#" of "1.#INF" starts no comment.
    static std::string_view without_comment(std::string_view line) {
        for (std::size_t at = line.find('#'); at != std::string_view::npos;
             at = line.find('#', at + 1)) {
            if (line[at - 1] != '.') {
                return line.substr(0, at);
            }
        }
        return line;
    }

    static bool looks_like_number(std::string_view word) {
        const char c = word.front();
        return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == ',' ||
               is_number(word);
    }

    void read_title(std::string_view text) {
        text = trimmed(text);
        if (text.size() >= 2 && text.front() == '"') {
            const std::size_t close = text.find('"', 1);
            text = text.substr(1, close == std::string_view::npos ? close : close - 1);
        }
        if (text.size() > limits::max_title_bytes) {
            fail("the title is longer than " + std::to_string(limits::max_title_bytes) + " bytes",
                 text);
        }
        lut_.title = text;
    }

    void read_row(const Words& words, std::string_view line) {
        if (words.count != 3) {
            const bool commas = words.items[0].find(',') != std::string_view::npos;
            fail("a row needs 3 numbers, this one has " + std::to_string(words.count) +
                     (commas ? "; separate them by blanks, not commas" : ""),
                 line);
        }
        Rgb row;
        for (std::size_t c = 0; c < 3; ++c) {
            row[c] = read_value(words, c, line);
        }
        note_form(words, line);
        if (!table_) {
            if (!shaper_size_ && !cube_size_) {
                fail("a row of numbers before LUT_1D_SIZE or LUT_3D_SIZE", line);
            }
            fail("the table is overlong: " + expected_rows() + " are complete before this row",
                 line);
        }
        (*table_)[filled_++] = row;
        next_table_when_full();
    }

    // What of a row's form makes other readers, or its writer's end, suspect.
    void note_form(const Words& words, std::string_view line) {
        const auto any_has = [&](char c) {
            return std::any_of(words.items.begin(), words.items.begin() + 3,
                               [c](std::string_view w) { return w.find(c) != w.npos; });
        };
        const bool commas = any_has(',');
        if (commas && any_has('.')) {
            fail("a row with decimal commas and decimal points; write all of them as points", line);
        }
        if (commas && !has_commas_) {
            has_commas_ = true;
            lut_.notes.push_back("line " + std::to_string(lines_.line_number()) +
                                 ": decimal commas, read as points; other readers stop at a comma: "
                                 "hand them what 'lutconv convert' writes");
        }
        const std::size_t digits = decimals_of(words.items[0]);
        const bool is_short = decimals_of(words.items[2]) < digits;
        if (is_last_and_open(line) && is_short && digits > 3 &&
            decimals_of(words.items[1]) == digits) {
            lut_.notes.push_back("line " + std::to_string(lines_.line_number()) +
                                 ": the file ends without a line end in a number that has fewer "
                                 "decimals than its neighbours; if it was cut there, get it anew");
        }
    }

    bool is_last_and_open(std::string_view line) const {
        return lines_.rest().data() == line.data() + line.size();
    }

    void read_keyword(const Words& words, std::string_view line) {
        const std::string keyword = upper(words.items[0]);
        if (keyword == "LUT_1D_SIZE") {
            shaper_size_ = read_size(shaper_size_, words, line, check_shaper_size);
            const auto n = static_cast<std::size_t>(*shaper_size_);
            check_room_for(n, line);
            lut_.shaper.emplace().entries.resize(n);
            choose_table();
        } else if (keyword == "LUT_3D_SIZE") {
            cube_size_ = read_size(cube_size_, words, line, check_cube_size);
            const auto n = static_cast<std::size_t>(*cube_size_);
            check_room_for(n * n * n, line);
            Lut3D& cube = lut_.cube.emplace();
            cube.size = *cube_size_;
            cube.nodes.resize(n * n * n);
            choose_table();
        } else if (!domains_.take({file_, lines_.line_number(), line, words})) {
            read_unknown(words, line);
        }
    }

    // Among the rows of a table it is a damaged row, and so it is where it looks like one.
    void read_unknown(const Words& words, std::string_view line) {
        const bool keyword = may_be_keyword(words.items[0]);
        const bool row = !keyword && words.count == 3 && is_number(words.items[1]);
        if (row || (table_ && rows_begun())) {
            fail("neither a row of 3 numbers nor a keyword", line);
        }
        // Written first into a file, such a line would make it another thing's.
        const bool kept = keyword && !begins_as_mistaken(line);
        (kept ? lut_.keywords : lut_.comments).emplace_back(line);
    }

    int read_size(std::optional<int> before, const Words& words, std::string_view line,
                  void (*check)(long long)) {
        if (before) {
            fail("a second " + std::string(words.items[0]) + "; a file has one", line);
        }
        if (rows_begun()) {
            fail(std::string(words.items[0]) + " after the first row; it must stand before", line);
        }
        long long size = 0;
        const std::string_view word = words.items[1];
        const auto [stop, status] = std::from_chars(word.data(), word.data() + word.size(), size);
        if (words.count != 2 || status != std::errc{} || stop != word.data() + word.size()) {
            fail(std::string(words.items[0]) + " needs one whole number", line);
        }
        try {
            check(size);
        } catch (const Error& error) {
            fail(error.message(), line);
        }
        return static_cast<int>(size);
    }

    // A few bytes must not make the reader allocate a large table only to find it truncated.
    void check_room_for(std::size_t rows, std::string_view line) const {
        constexpr std::size_t shortest_row = 6; // "0 0 0" and a line end, which the last may lack
        const std::size_t room = (lines_.remaining() + 1) / shortest_row;
        if (rows > room) {
            fail("the table is truncated: " + std::to_string(rows) +
                     " rows are needed, the rest of the file has room for at most " +
                     std::to_string(room) + " of 3 numbers",
                 line);
        }
    }

    float read_value(const Words& words, std::size_t word, std::string_view line) {
        float value = 0;
        const bool keep =
            keep_non_finite_ && parse_float(words.items[word], value) == NumberStatus::not_finite;
        return keep ? std::numeric_limits<float>::quiet_NaN()
                    : PlacedLine{file_, lines_.line_number(), line, words}.number_at(word);
    }

    std::string expected_rows() const {
        std::string text;
        if (shaper_size_) {
            text = std::to_string(*shaper_size_) + " rows of the 1D table";
        }
        if (cube_size_) {
            text += (text.empty() ? "" : " and ") + std::to_string(lut_.cube->nodes.size()) +
                    " rows of the 3D table";
        }
        return text;
    }

    bool rows_begun() const { return filled_ > 0 || a_table_is_full_; }

    void choose_table() { table_ = lut_.shaper ? &lut_.shaper->entries : &lut_.cube->nodes; }

    void next_table_when_full() {
        if (filled_ < table_->size()) {
            return;
        }
        const bool cube_follows = lut_.cube && table_ != &lut_.cube->nodes;
        table_ = cube_follows ? &lut_.cube->nodes : nullptr;
        a_table_is_full_ = true;
        filled_ = 0;
    }

    Lut finish() {
        if (!shaper_size_ && !cube_size_) {
            fail("neither LUT_3D_SIZE nor LUT_1D_SIZE was found: this is not a .cube", {});
        }
        if (table_) {
            fail("the table is truncated: " + expected_rows() + " are needed, the file ends " +
                     std::to_string(table_->size() - filled_) + " rows early in the " +
                     (lut_.cube && table_ == &lut_.cube->nodes ? "3D" : "1D") + " table",
                 {});
        }
        domains_.give_to(lut_, file_);
        lut_.provenance = file_;
        scale_integer_codes(lut_);
        return std::move(lut_);
    }

    LineScanner lines_;
    const std::string& file_;
    bool keep_non_finite_;
    Lut lut_;
    std::optional<int> shaper_size_, cube_size_;
    std::vector<Rgb>* table_ = nullptr; // being filled; null before the sizes and after the last
    std::size_t filled_ = 0;
    bool a_table_is_full_ = false, has_commas_ = false;
    CubeDomains domains_;
};

Lut read(std::string_view bytes, const std::string& file, bool keep_non_finite) {
    if (const std::optional<std::string> utf8 = utf8_of_utf16(bytes)) {
        return CubeReader(LineScanner(*utf8), *utf8, file, keep_non_finite).read();
    }
    return CubeReader(LineScanner(bytes), bytes, file, keep_non_finite).read();
}

} // namespace

Lut read_cube(std::string_view bytes, const std::string& file) {
    return read(bytes, file, false);
}

Lut read_cube_in_pieces(std::string_view head, ByteSource& more, const std::string& file) {
    return CubeReader(LineScanner(head, more), head, file).read();
}

bool has_decimal_commas(std::string_view text) {
    LineScanner lines(text);
    for (std::string_view line; lines.next(line);) {
        const Words words = words_of(line);
        if (words.count == 3 && is_number(words.items[0]) && is_number(words.items[2])) {
            if (line.find(',') != std::string_view::npos) {
                return true;
            }
        }
    }
    return false;
}

Lut read_broken_cube(std::string_view bytes, const std::string& file) {
    return read(bytes, file, true);
}

} // namespace lutlib
