#include "lutlib/recipe/correction_file.h"

#include "lutlib/error.h"
#include "lutlib/named.h"
#include "lutlib/number_text.h"
#include "lutlib/recipe/xml_walk.h"
#include "lutlib/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>

namespace lutlib {
namespace {

constexpr std::string_view correction_element = "ColorCorrection";
constexpr std::size_t most_corrections = 100000, deepest = 32;

constexpr CorrectionFormat formats[] = {
    {"cc", "ASC CDL: one correction", correction_element},
    {"ccc", "ASC CDL: a collection of corrections", "ColorCorrectionCollection"},
    {"cdl", "ASC CDL: a decision list", "ColorDecisionList", "ColorDecision"},
};

const CorrectionFormat* format_of_root(std::string_view root) {
    const auto* const found =
        std::find_if(std::begin(formats), std::end(formats),
                     [&](const CorrectionFormat& row) { return row.root == root; });
    return found != std::end(formats) ? found : nullptr;
}

// The elements with numbers, and where they go.
struct NumberElement {
    std::string_view name;
    RgbD ColorCorrection::*three = nullptr;
    double ColorCorrection::*one = nullptr;
};
constexpr NumberElement number_elements[] = {
    {"Slope", &ColorCorrection::slope},
    {"Offset", &ColorCorrection::offset},
    {"Power", &ColorCorrection::power},
    {"Saturation", nullptr, &ColorCorrection::saturation},
};

struct FoundCorrection {
    ColorCorrection correction;
    std::size_t begin = 0, end = 0; ///< bytes of its element
};

struct Found {
    std::vector<FoundCorrection> corrections;
    const CorrectionFormat* format = nullptr;
    std::size_t root_end = 0; ///< where the root's closing tag begins
};

// Without XML's blanks at both ends.
std::string_view stripped(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == text.npos ? std::string_view()
                              : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::optional<double> number(std::string_view word) {
    word.remove_prefix(word.starts_with('+') ? 1 : 0);
    double out = 0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), out);
    const bool is_read = read.ec == std::errc() && read.ptr == word.data() + word.size();
    return is_read && std::isfinite(out) ? std::optional(out) : std::nullopt;
}

class Reader {
  public:
    Reader(std::string_view text, const std::string& file) : walk_(text, file) {}

    Found read() {
        while (true) {
            const XmlPiece piece = walk_.next();
            if (piece.kind == XmlPiece::Kind::end) {
                break;
            }
            take(piece);
        }
        if (out_.format == nullptr || !path_.empty()) {
            walk_.refuse("the file is cut short or damaged; fetch or export it again");
        }
        if (out_.corrections.empty()) {
            walk_.refuse("there is no ColorCorrection in it");
        }
        return std::move(out_);
    }

  private:
    void take(const XmlPiece& piece) {
        if (piece.kind == XmlPiece::Kind::open) {
            open(piece);
            if (piece.is_empty) {
                close(piece);
            }
        } else if (piece.kind == XmlPiece::Kind::close) {
            close(piece);
        } else if (path_.empty() && !stripped(piece.text).empty()) {
            walk_.refuse("this is no file of ASC CDL corrections", stripped(piece.text));
        } else {
            text_ += piece.text;
        }
    }

    void open(const XmlPiece& piece) {
        if (path_.empty()) {
            out_.format = out_.format == nullptr ? format_of_root(piece.name) : nullptr;
            if (out_.format == nullptr) {
                walk_.refuse("this is no file of ASC CDL corrections: its root is no "
                             "ColorCorrection, ColorCorrectionCollection or ColorDecisionList",
                             piece.name);
            }
        }
        if (path_.size() == deepest) {
            walk_.refuse("its elements lie too deep in each other", piece.name);
        }
        if (piece.name == correction_element) {
            if (inside_ || out_.corrections.size() == most_corrections) {
                walk_.refuse(inside_ ? "a ColorCorrection lies in another" : "it has too many");
            }
            inside_ = true;
            out_.corrections.push_back({{}, piece.begin, 0});
            current().id = attribute_of(piece, "id");
            if (!current().id.empty() && !ids_.insert(current().id).second) {
                walk_.refuse("two corrections have one id: give each its own", current().id);
            }
        }
        path_.emplace_back(piece.name);
        text_.clear();
    }

    void close(const XmlPiece& piece) {
        if (path_.empty() || path_.back() != piece.name) {
            walk_.refuse("the file is damaged: an element is closed that is not open", piece.name);
        }
        path_.pop_back();
        out_.root_end = path_.empty() ? piece.begin : out_.root_end;
        if (!inside_) {
            return;
        }
        if (piece.name == correction_element) {
            inside_ = false;
            out_.corrections.back().end = piece.end;
        } else if (piece.name == "Description" && current().description.empty()) {
            current().description = std::string(stripped(text_));
        } else {
            take_numbers(piece.name);
        }
        text_.clear();
    }

    void take_numbers(std::string_view name) {
        const auto* const row =
            std::find_if(std::begin(number_elements), std::end(number_elements),
                         [&](const NumberElement& element) { return element.name == name; });
        if (row == std::end(number_elements)) {
            return;
        }
        std::replace_if(
            text_.begin(), text_.end(), [](char c) { return c == '\r' || c == '\n'; }, ' ');
        const Words words = words_of(text_);
        const std::size_t count = row->three != nullptr ? 3 : 1;
        RgbD numbers{};
        for (std::size_t i = 0; i < count; ++i) {
            const auto read = words.count == count ? number(words.items[i]) : std::nullopt;
            if (!read) {
                walk_.refuse(std::string(name) + " needs " +
                                 (count == 3 ? "three numbers" : "one number"),
                             stripped(text_));
            }
            numbers[i] = *read;
        }
        if (row->three != nullptr) {
            current().*row->three = numbers;
        } else {
            current().*row->one = numbers[0];
        }
    }

    ColorCorrection& current() { return out_.corrections.back().correction; }

    XmlWalk walk_;
    std::vector<std::string> path_; ///< elements that are open
    std::string text_;              ///< of the innermost
    std::set<std::string> ids_;
    bool inside_ = false; ///< a correction
    Found out_;
};

Found found_in(std::string_view text, const std::string& file) {
    return Reader(text, file).read();
}

std::string three(RgbD c) {
    return shortest(c.r) + " " + shortest(c.g) + " " + shortest(c.b);
}

// XML 1.0 has no place for control characters, and readers trim blanks.
void require_writable(const std::string& text, const char* what) {
    if (std::any_of(text.begin(), text.end(),
                    [](char c) { return static_cast<unsigned char>(c) < 0x20; })) {
        throw UsageError(std::string("write the ") + what +
                         " without control characters: XML holds none");
    }
}

// Its lines, each behind so many blanks.
std::string element_text(const ColorCorrection& c, std::size_t indent, std::string_view more) {
    require_writable(c.id, "id");
    require_writable(c.description, "description");
    std::string out;
    const auto line = [&](std::size_t deeper, const std::string& text) {
        out += std::string(indent + deeper, ' ') + text + "\n";
    };
    line(0, "<ColorCorrection" + (c.id.empty() ? "" : " id=\"" + xml_escaped(c.id) + "\"") +
                std::string(more) + ">");
    line(2, "<SOPNode>");
    if (!c.description.empty()) {
        line(4, "<Description>" + xml_escaped(c.description) + "</Description>");
    }
    line(4, "<Slope>" + three(c.slope) + "</Slope>");
    line(4, "<Offset>" + three(c.offset) + "</Offset>");
    line(4, "<Power>" + three(c.power) + "</Power>");
    line(2, "</SOPNode>");
    line(2, "<SatNode>");
    line(4, "<Saturation>" + shortest(c.saturation) + "</Saturation>");
    line(2, "</SatNode>");
    line(0, "</ColorCorrection>");
    return out;
}

std::size_t indent_of(const CorrectionFormat& format) {
    return format.around.empty() ? 2 : 4;
}

std::string wrapped(const ColorCorrection& correction, const CorrectionFormat& format) {
    const std::string element = element_text(correction, indent_of(format), {});
    const std::string name(format.around);
    return name.empty() ? element : "  <" + name + ">\n" + element + "  </" + name + ">\n";
}

// The file between its begin and its end.
template <class Corrections>
std::string whole_file(const CorrectionFormat& format, const Corrections& corrections) {
    const std::string root(format.root), declared = " xmlns=\"urn:ASC:CDL:v1.2\"";
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    out += format.holds_many() ? "<" + root + declared + ">\n" : "";
    for (const FoundCorrection& row : corrections) {
        out += format.holds_many() ? wrapped(row.correction, format)
                                   : element_text(row.correction, 0, declared);
    }
    return out + (format.holds_many() ? "</" + root + ">\n" : "");
}

} // namespace

std::span<const CorrectionFormat> correction_formats() {
    return formats;
}

const CorrectionFormat* correction_format_of(const std::string& file) {
    const std::string extension = upper(std::filesystem::path(file).extension().string());
    const auto* const found =
        std::find_if(std::begin(formats), std::end(formats), [&](const CorrectionFormat& row) {
            return extension == "." + upper(row.extension);
        });
    return found != std::end(formats) ? found : nullptr;
}

std::vector<ColorCorrection> parse_corrections(std::string_view text, const std::string& file) {
    if (const std::optional<std::string> utf8 = utf8_of_utf16(text)) {
        return parse_corrections(*utf8, file);
    }
    std::vector<ColorCorrection> out;
    for (FoundCorrection& found : found_in(text, file).corrections) {
        out.push_back(std::move(found.correction));
    }
    return out;
}

std::size_t correction_named(std::span<const ColorCorrection> corrections, const std::string& id) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < corrections.size(); ++i) {
        names.push_back(name_of(corrections, i));
        if (id.empty() || names.back() == id) {
            return i;
        }
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    refuse_name("correction", id, views);
}

std::string name_of(std::span<const ColorCorrection> corrections, std::size_t at) {
    const std::string& id = corrections[at].id;
    return id.empty() ? "correction " + std::to_string(at + 1) : id;
}

std::string correction_text(const ColorCorrection& correction, const CorrectionFormat& format) {
    return whole_file(format, std::array{FoundCorrection{correction}});
}

std::string with_correction(std::string_view text, const std::string& file,
                            const ColorCorrection& correction) {
    const Found found = found_in(text, file);
    if (!found.format->holds_many()) {
        throw Error("it is a file of one correction", {file, 0, {}});
    }
    const auto same = std::find_if(
        found.corrections.begin(), found.corrections.end(),
        [&](const FoundCorrection& row) { return row.correction.id == correction.id; });
    std::string out(text);
    if (same == found.corrections.end()) {
        // In front of the blanks before the root's end.
        const std::size_t at = text.find_last_not_of(" \t", found.root_end - 1) + 1;
        const bool begins_line = text[at - 1] == '\n';
        return out.insert(at, (begins_line ? "" : "\n") + wrapped(correction, *found.format));
    }
    const std::size_t indent = indent_of(*found.format);
    std::string element = element_text(correction, indent, {});
    element.pop_back(); // the line's end stands behind the one that was there
    return out.replace(same->begin, same->end - same->begin, element.substr(indent));
}

bool is_correction_text(std::string_view text, const std::string& file) {
    const Found found = found_in(text, file);
    return whole_file(*found.format, found.corrections) == text;
}

} // namespace lutlib
