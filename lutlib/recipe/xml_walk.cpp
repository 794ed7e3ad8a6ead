#include "lutlib/recipe/xml_walk.h"

#include "lutlib/error.h"
#include "lutlib/text.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace lutlib {
namespace {

constexpr std::string_view blanks = " \t\r\n";

struct Entity {
    std::string_view name;
    char character;
};
constexpr Entity entities[] = {
    {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}};

void append_utf8(std::string& out, std::uint32_t code) {
    const auto byte = [&](std::uint32_t value) { out += static_cast<char>(value); };
    if (code < 0x80U) {
        byte(code);
    } else if (code < 0x800U) {
        byte(0xC0U | code >> 6U);
        byte(0x80U | (code & 0x3FU));
    } else if (code < 0x10000U) {
        byte(0xE0U | code >> 12U);
        byte(0x80U | (code >> 6U & 0x3FU));
        byte(0x80U | (code & 0x3FU));
    } else {
        byte(0xF0U | code >> 18U);
        byte(0x80U | (code >> 12U & 0x3FU));
        byte(0x80U | (code >> 6U & 0x3FU));
        byte(0x80U | (code & 0x3FU));
    }
}

// "&#233;" or "&#xe9;" at the front; how many bytes it takes, 0 where it is none.
std::size_t append_numbered(std::string& out, std::string_view text) {
    const std::size_t end = text.find(';');
    if (!text.starts_with("&#") || end == text.npos) {
        return 0;
    }
    const bool is_hexadecimal = text[2] == 'x';
    const char* const first = text.data() + (is_hexadecimal ? 3 : 2);
    const char* const last = text.data() + end;
    std::uint32_t code = 0;
    const auto read = std::from_chars(first, last, code, is_hexadecimal ? 16 : 10);
    if (read.ec != std::errc() || read.ptr != last || code == 0 || code > 0x10FFFFU ||
        (code >= 0xD800U && code < 0xE000U)) {
        return 0;
    }
    append_utf8(out, code);
    return end + 1;
}

// An ampersand that begins nothing known stays one.
std::string decoded(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view rest = text.substr(at);
        const auto* const entity =
            std::find_if(std::begin(entities), std::end(entities),
                         [&](const Entity& row) { return rest.starts_with(row.name); });
        if (entity != std::end(entities)) {
            out += entity->character;
            at += entity->name.size();
        } else if (const std::size_t taken = append_numbered(out, rest); taken > 0) {
            at += taken;
        } else {
            out += text[at++];
        }
    }
    return out;
}

std::string_view without_prefix(std::string_view name) {
    const std::size_t colon = name.find(':');
    return colon == name.npos ? name : name.substr(colon + 1);
}

} // namespace

XmlWalk::XmlWalk(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    at_ = text_.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
}

void XmlWalk::refuse(const std::string& why, std::string_view what) const {
    throw Error(why, {file_, line_, std::string(what.substr(0, 80))});
}

void XmlWalk::skip_to_behind(std::string_view end, const char* why) {
    const std::size_t found = text_.find(end, at_);
    if (found == text_.npos) {
        refuse(why);
    }
    at_ = found + end.size();
}

XmlPiece XmlWalk::element() {
    XmlPiece out;
    out.begin = at_;
    // A > within an attribute's quotes ends nothing.
    char quote = 0;
    std::size_t end = at_ + 1;
    for (; end < text_.size() && (quote != 0 || text_[end] != '>'); ++end) {
        const char c = text_[end];
        quote = quote == c ? char{0} : quote == 0 && (c == '"' || c == '\'') ? c : quote;
    }
    if (end >= text_.size()) {
        refuse("a tag does not end: the file is cut short or damaged; fetch or export it again");
    }
    std::string_view inside = text_.substr(at_ + 1, end - at_ - 1);
    out.kind = inside.starts_with('/') ? XmlPiece::Kind::close : XmlPiece::Kind::open;
    inside.remove_prefix(out.kind == XmlPiece::Kind::close ? 1 : 0);
    if (out.kind == XmlPiece::Kind::open && inside.ends_with('/')) {
        out.is_empty = true;
        inside.remove_suffix(1);
    }
    const std::size_t name_end = std::min(inside.find_first_of(blanks), inside.size());
    out.name = without_prefix(inside.substr(0, name_end));
    out.attributes = inside.substr(name_end);
    at_ = out.end = end + 1;
    return out;
}

XmlPiece XmlWalk::next() {
    constexpr const char* no_end = "a comment or an instruction does not end: the file is cut "
                                   "short or damaged; fetch or export it again";
    while (at_ < text_.size()) {
        line_ += static_cast<std::size_t>(
            std::count(text_.begin() + static_cast<std::ptrdiff_t>(counted_),
                       text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n'));
        counted_ = at_;
        const std::string_view rest = text_.substr(at_);
        XmlPiece out;
        if (rest.starts_with("<!--")) {
            skip_to_behind("-->", no_end);
            continue;
        }
        if (rest.starts_with("<?")) {
            skip_to_behind("?>", no_end);
            continue;
        }
        if (rest.starts_with("<![CDATA[")) {
            constexpr std::size_t before = 9, behind = 3;
            const std::size_t begin = at_;
            skip_to_behind("]]>", no_end);
            out.text = std::string(text_.substr(begin + before, at_ - begin - before - behind));
            out.begin = begin;
        } else if (rest.starts_with("<!")) {
            refuse("take its DOCTYPE out: it is not followed", rest.substr(0, rest.find('>')));
        } else if (rest.starts_with('<')) {
            out = element();
        } else {
            const std::size_t end = std::min(text_.find('<', at_), text_.size());
            out.text = decoded(text_.substr(at_, end - at_));
            out.begin = at_;
            at_ = end;
        }
        if (out.kind == XmlPiece::Kind::end) {
            out.kind = XmlPiece::Kind::text;
            out.end = at_;
        }
        out.line = line_;
        return out;
    }
    XmlPiece out;
    out.begin = out.end = at_;
    out.line = line_;
    return out;
}

std::string attribute_of(const XmlPiece& element, std::string_view name) {
    std::string_view rest = element.attributes;
    while (true) {
        const std::size_t equals = rest.find('=');
        const std::size_t quote = rest.find_first_of("\"'", equals);
        if (equals == rest.npos || quote == rest.npos) {
            return {};
        }
        const std::size_t end = rest.find(rest[quote], quote + 1);
        if (end == rest.npos) {
            return {};
        }
        if (trimmed(rest.substr(0, equals)).find_first_of(blanks) == rest.npos &&
            without_prefix(trimmed(rest.substr(0, equals))) == name) {
            return decoded(rest.substr(quote + 1, end - quote - 1));
        }
        rest.remove_prefix(end + 1);
    }
}

std::string xml_escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const auto* const entity =
            std::find_if(std::begin(entities), std::end(entities),
                         [c](const Entity& row) { return row.character == c; });
        if (entity != std::end(entities)) {
            out += entity->name;
        } else {
            out += c;
        }
    }
    return out;
}

} // namespace lutlib
