// Samples of a picture, of any type.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

namespace lutlib::io {

/// Bytes that are not cleared before they are written, which would take as long as a look.
class SampleBuffer {
  public:
    SampleBuffer() = default;
    explicit SampleBuffer(std::size_t bytes)
        : bytes_(std::make_unique_for_overwrite<std::byte[]>(bytes)), size_(bytes) {}

    std::byte* data() { return bytes_.get(); }
    const std::byte* data() const { return bytes_.get(); }
    std::size_t size() const { return size_; }

    template <class T>
    std::span<T> as() {
        return {reinterpret_cast<T*>(bytes_.get()), size_ / sizeof(T)};
    }
    template <class T>
    std::span<const T> as() const {
        return {reinterpret_cast<const T*>(bytes_.get()), size_ / sizeof(T)};
    }

  private:
    std::unique_ptr<std::byte[]> bytes_;
    std::size_t size_ = 0;
};

} // namespace lutlib::io
