#include "lutlib/io/box/shared_bytes.h"

#include "lutlib/error.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <system_error>

namespace lutlib::io::box {
namespace {

[[noreturn]] void fail(const char* message) {
    throw Error(message + (": " + std::generic_category().message(errno)));
}

} // namespace

/// A whole file in memory.
class MappedFile {
  public:
    MappedFile(int descriptor, int protection) : file_(descriptor) {
        struct stat info {};
        if (::fstat(file_.get(), &info) != 0) {
            fail("cannot look at shared memory");
        }
        size_ = static_cast<std::size_t>(info.st_size);
        if (size_ == 0) {
            return;
        }
        void* const mapped = ::mmap(nullptr, size_, protection, MAP_SHARED, file_.get(), 0);
        if (mapped == MAP_FAILED) {
            fail("cannot map shared memory");
        }
        data_ = static_cast<std::byte*>(mapped);
    }
    ~MappedFile() {
        if (data_ != nullptr) {
            ::munmap(data_, size_);
        }
    }
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    std::span<std::byte> bytes() const { return {data_, size_}; }
    int descriptor() const { return file_.get(); }

  private:
    Descriptor file_;
    std::byte* data_ = nullptr;
    std::size_t size_ = 0;
};

int new_memory_file() {
    const int out = ::memfd_create("lutlib", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (out < 0) {
        fail("cannot make shared memory");
    }
    return out;
}

SharedBytes::SharedBytes(std::size_t size) {
    const int descriptor = new_memory_file();
    if (::ftruncate(descriptor, static_cast<off_t>(size)) != 0) {
        const int reason = errno;
        ::close(descriptor);
        errno = reason;
        fail("cannot make shared memory");
    }
    file_ = std::make_shared<MappedFile>(descriptor, PROT_READ | PROT_WRITE);
    ::fcntl(descriptor, F_ADD_SEALS, F_SEAL_SHRINK);
    // This mapping may still be written. Older systems cannot forbid others to.
    ::fcntl(descriptor, F_ADD_SEALS, F_SEAL_FUTURE_WRITE);
}

std::span<std::byte> SharedBytes::bytes() const {
    return file_ ? file_->bytes() : std::span<std::byte>{};
}

int SharedBytes::descriptor() const {
    return file_ ? file_->descriptor() : -1;
}

ForeignBytes::ForeignBytes(int descriptor) {
    // Whoever maps a file that becomes shorter would be killed.
    ::fcntl(descriptor, F_ADD_SEALS, F_SEAL_SHRINK);
    const int seals = ::fcntl(descriptor, F_GET_SEALS);
    file_ = std::make_shared<MappedFile>(descriptor, PROT_READ);
    if (seals < 0 || (seals & F_SEAL_SHRINK) == 0) {
        throw Error("shared memory may become shorter while it is read");
    }
}

std::span<const std::byte> ForeignBytes::bytes() const {
    return file_ ? file_->bytes() : std::span<std::byte>{};
}

int ForeignBytes::descriptor() const {
    return file_ ? file_->descriptor() : -1;
}

} // namespace lutlib::io::box
