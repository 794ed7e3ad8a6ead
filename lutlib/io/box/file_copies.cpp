#include "lutlib/io/box/file_copies.h"

#include "lutlib/error.h"
#include "lutlib/io/box/shared_bytes.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/sendfile.h>
#include <system_error>

namespace lutlib::io::box {
namespace {

constexpr std::size_t most_bytes_kept = std::size_t{256} << 20;

[[noreturn]] void refuse_file(const char* failure, const std::string& file) {
    throw Error(failure + (": " + std::generic_category().message(errno)), {file, 0, {}});
}

bool is_unchanged(const struct stat& a, const struct stat& b) {
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino && a.st_size == b.st_size &&
           a.st_mtim.tv_sec == b.st_mtim.tv_sec && a.st_mtim.tv_nsec == b.st_mtim.tv_nsec &&
           a.st_ctim.tv_sec == b.st_ctim.tv_sec && a.st_ctim.tv_nsec == b.st_ctim.tv_nsec;
}

FileCopy copied(const std::string& path, const std::string& file) {
    const Descriptor from(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    FileCopy out;
    if (from.get() < 0 || ::fstat(from.get(), &out.original) != 0) {
        refuse_file("cannot open the file", file);
    }
    const auto memory = std::make_shared<const Descriptor>(new_memory_file());
    copy_all(memory->get(), from.get(), "cannot read the file", file);
    out.memory = memory;
    return out;
}

} // namespace

void copy_all(int to, int from, const char* failure, const std::string& file) {
    struct stat info {};
    if (::fstat(from, &info) != 0) {
        refuse_file(failure, file);
    }
    off_t at = 0;
    while (at < info.st_size) {
        const ssize_t count =
            ::sendfile(to, from, &at, static_cast<std::size_t>(info.st_size - at));
        if (count < 0 && errno != EINTR) {
            refuse_file(failure, file);
        }
        if (count == 0) {
            return; // it has become shorter meanwhile
        }
    }
}

FileCopy FileCopies::keep(const std::string& path, const std::string& file) const {
    FileCopy out = copied(path, file);
    if (out.size() <= most_bytes_kept) {
        const std::lock_guard lock(mutex_);
        while (size_ + out.size() > most_bytes_kept) {
            size_ -= kept_.front().size();
            kept_.erase(kept_.begin());
        }
        kept_.push_back(out);
        size_ += out.size();
    }
    return out;
}

FileCopy FileCopies::take(const std::string& path, const std::string& file) const {
    struct stat now {};
    if (::stat(path.c_str(), &now) == 0) {
        const std::lock_guard lock(mutex_);
        const auto kept = std::find_if(kept_.begin(), kept_.end(), [&](const FileCopy& one) {
            return is_unchanged(one.original, now);
        });
        if (kept != kept_.end()) {
            FileCopy out = std::move(*kept);
            kept_.erase(kept);
            size_ -= out.size();
            return out;
        }
    }
    return copied(path, file);
}

} // namespace lutlib::io::box
