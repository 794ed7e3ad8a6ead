// Values as bytes to compare.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace preview {

class ByteText {
  public:
    template <class T>
    void add(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>,
                      "padding would be compared");
        text_.append(reinterpret_cast<const char*>(&value), sizeof(T));
    }
    /// With its length, so that neighbours cannot run into each other.
    void add_text(std::string_view text) {
        add(text.size());
        text_ += text;
    }
    std::string take() { return std::move(text_); }

  private:
    std::string text_;
};

} // namespace preview
