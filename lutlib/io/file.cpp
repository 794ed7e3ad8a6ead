#include "lutlib/io/file.h"

#include "lutlib/error.h"
#include "lutlib/io/pending_file.h"
#include "lutlib/io/reason.h"
#include "lutlib/io/terminal.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <list>
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

thread_local StandardStreamsInstead* instead = nullptr;

thread_local std::string last_opened;

constexpr const char* empty_file = "the file is empty";

} // namespace

bool is_special(const std::string& path) {
    struct stat info {};
    return ::stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode);
}

std::string input_name(const std::string& path) {
    return path == standard_stream ? "standard input" : path;
}

const std::string& last_input() {
    return last_opened;
}

std::string output_name(const std::string& path) {
    return path == standard_stream ? "standard output" : path;
}

FileInput::FileInput(const std::string& path)
    : name_(input_name(path)),
      file_(path == standard_stream ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    last_opened = name_;
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
        } else if (file->path == standard_stream && standard_output_was_closed()) {
            throw Error("standard output is closed; name a file", {output_name(file->path), 0, {}});
        } else if (file->path == standard_stream) {
            write_all(STDOUT_FILENO, file->bytes, output_name(file->path));
        } else {
            open_and_write(file->path, file->bytes, file->path);
        }
    }
    commit_all(pending);
}

void write_file(const std::string& path, std::string_view bytes) {
    write_files(std::array{FileToWrite{path, bytes}});
}

} // namespace lutlib::io
