#include "lutlib/io/box/shared_bytes.h"

#include "lutlib/error.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <system_error>
#include <utility>

namespace lutlib::io::box {
namespace {

[[noreturn]] void fail(const char* message) {
    throw Error(message + (": " + std::generic_category().message(errno)));
}

} // namespace

struct SharedBytes::Mapping {
    Mapping(int descriptor, Sharing with) : file(descriptor), sharing(with) {
        struct stat info {};
        if (::fstat(file.get(), &info) != 0) {
            fail("cannot look at shared memory");
        }
        size = static_cast<std::size_t>(info.st_size);
        if (size == 0) {
            return;
        }
        const int kind = sharing == Sharing::both ? MAP_SHARED : MAP_PRIVATE;
        void* const mapped = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, kind, file.get(), 0);
        if (mapped == MAP_FAILED) {
            fail("cannot map shared memory");
        }
        data = static_cast<std::byte*>(mapped);
    }
    ~Mapping() {
        if (data != nullptr) {
            ::munmap(data, size);
        }
    }
    Mapping(const Mapping&) = delete;
    Mapping& operator=(const Mapping&) = delete;

    Descriptor file;
    Sharing sharing;
    std::byte* data = nullptr;
    std::size_t size = 0;
};

int new_memory_file() {
    const int out = ::memfd_create("lutlib", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (out < 0) {
        fail("cannot make shared memory");
    }
    return out;
}

void seal_size(int descriptor) {
    ::fcntl(descriptor, F_ADD_SEALS, F_SEAL_SHRINK);
}

SharedBytes::SharedBytes(std::size_t size) {
    const int descriptor = new_memory_file();
    if (::ftruncate(descriptor, static_cast<off_t>(size)) != 0) {
        const int reason = errno;
        ::close(descriptor);
        errno = reason;
        fail("cannot make shared memory");
    }
    seal_size(descriptor);
    mapping_ = std::make_shared<Mapping>(descriptor, Sharing::both);
}

SharedBytes SharedBytes::adopt(int descriptor, Sharing sharing) {
    seal_size(descriptor);
    if (sharing == Sharing::both) {
        return SharedBytes(std::make_shared<Mapping>(descriptor, sharing));
    }
    if (::fcntl(descriptor, F_ADD_SEALS, F_SEAL_WRITE) == 0) {
        return SharedBytes(std::make_shared<Mapping>(descriptor, sharing));
    }
    const SharedBytes theirs(std::make_shared<Mapping>(descriptor, Sharing::both)),
        out(theirs.bytes().size());
    std::copy_n(theirs.bytes().data(), theirs.bytes().size(), out.bytes().data());
    return out;
}

SampleBuffer SharedBytes::samples() const {
    if (!mapping_) {
        return {};
    }
    return {mapping_, bytes(), mapping_->sharing == Sharing::both ? descriptor() : -1};
}

std::span<std::byte> SharedBytes::bytes() const {
    return mapping_ ? std::span(mapping_->data, mapping_->size) : std::span<std::byte>{};
}

int SharedBytes::descriptor() const {
    return mapping_ ? mapping_->file.get() : -1;
}

} // namespace lutlib::io::box
