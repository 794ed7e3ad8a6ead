// What of XML small files of numbers use: elements, attributes, texts, comments. No DOCTYPE, hence
// no entities of a file's own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace lutlib {

struct XmlPiece {
    enum class Kind : std::uint8_t { open, close, text, end };
    Kind kind = Kind::end;
    std::string_view name{};        ///< of an element, without its prefix
    std::string_view attributes{};  ///< of an element that opens, as they stand
    bool is_empty = false;          ///< an element that opens and closes: <a/>
    std::string text{};             ///< characters, decoded
    std::size_t begin = 0, end = 0; ///< its bytes
    std::size_t line = 0;           ///< from 1
};

/// Piece by piece. Throws Error with the line for what is no such text.
class XmlWalk {
  public:
    XmlWalk(std::string_view text, std::string file);
    XmlPiece next();

    /// The error at the piece that came last.
    [[noreturn]] void refuse(const std::string& why, std::string_view what = {}) const;

  private:
    XmlPiece element();
    void skip_to_behind(std::string_view end, const char* why);

    std::string_view text_;
    std::string file_;
    std::size_t at_ = 0, counted_ = 0, line_ = 1;
};

/// The attribute's value, decoded; empty where the element has none.
std::string attribute_of(const XmlPiece& element, std::string_view name);

/// Characters as XML writes them, in a text or an attribute.
std::string xml_escaped(std::string_view text);

} // namespace lutlib
