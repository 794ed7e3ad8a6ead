// What a stream can show: colours and a width on a terminal, neither of them in a pipe or a file.
#pragma once

#include <cstddef>
#include <string>

namespace terminal {

/// Text in the colours of a terminal, or as it is.
class Style {
  public:
    explicit Style(bool has_color = false) : has_color_(has_color) {}

    std::string name(const std::string& text) const;    ///< of a row: bold
    std::string heading(const std::string& text) const; ///< over rows: underlined
    std::string bad(const std::string& text) const;     ///< bold red

  private:
    std::string marked(const char* mark, const std::string& text) const;

    bool has_color_;
};

/// Of an open file: colours where it is a terminal that has them, unless NO_COLOR is set and not
/// empty (https://no-color.org).
Style style_of(int descriptor);

/// The columns of the terminal that it is, by COLUMNS or by the terminal itself; 0 where it is none
/// or they are not known.
std::size_t columns_of(int descriptor);

} // namespace terminal
