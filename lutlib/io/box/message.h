// What a program and its boxed readers say to each other: values in an order that both know, and
// open files.
#pragma once

#include "lutlib/error.h"
#include "lutlib/io/descriptor.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace lutlib::io::box {

template <class T>
concept Plain = std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>;

/// A name and what it says.
using TextPair = std::pair<std::string, std::string>;

/// A message that is being written.
class Outgoing {
  public:
    template <Plain T>
    void put(const T& value) {
        append(&value, sizeof value);
    }
    void put(std::string_view text);
    template <Plain T>
    void put_all(std::span<const T> values) {
        put(std::uint64_t{values.size()});
        append(values.data(), values.size_bytes());
    }
    void put_texts(std::span<const std::string> texts);
    void put_pairs(std::span<const TextPair> pairs);
    /// A duplicate of an open file goes along; the other side takes it in the same place.
    void attach(int descriptor);

    const std::string& bytes() const { return bytes_; }
    const std::deque<Descriptor>& files() const { return files_; }

  private:
    void append(const void* from, std::size_t size) {
        if (size > 0) {
            bytes_.append(static_cast<const char*>(from), size);
        }
    }

    std::string bytes_;
    std::deque<Descriptor> files_;
};

/// A message that has arrived. Whatever its bytes are, every call gives a value or throws Error.
class Incoming {
  public:
    Incoming(std::string bytes, std::vector<int> files);
    ~Incoming();
    Incoming(Incoming&& other) noexcept;
    Incoming& operator=(Incoming&&) = delete;

    template <Plain T>
    T take() {
        static_assert(!std::is_same_v<T, bool>, "a byte of 2 is no bool");
        T value;
        std::memcpy(&value, piece(sizeof value), sizeof value);
        return value;
    }
    bool take_bool() { return take<std::uint8_t>() != 0; }
    std::string take_text();
    template <Plain T>
    std::vector<T> take_all() {
        const std::size_t count = checked_count(take<std::uint64_t>(), sizeof(T));
        std::vector<T> out(count);
        if (count > 0) {
            std::memcpy(out.data(), piece(count * sizeof(T)), count * sizeof(T));
        }
        return out;
    }
    std::vector<std::string> take_texts();
    std::vector<TextPair> take_pairs();
    /// The caller closes it.
    int take_file();

  private:
    friend std::optional<Incoming> receive(int socket, int milliseconds);

    const char* piece(std::size_t size);
    std::size_t checked_count(std::uint64_t count, std::size_t size) const;

    std::string bytes_;
    std::size_t at_ = 0;
    std::vector<int> files_;
    std::size_t next_file_ = 0;
};

/// Sends a message over a stream socket. False where the other side is gone.
bool send(int socket, const Outgoing& message);

/// Waits for one, at most so many milliseconds without a byte (-1: for ever). Nothing where the
/// other side is gone or sends what is no message, or the time is over.
std::optional<Incoming> receive(int socket, int milliseconds);

} // namespace lutlib::io::box
