#include "lutlib/formats/threedl.h"

#include "lutlib/error.h"
#include "lutlib/formats/integer_codes.h"
#include "lutlib/formats/mistaken.h"
#include "lutlib/limits.h"
#include "lutlib/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace lutlib {
namespace {

constexpr std::size_t longest_mesh = 65536;

std::optional<int> whole_number(std::string_view word) {
    int value = 0;
    const auto [stop, status] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = status == std::errc{} && stop == word.data() + word.size();
    return whole ? std::optional(value) : std::nullopt;
}

std::vector<std::string_view> all_words(std::string_view line) {
    std::vector<std::string_view> out;
    for (std::string_view rest = trimmed(line); !rest.empty();) {
        const std::string_view word = words_of(rest).items[0];
        out.push_back(word);
        rest = trimmed(rest.substr(word.size()));
    }
    return out;
}

/// What OpenColorIO takes codes for.
int likely_depth(int largest) {
    return largest <= 511 ? 8 : largest <= 2047 ? 10 : largest <= 8191 ? 12 : 16;
}

struct Declared {
    int bits = 0; ///< 0: nothing is declared
    std::size_t line = 0;
};

class ThreedlReader {
  public:
    ThreedlReader(std::string_view bytes, const std::string& file) : lines_(bytes), file_(file) {
        if (bytes.substr(0, 4096).find('\0') != std::string_view::npos) {
            throw Error("this is a binary file, not a .3dl text", {file_, 0, {}});
        }
    }

    Lut read() {
        std::string_view line;
        while (lines_.next(line)) {
            line = trimmed(line);
            if (!line.empty()) {
                line.front() == '#' ? read_comment(trimmed(line.substr(1))) : read_line(line);
            }
        }
        return finish();
    }

  private:
    [[noreturn]] void fail(const std::string& message, std::string_view text) const {
        throw Error(message, {file_, lines_.line_number(), std::string(text)});
    }

    void read_comment(std::string_view comment) {
        declare_depths(comment);
        lut_.comments.emplace_back(comment);
    }

    /// Whether the line speaks of a depth; some writers leave out the comment's mark.
    bool declare_depths(std::string_view line) {
        const std::string text = upper(line);
        const bool of_output = declare(output_, text, "OUTPUT BIT DEPTH");
        return declare(input_, text, "INPUT BIT DEPTH") || of_output;
    }

    bool declare(Declared& declared, const std::string& text, std::string_view words) {
        const std::size_t at = text.find(words);
        if (at == std::string::npos) {
            return false;
        }
        const std::size_t digits = text.find_first_of("0123456789", at + words.size());
        const std::size_t between = text.find_first_not_of(" \t:=", at + words.size());
        if (digits != std::string::npos && digits == between) {
            const std::size_t end = text.find_first_not_of("0123456789", digits);
            return set_depth(declared,
                             whole_number(std::string_view(text).substr(digits, end - digits)));
        }
        return false;
    }

    bool set_depth(Declared& declared, std::optional<int> bits) {
        const bool is_depth = bits && *bits >= 8 && *bits <= 16;
        if (is_depth) {
            declared = {*bits, lines_.line_number()};
        }
        return is_depth;
    }

    void read_line(std::string_view line) {
        if (line.front() == '<') {
            fail("a .3dl has no line that begins with '<'; is this another format?", line);
        }
        const std::vector<std::string_view> words = all_words(line);
        std::vector<int> numbers;
        for (const std::string_view word : words) {
            if (const auto number = whole_number(word)) {
                numbers.push_back(*number);
            }
        }
        if (numbers.size() == words.size()) {
            read_numbers(numbers, line);
        } else {
            read_words(words, line);
        }
    }

    void read_words(const std::vector<std::string_view>& words, std::string_view line) {
        float ignored = 0;
        if (parse_float(words[0], ignored) != NumberStatus::not_a_number) {
            fail("a .3dl holds whole numbers; this line has others", line);
        }
        const std::string keyword = upper(words[0]);
        if (keyword == "MESH") {
            const bool two = words.size() == 3 && whole_number(words[1]) && whole_number(words[2]);
            if (!two) {
                fail("Mesh needs two whole numbers, the bits of its nodes and of its codes", line);
            }
            set_depth(output_, whole_number(words[2]));
            return;
        }
        const bool plain_gamma = keyword == "GAMMA" && words.size() == 2 &&
                                 parse_float(words[1], ignored) == NumberStatus::ok && ignored == 1;
        if (keyword != "3DMESH" && !keyword.starts_with("LUT") && !plain_gamma &&
            !declare_depths(line)) {
            lut_.keywords.emplace_back(line);
        }
    }

    void read_numbers(const std::vector<int>& numbers, std::string_view line) {
        if (numbers.size() > 3) {
            if (!mesh_.empty() || !rows_.empty()) {
                fail("a second mesh line, or a row of more than 3 numbers", line);
            }
            if (numbers.size() > longest_mesh) {
                fail("the mesh line has more than " + std::to_string(longest_mesh) + " numbers",
                     {});
            }
            mesh_ = numbers;
            return;
        }
        if (numbers.size() < 3) {
            fail(rows_.empty() && mesh_.empty()
                     ? "a .3dl begins with its mesh line or a row of 3 numbers; if this is the "
                       "number of nodes per axis, delete the line"
                     : "a row needs 3 numbers, this one has " + std::to_string(numbers.size()),
                 line);
        }
        if (rows_.size() >= most_rows) {
            fail("the table is longer than " + std::to_string(limits::max_cube_size) + "^3 rows",
                 {});
        }
        for (const int number : numbers) {
            largest_ = std::max(largest_, number);
        }
        rows_.push_back({static_cast<float>(numbers[0]), static_cast<float>(numbers[1]),
                         static_cast<float>(numbers[2])});
    }

    int cube_size() const {
        const int n = static_cast<int>(std::lround(std::cbrt(static_cast<double>(rows_.size()))));
        const auto side = static_cast<std::size_t>(n);
        if (n < limits::min_cube_size || side * side * side != rows_.size()) {
            throw Error(
                "the table has " + std::to_string(rows_.size()) +
                    " rows, which is not a cube of any size; the file is cut off or damaged" +
                    (mesh_.empty()
                         ? ""
                         : " (" + std::to_string(mesh_.size()) + " nodes per axis need " +
                               std::to_string(mesh_.size() * mesh_.size() * mesh_.size()) + ")"),
                {file_, lines_.line_number(), {}});
        }
        return n;
    }

    // The file's word counts, unless its codes are far beyond it; those up to twice white
    // overshoot.
    int depth() {
        const int likely = likely_depth(largest_);
        const std::string largest = "its largest code, " + std::to_string(largest_);
        if (output_.bits > 0 && largest_ < 2 * (largest_code(output_.bits) + 1)) {
            if (likely != output_.bits) {
                lut_.notes.push_back("read as " + std::to_string(output_.bits) +
                                     "-bit codes, as line " + std::to_string(output_.line) +
                                     " declares; programs that go by " + largest +
                                     ", take them for " + std::to_string(likely) + " bits");
            }
            return output_.bits;
        }
        if (largest_ < least_largest_code) {
            throw Error(largest + ", is below " + std::to_string(least_largest_code) +
                            ": no depth has so small codes; is this another format?",
                        {file_, 0, {}});
        }
        lut_.notes.push_back((output_.bits > 0 ? "line " + std::to_string(output_.line) +
                                                     " declares " + std::to_string(output_.bits) +
                                                     " bits, which " + largest + ", is far beyond"
                                               : "no depth is declared") +
                             ": guessed " + std::to_string(likely) + " bits from " +
                             (output_.bits > 0 ? "it" : largest));
        return likely;
    }

    // As OpenColorIO reads it: a table of the input, if it is not even within two codes.
    void read_mesh() {
        const int largest = *std::max_element(mesh_.begin(), mesh_.end());
        if (largest < least_largest_code) {
            throw Error("the mesh line's largest number, " + std::to_string(largest) +
                            ", is too small for any depth; is this another format?",
                        {file_, 0, {}});
        }
        const double top = largest_code(input_.bits > 0 ? input_.bits : likely_depth(largest));
        const double step = top / static_cast<double>(mesh_.size() - 1);
        bool even = true;
        for (std::size_t i = 0; i < mesh_.size(); ++i) {
            even = even && std::abs(static_cast<double>(i) * step - mesh_[i]) < 2;
        }
        if (even && !rows_.empty()) {
            return;
        }
        Lut1D& shaper = lut_.shaper.emplace();
        for (const int code : mesh_) {
            const auto value = static_cast<float>(code / top);
            shaper.entries.push_back({value, value, value});
        }
        lut_.notes.push_back("the mesh line is not an even ramp; it is read as a 1D table of the "
                             "input, as OpenColorIO does");
    }

    Lut finish() {
        if (rows_.empty() && mesh_.empty()) {
            throw Error("neither a mesh line nor a row of 3 whole numbers: this is not a .3dl",
                        {file_, 0, {}});
        }
        if (!rows_.empty()) {
            Lut3D cube;
            cube.size = cube_size();
            check_cube_size(cube.size);
            const double top = largest_code(depth());
            cube.nodes.resize(rows_.size());
            std::size_t next = 0;
            for (int r = 0; r < cube.size; ++r) {
                for (int g = 0; g < cube.size; ++g) {
                    for (int b = 0; b < cube.size; ++b) {
                        const Rgb& row = rows_[next++];
                        Rgb& node = cube.at(r, g, b);
                        for (std::size_t c = 0; c < 3; ++c) {
                            node[c] = static_cast<float>(static_cast<double>(row[c]) / top);
                        }
                    }
                }
            }
            lut_.cube = std::move(cube);
        }
        if (!mesh_.empty()) {
            read_mesh();
        }
        lut_.provenance = file_;
        return std::move(lut_);
    }

    static constexpr std::size_t most_rows =
        std::size_t{limits::max_cube_size} * limits::max_cube_size * limits::max_cube_size;

    LineScanner lines_;
    const std::string& file_;
    Lut lut_;
    Declared output_, input_;
    std::vector<int> mesh_;
    std::vector<Rgb> rows_;
    int largest_ = 0;
};

} // namespace

Lut read_threedl(std::string_view bytes, const std::string& file) {
    refuse_mistaken_file(bytes, file);
    if (const std::optional<std::string> utf8 = utf8_of_utf16(bytes)) {
        return ThreedlReader(*utf8, file).read();
    }
    return ThreedlReader(bytes, file).read();
}

} // namespace lutlib
