#include "lutlib/io/box/message.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

namespace lutlib::io::box {
namespace {

constexpr std::size_t most_files = 8;

struct Header {
    std::uint64_t size = 0;
    std::uint64_t files = 0;
};

// Pictures travel as files; what is left are tables of looks, the largest of 256^3 nodes.
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 30;

[[noreturn]] void damaged() {
    throw Error("the process that reads the file sent a damaged answer; run it again, and report "
                "the file if that fails too");
}

union FileSpace {
    cmsghdr header;
    std::array<char, CMSG_SPACE(sizeof(int) * most_files)> bytes;
};

bool send_bytes(int socket, const char* data, std::size_t size) {
    while (size > 0) {
        const ssize_t sent = ::send(socket, data, size, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) {
            continue;
        }
        if (sent <= 0) {
            return false;
        }
        data += sent;
        size -= static_cast<std::size_t>(sent);
    }
    return true;
}

bool wait_for(int socket, int milliseconds) {
    pollfd waited{socket, POLLIN, 0};
    int ready = 0;
    do {
        ready = ::poll(&waited, 1, milliseconds);
    } while (ready < 0 && errno == EINTR);
    return ready > 0;
}

bool receive_bytes(int socket, char* data, std::size_t size, int milliseconds) {
    while (size > 0) {
        if (!wait_for(socket, milliseconds)) {
            return false;
        }
        const ssize_t got = ::recv(socket, data, size, 0);
        if (got < 0 && errno == EINTR) {
            continue;
        }
        if (got <= 0) {
            return false;
        }
        data += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

void take_files(msghdr& message, std::vector<int>& files) {
    for (cmsghdr* part = CMSG_FIRSTHDR(&message); part; part = CMSG_NXTHDR(&message, part)) {
        if (part->cmsg_level == SOL_SOCKET && part->cmsg_type == SCM_RIGHTS) {
            const std::size_t count = (part->cmsg_len - CMSG_LEN(0)) / sizeof(int);
            const std::size_t before = files.size();
            files.resize(before + count);
            std::memcpy(&files[before], CMSG_DATA(part), count * sizeof(int));
        }
    }
}

} // namespace

void Outgoing::put(std::string_view text) {
    put_all(std::span(text.data(), text.size()));
}

void Outgoing::put_texts(std::span<const std::string> texts) {
    put(std::uint64_t{texts.size()});
    for (const std::string& text : texts) {
        put(std::string_view(text));
    }
}

void Outgoing::put_pairs(std::span<const TextPair> pairs) {
    put(std::uint64_t{pairs.size()});
    for (const auto& [name, text] : pairs) {
        put(std::string_view(name));
        put(std::string_view(text));
    }
}

void Outgoing::attach(int descriptor) {
    const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    if (copy < 0 || files_.size() == most_files) {
        throw Error("cannot hand over an open file");
    }
    files_.emplace_back(copy);
}

Incoming::Incoming(std::string bytes, std::vector<int> files)
    : bytes_(std::move(bytes)), files_(std::move(files)) {}

Incoming::~Incoming() {
    for (; next_file_ < files_.size(); ++next_file_) {
        ::close(files_[next_file_]);
    }
}

Incoming::Incoming(Incoming&& other) noexcept
    : bytes_(std::move(other.bytes_)), at_(other.at_), files_(std::exchange(other.files_, {})),
      next_file_(other.next_file_) {}

const char* Incoming::piece(std::size_t size) {
    if (size > bytes_.size() - at_) {
        damaged();
    }
    const char* const out = bytes_.data() + at_;
    at_ += size;
    return out;
}

std::size_t Incoming::checked_count(std::uint64_t count, std::size_t size) const {
    if (count > (bytes_.size() - at_) / size) {
        damaged();
    }
    return static_cast<std::size_t>(count);
}

std::string Incoming::take_text() {
    const std::size_t size = checked_count(take<std::uint64_t>(), 1);
    return {piece(size), size};
}

std::vector<std::string> Incoming::take_texts() {
    std::vector<std::string> out(checked_count(take<std::uint64_t>(), sizeof(std::uint64_t)));
    std::generate(out.begin(), out.end(), [this] { return take_text(); });
    return out;
}

std::vector<TextPair> Incoming::take_pairs() {
    std::vector<TextPair> out(checked_count(take<std::uint64_t>(), 2 * sizeof(std::uint64_t)));
    for (auto& [name, text] : out) {
        name = take_text();
        text = take_text();
    }
    return out;
}

int Incoming::take_file() {
    if (next_file_ == files_.size()) {
        damaged();
    }
    return files_[next_file_++];
}

bool send(int socket, const Outgoing& message) {
    Header header{message.bytes().size(), message.files().size()};
    iovec part{&header, sizeof header};
    FileSpace space{};
    msghdr out{};
    out.msg_iov = &part;
    out.msg_iovlen = 1;
    if (header.files > 0) {
        out.msg_control = &space;
        out.msg_controllen = CMSG_SPACE(sizeof(int) * header.files);
        cmsghdr* const files = CMSG_FIRSTHDR(&out);
        files->cmsg_level = SOL_SOCKET;
        files->cmsg_type = SCM_RIGHTS;
        files->cmsg_len = CMSG_LEN(sizeof(int) * header.files);
        std::array<int, most_files> descriptors{};
        std::transform(message.files().begin(), message.files().end(), descriptors.begin(),
                       [](const Descriptor& file) { return file.get(); });
        std::memcpy(CMSG_DATA(files), descriptors.data(), sizeof(int) * header.files);
    }
    ssize_t sent = 0;
    do {
        sent = ::sendmsg(socket, &out, MSG_NOSIGNAL);
    } while (sent < 0 && errno == EINTR);
    return sent == ssize_t{sizeof header} &&
           send_bytes(socket, message.bytes().data(), message.bytes().size());
}

std::optional<Incoming> receive(int socket, int milliseconds) {
    Header header;
    iovec part{&header, sizeof header};
    FileSpace space{};
    msghdr in{};
    in.msg_iov = &part;
    in.msg_iovlen = 1;
    in.msg_control = &space;
    in.msg_controllen = sizeof space;
    if (!wait_for(socket, milliseconds)) {
        return std::nullopt;
    }
    ssize_t got = 0;
    do {
        got = ::recvmsg(socket, &in, MSG_CMSG_CLOEXEC | MSG_WAITALL);
    } while (got < 0 && errno == EINTR);
    std::vector<int> files;
    if (got > 0) {
        take_files(in, files);
    }
    Incoming out({}, std::move(files));
    if (got != ssize_t{sizeof header} || header.size > most_bytes) {
        return std::nullopt;
    }
    out.bytes_.resize(static_cast<std::size_t>(header.size));
    if (!receive_bytes(socket, out.bytes_.data(), out.bytes_.size(), milliseconds)) {
        return std::nullopt;
    }
    return out;
}

} // namespace lutlib::io::box
