// Samples of a picture, of any type.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>

namespace lutlib::io {

/// Bytes that are not cleared before they are written, which would take as long as a look.
class SampleBuffer {
  public:
    SampleBuffer() = default;
    explicit SampleBuffer(std::size_t size)
        : owner_(std::shared_ptr<std::byte[]>(new std::byte[size])),
          bytes_(static_cast<std::byte*>(owner_.get()), size) {}
    /// Bytes that `owner` keeps where they are. `descriptor`, of owner's too, is a file that holds
    /// these bytes and other processes can map; -1: there is none.
    SampleBuffer(std::shared_ptr<void> owner, std::span<std::byte> bytes, int descriptor = -1)
        : owner_(std::move(owner)), bytes_(bytes), descriptor_(descriptor) {}
    SampleBuffer(SampleBuffer&& other) noexcept { *this = std::move(other); }
    SampleBuffer& operator=(SampleBuffer&& other) noexcept {
        owner_ = std::move(other.owner_);
        bytes_ = std::exchange(other.bytes_, {});
        descriptor_ = std::exchange(other.descriptor_, -1);
        return *this;
    }

    std::byte* data() { return bytes_.data(); }
    const std::byte* data() const { return bytes_.data(); }
    std::size_t size() const { return bytes_.size(); }
    int descriptor() const { return descriptor_; }

    template <class T>
    std::span<T> as() {
        return {reinterpret_cast<T*>(bytes_.data()), bytes_.size() / sizeof(T)};
    }
    template <class T>
    std::span<const T> as() const {
        return {reinterpret_cast<const T*>(bytes_.data()), bytes_.size() / sizeof(T)};
    }

  private:
    std::shared_ptr<void> owner_;
    std::span<std::byte> bytes_;
    int descriptor_ = -1;
};

} // namespace lutlib::io
