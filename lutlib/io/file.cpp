#include "lutlib/io/file.h"

#include "lutlib/error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <list>
#include <random>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace lutlib::io {
namespace {

[[noreturn]] void fail(const std::string& message, const std::string& file, int error_number) {
    throw Error(message + ": " + std::generic_category().message(error_number), {file, 0, {}});
}

[[noreturn]] void too_large(const std::string& file, std::size_t max_bytes) {
    throw Error("the file is larger than the limit of " + std::to_string(max_bytes) + " bytes",
                {file, 0, {}});
}

void write_all(int fd, std::string_view bytes, const std::string& name) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(fd, bytes.data(), bytes.size());
        if (written < 0) {
            if (errno == EINTR) {
                continue;
            }
            fail("cannot write", name, errno);
        }
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

// `name` is what messages call the file at `path`.
void open_and_write(const std::string& path, std::string_view bytes, const std::string& name) {
    const Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.get() < 0) {
        fail("cannot open the file for writing", name, errno);
    }
    write_all(file.get(), bytes, name);
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
std::string temporary_name(const std::string& target) {
    std::random_device random;
    std::string tag;
    for (int i = 0; i < 8; ++i) {
        tag += "0123456789abcdefghijklmnopqrstuv"[random() % 32];
    }
    const std::size_t slash = target.rfind('/');
    const std::string file = slash == std::string::npos ? target : target.substr(slash + 1);
    const std::size_t dot = file.rfind('.');
    const std::string extension = dot == std::string::npos ? "" : file.substr(dot);
    // Short enough for a file system's 255 bytes even when the target's own name fills them.
    const std::string stem = file.substr(0, std::min<std::size_t>(dot, 64));
    return directory_of(target) + "/." + stem + "." + tag + ".tmp" + extension;
}

thread_local StandardStreamsInstead* instead = nullptr;

constexpr const char* empty_file = "the file is empty";

// Devices, pipes and sockets have no old content to protect and cannot be renamed over.
bool is_special(const std::string& path) {
    struct stat info {};
    return ::stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode);
}

void flush(const std::string& path, const std::string& name) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.get() < 0 || ::fsync(file.get()) != 0) {
        fail("cannot flush the file to the disk", name, errno);
    }
}

} // namespace

std::string input_name(const std::string& path) {
    return path == standard_stream ? "standard input" : path;
}

std::string output_name(const std::string& path) {
    return path == standard_stream ? "standard output" : path;
}

std::string extension_of(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    const std::string_view file = slash == std::string_view::npos ? path : path.substr(slash + 1);
    const std::size_t dot = file.rfind('.');
    std::string out(dot == std::string_view::npos ? std::string_view{} : file.substr(dot + 1));
    std::transform(out.begin(), out.end(), out.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return out;
}

FileInput::FileInput(const std::string& path)
    : name_(input_name(path)),
      file_(path == standard_stream ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    struct stat info {};
    if (file_.get() < 0 || ::fstat(file_.get(), &info) != 0) {
        fail("cannot open the file", name_, errno);
    }
    if (S_ISDIR(info.st_mode)) {
        throw Error("this is a directory; name a file", {name_, 0, {}});
    }
    if (path != standard_stream && S_ISCHR(info.st_mode) && ::isatty(file_.get()) == 0) {
        throw Error("this is a device; name a file", {name_, 0, {}});
    }
    size_ = S_ISREG(info.st_mode) ? static_cast<std::size_t>(info.st_size) : 0;
}

std::size_t FileInput::read(char* to, std::size_t most) {
    ssize_t got = 0;
    do {
        got = ::read(file_.get(), to, most);
    } while (got < 0 && errno == EINTR);
    if (got < 0) {
        fail("cannot read the file", name_, errno);
    }
    read_ += static_cast<std::size_t>(got);
    return static_cast<std::size_t>(got);
}

std::size_t FileInput::remaining() const {
    return size_ - std::min(size_, read_);
}

std::string FileInput::head(std::size_t most) {
    std::string out(most, '\0');
    std::size_t length = 0;
    while (const std::size_t got = length < most ? read(out.data() + length, most - length) : 0) {
        length += got;
    }
    out.resize(length);
    if (length == 0) {
        throw Error(empty_file, {name_, 0, {}});
    }
    return out;
}

std::string FileInput::all_of(std::string head, std::size_t max_bytes) {
    std::string bytes = std::move(head);
    std::size_t length = bytes.size();
    if (length + remaining() > max_bytes) {
        too_large(name_, max_bytes);
    }
    // One byte more than announced, so that the end shows without growing. Pipes announce nothing.
    bytes.resize(std::max<std::size_t>(length + remaining() + 1, 4096));
    while (const std::size_t got = read(bytes.data() + length, bytes.size() - length)) {
        length += got;
        if (length > max_bytes) {
            too_large(name_, max_bytes);
        }
        if (length == bytes.size()) {
            bytes.resize(length * 2);
        }
    }
    if (length == 0) {
        throw Error(empty_file, {name_, 0, {}});
    }
    bytes.resize(length);
    return bytes;
}

StandardStreamsInstead::StandardStreamsInstead(std::string bytes) : input(std::move(bytes)) {
    instead = this;
}

StandardStreamsInstead::~StandardStreamsInstead() {
    instead = nullptr;
}

std::string read_file(const std::string& path, std::size_t max_bytes) {
    if (instead && path == standard_stream) {
        return std::exchange(instead->input, {});
    }
    return FileInput(path).all_of({}, max_bytes);
}

std::optional<std::string> head_of_regular_file(const std::string& path, std::size_t bytes) {
    if (path == standard_stream || is_special(path)) {
        return std::nullopt;
    }
    return FileInput(path).head(bytes);
}

PendingFile::PendingFile(const std::string& target)
    : target_(follow_links(target)), path_(temporary_name(target_)), removed_(path_) {
    struct stat info {};
    const bool exists = ::stat(target_.c_str(), &info) == 0;
    if (exists && S_ISDIR(info.st_mode)) {
        throw Error("this is a directory; name a file in it", {target, 0, {}});
    }
    // A rename would pass over the target's own write protection.
    if (exists && ::access(target_.c_str(), W_OK) != 0) {
        fail("cannot replace the file", target, errno);
    }
    const Descriptor file(::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.get() < 0) {
        fail("cannot create a file in " + directory_of(target_), target, errno);
    }
    if (exists && ::fchmod(file.get(), info.st_mode & 0777) != 0) {
        const int reason = errno;
        ::unlink(path_.c_str());
        fail("cannot keep the permissions of the file", target, reason);
    }
}

PendingFile::~PendingFile() {
    if (!committed_) {
        ::unlink(path_.c_str());
    }
}

void PendingFile::commit() {
    flush(path_, target_);
    if (::rename(path_.c_str(), target_.c_str()) != 0) {
        fail("cannot move the new file into place", target_, errno);
    }
    committed_ = true;
}

void write_files(std::span<const FileToWrite> files) {
    std::list<PendingFile> pending;
    std::vector<const FileToWrite*> in_place;
    for (const FileToWrite& file : files) {
        if (file.path == standard_stream || is_special(file.path)) {
            in_place.push_back(&file);
        } else {
            open_and_write(pending.emplace_back(file.path).path(), file.bytes, file.path);
        }
    }
    for (const FileToWrite* const file : in_place) {
        if (instead && file->path == standard_stream) {
            instead->output += file->bytes;
        } else if (file->path == standard_stream) {
            write_all(STDOUT_FILENO, file->bytes, output_name(file->path));
        } else {
            open_and_write(file->path, file->bytes, file->path);
        }
    }
    for (PendingFile& file : pending) {
        file.commit();
    }
}

void write_file(const std::string& path, std::string_view bytes) {
    write_files(std::array{FileToWrite{path, bytes}});
}

} // namespace lutlib::io
