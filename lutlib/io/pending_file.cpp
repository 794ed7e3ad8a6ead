#include "lutlib/io/pending_file.h"

#include "lutlib/error.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace lutlib::io {
namespace {

[[noreturn]] void fail(const std::string& message, const std::string& file, int error_number) {
    throw Error(message + ": " + std::generic_category().message(error_number), {file, 0, {}});
}

// The file that a chain of symbolic links leads to, so that a rename replaces it and not the link.
// It need not exist.
std::string follow_links(const std::string& path) {
    constexpr int longest_chain = 40; // Linux's own limit
    std::filesystem::path at = path;
    for (int i = 0; i <= longest_chain; ++i) {
        std::error_code no_link;
        const std::filesystem::path to = std::filesystem::read_symlink(at, no_link);
        if (no_link) {
            return at.string();
        }
        at = at.parent_path() / to;
    }
    fail("cannot follow the symbolic link", path, ELOOP);
}

std::string directory_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

// A hidden name beside the target that keeps its extension, by which libraries choose a format.
std::string temporary_name(const std::string& target, int number) {
    const std::size_t slash = target.rfind('/');
    const std::string file = slash == std::string::npos ? target : target.substr(slash + 1);
    const std::size_t dot = file.rfind('.');
    const std::string extension = dot == std::string::npos ? "" : file.substr(dot);
    // Short enough for a file system's 255 bytes even when the target's own name fills them.
    const std::string stem = file.substr(0, std::min<std::size_t>(dot, 64));
    return directory_of(target) + "/." + stem + "." + std::to_string(number) + ".tmp" + extension;
}

// Whether the lock of the file at `path` is now held by `file`, which is still that file. Network
// file systems that lock nothing count as if they did.
bool is_taken(const Descriptor& file, const std::string& path) {
    struct stat own {
    }, named{};
    return (::flock(file.get(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) &&
           ::fstat(file.get(), &own) == 0 && ::lstat(path.c_str(), &named) == 0 &&
           own.st_ino == named.st_ino && own.st_dev == named.st_dev;
}

// Removes a file of this name that nobody is at: its writer was killed.
void remove_left(const std::string& path) {
    struct stat info {};
    const Descriptor left(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (left.get() >= 0 && ::fstat(left.get(), &info) == 0 && S_ISREG(info.st_mode) &&
        ::flock(left.get(), LOCK_EX | LOCK_NB) == 0 && is_taken(left, path)) {
        ::unlink(path.c_str());
    }
}

// A new file of the first such name that nobody else is at; fills `path`.
int new_file(const std::string& target, const std::string& name, std::string& path) {
    constexpr int most_writers = 10000;
    for (int number = 0; number < most_writers; ++number) {
        path = temporary_name(target, number);
        remove_left(path);
        const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file < 0 && errno != EEXIST) {
            fail("cannot create a file in " + directory_of(target), name, errno);
        }
        Descriptor owned(file);
        if (file >= 0 && is_taken(owned, path)) {
            return owned.release();
        }
    }
    fail("cannot create a file in " + directory_of(target), name, EEXIST);
}

// The same for a target that can be replaced, with its permissions.
int made_for(const std::string& target, const std::string& name, std::string& path) {
    struct stat info {};
    const bool exists = ::stat(target.c_str(), &info) == 0;
    if (exists && S_ISDIR(info.st_mode)) {
        throw Error("this is a directory; name a file in it", {name, 0, {}});
    }
    if (exists && !S_ISREG(info.st_mode)) {
        throw Error("this is a device or a pipe, which no file may replace; name a file",
                    {name, 0, {}});
    }
    // A rename would pass over the target's own write protection.
    if (exists && ::access(target.c_str(), W_OK) != 0) {
        fail("cannot replace the file", name, errno);
    }
    Descriptor file(new_file(target, name, path));
    if (exists && ::fchmod(file.get(), info.st_mode & 0777) != 0) {
        const int reason = errno;
        ::unlink(path.c_str());
        fail("cannot keep the permissions of the file", name, reason);
    }
    return file.release();
}

} // namespace

PendingFile::PendingFile(const std::string& target)
    : target_(follow_links(target)), file_(made_for(target_, target, path_)), removed_(path_) {}

PendingFile::~PendingFile() {
    if (state_ == State::written) {
        ::unlink(path_.c_str());
    }
}

void PendingFile::commit() {
    flush();
    if (::rename(path_.c_str(), target_.c_str()) != 0) {
        fail("cannot move the new file into place", target_, errno);
    }
    state_ = State::kept;
}

void PendingFile::flush() const {
    // By its path: whoever wrote there may have made a file of his own.
    const Descriptor file(::open(path_.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.get() < 0 || ::fsync(file.get()) != 0) {
        fail("cannot flush the file to the disk", target_, errno);
    }
}

void PendingFile::replace() {
    struct stat info {};
    const bool exists = ::lstat(target_.c_str(), &info) == 0;
    if (exists && !S_ISDIR(info.st_mode) &&
        ::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0) {
        state_ = State::swapped;
    } else if (::rename(path_.c_str(), target_.c_str()) == 0) {
        // Over an old file only on a file system that cannot swap two; the old one is gone then.
        state_ = exists ? State::kept : State::moved;
    } else {
        fail("cannot move the new file into place", target_, errno);
    }
}

void PendingFile::undo() noexcept {
    if (state_ == State::swapped &&
        ::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0) {
        state_ = State::written;
    } else if (state_ == State::moved) {
        ::unlink(target_.c_str());
        state_ = State::kept;
    }
}

void PendingFile::keep() noexcept {
    if (state_ == State::swapped) {
        ::unlink(path_.c_str());
    }
    state_ = State::kept;
}

void commit_all(std::list<PendingFile>& files) {
    if (files.size() == 1) {
        files.front().commit();
        return;
    }
    for (const PendingFile& file : files) {
        file.flush();
    }
    try {
        for (PendingFile& file : files) {
            file.replace();
        }
    } catch (const Error&) {
        for (PendingFile& file : files) {
            file.undo();
        }
        throw;
    }
    for (PendingFile& file : files) {
        file.keep();
    }
}

} // namespace lutlib::io
