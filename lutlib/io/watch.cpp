#include "lutlib/io/watch.h"

#include "lutlib/error.h"
#include "lutlib/io/descriptor.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <poll.h>
#include <set>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace lutlib::io {
namespace {

namespace fs = std::filesystem;

// A file that is being written is told when it is closed.
constexpr std::uint32_t watched_kinds = IN_CLOSE_WRITE | IN_CREATE | IN_DELETE | IN_MOVED_FROM |
                                        IN_MOVED_TO | IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;
constexpr std::uint32_t folder_is_gone = IN_DELETE_SELF | IN_MOVE_SELF | IN_UNMOUNT | IN_IGNORED;

[[noreturn]] void fail_to_watch(const std::string& path, int reason) {
    if (reason == ENOSPC || reason == EMFILE) {
        throw Error("the system watches no more folders for this user; raise "
                    "fs.inotify.max_user_watches and max_user_instances, or end other programs",
                    {path, 0, {}});
    }
    throw Error("cannot watch the folder: " + std::generic_category().message(reason),
                {path, 0, {}});
}

fs::path folder_of_file(const fs::path& path) {
    const fs::path folder = path.parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

bool is_there_now(const fs::path& path) {
    std::error_code unknown;
    return fs::exists(path, unknown);
}

bool is_a_folder(const fs::path& path) {
    std::error_code unknown;
    return fs::is_directory(path, unknown);
}

// Links come whole; any other new file is written first and closed then.
bool is_whole_when_new(const fs::path& path) {
    std::error_code unknown, gone;
    return fs::is_symlink(path, unknown) || fs::hard_link_count(path, gone) > 1;
}

} // namespace

bool can_be_watched(const std::string& path) {
    return ::access(folder_of_file(path).c_str(), R_OK) == 0 || errno == ENOENT || errno == ENOTDIR;
}

class FileWatch::Inotify {
  public:
    Inotify();

    void watch(std::span<const std::string> paths);
    std::vector<std::string> wait();
    std::vector<std::string> changed();
    void wake() const;

  private:
    using Clock = std::chrono::steady_clock;
    /// What of a folder is of interest for a path.
    struct Place {
        int folder = -1;    ///< as inotify numbers it
        std::string name;   ///< in it; empty: every file
        std::size_t of = 0; ///< index into paths_
    };

    void arm();
    void add_places(std::size_t path);
    void take_events();
    void take(int folder, unsigned kind, const std::string& name);
    void mark(const std::string& path);
    /// Empty: nothing is waited for.
    std::optional<Clock::duration> due_in() const;
    std::vector<std::string> take_due();

    Descriptor events_, woken_;
    std::vector<std::string> paths_;
    std::vector<Place> places_;
    bool stale_ = false; ///< the places may have moved
    std::set<std::string> changed_;
    Clock::time_point first_{}, last_{};
};

FileWatch::Inotify::Inotify()
    : events_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)),
      woken_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    if (events_.get() < 0 || woken_.get() < 0) {
        fail_to_watch({}, errno);
    }
}

void FileWatch::Inotify::watch(std::span<const std::string> paths) {
    paths_.assign(paths.begin(), paths.end());
    arm();
    std::erase_if(changed_, [&](const std::string& path) {
        return std::none_of(paths_.begin(), paths_.end(), [&](const std::string& watched) {
            return watched == path ||
                   folder_of_file(path) == folder_of_file(fs::path(watched) / "x");
        });
    });
}

void FileWatch::Inotify::arm() {
    std::vector<Place> before = std::exchange(places_, {});
    stale_ = false;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
        add_places(i);
    }
    for (const Place& old : before) {
        if (std::none_of(places_.begin(), places_.end(),
                         [&](const Place& place) { return place.folder == old.folder; })) {
            ::inotify_rm_watch(events_.get(), old.folder);
        }
    }
}

// The file's own folder, or the nearest one that is there; and those of what a link leads to.
void FileWatch::Inotify::add_places(std::size_t path) {
    constexpr int longest_chain = 40; // Linux's own limit
    const auto number_of = [&](const fs::path& folder) {
        return ::inotify_add_watch(events_.get(), folder.c_str(), watched_kinds);
    };
    fs::path at = paths_[path];
    if (is_a_folder(at)) {
        const int folder = number_of(at);
        if (folder < 0) {
            fail_to_watch(at.string(), errno);
        }
        places_.push_back({folder, {}, path});
        return;
    }
    for (int i = 0; i <= longest_chain; ++i) {
        fs::path folder = folder_of_file(at);
        std::string name = at.filename().string();
        int number = number_of(folder);
        while (number < 0 && (errno == ENOENT || errno == ENOTDIR) &&
               folder != folder_of_file(folder)) {
            name = folder.filename().string();
            folder = folder_of_file(folder);
            number = number_of(folder);
        }
        if (number < 0) {
            fail_to_watch(folder.string(), errno);
        }
        places_.push_back({number, name, path});
        std::error_code no_link;
        const fs::path to = fs::read_symlink(at, no_link);
        if (no_link) {
            return;
        }
        at = folder_of_file(at) / to;
    }
}

void FileWatch::Inotify::mark(const std::string& path) {
    last_ = Clock::now();
    first_ = changed_.empty() ? last_ : first_;
    changed_.insert(path);
}

void FileWatch::Inotify::take(int folder, unsigned kind, const std::string& name) {
    for (const Place& place : places_) {
        const std::string& path = paths_[place.of];
        if (place.folder != folder) {
            continue;
        }
        if ((kind & folder_is_gone) != 0) {
            stale_ = true;
            mark(path);
        } else if (place.name.empty()) {
            const fs::path file = fs::path(path) / name;
            const bool is_new = (kind & IN_CREATE) != 0 && !is_whole_when_new(file);
            if ((kind & IN_ISDIR) == 0 && !is_new && !name.starts_with('.')) {
                mark(file.string());
            }
        } else if (place.name == name) {
            stale_ = true; // a link may lead elsewhere, a folder may be there now
            const bool is_new =
                (kind & IN_CREATE) != 0 && (kind & IN_ISDIR) == 0 && !is_whole_when_new(path);
            // Of a folder that comes, the file may be there already.
            if (!is_new && ((kind & IN_ISDIR) == 0 || is_there_now(path))) {
                mark(path);
            }
        }
    }
}

void FileWatch::Inotify::take_events() {
    alignas(inotify_event) std::array<char, 16384> buffer{};
    for (;;) {
        const ssize_t bytes = ::read(events_.get(), buffer.data(), buffer.size());
        if (bytes < 0 && errno == EINTR) {
            continue;
        }
        if (bytes <= 0) {
            break;
        }
        for (std::size_t at = 0; at < static_cast<std::size_t>(bytes);) {
            inotify_event event{};
            std::memcpy(&event, buffer.data() + at, sizeof event);
            const char* const name = buffer.data() + at + sizeof event;
            if ((event.mask & IN_Q_OVERFLOW) != 0) {
                stale_ = true;
                for (const std::string& path : paths_) {
                    mark(path);
                }
            } else {
                take(event.wd, event.mask, event.len > 0 ? std::string(name) : std::string());
            }
            at += sizeof event + event.len;
        }
    }
    if (stale_) {
        arm();
    }
}

std::optional<FileWatch::Inotify::Clock::duration> FileWatch::Inotify::due_in() const {
    if (changed_.empty()) {
        return std::nullopt;
    }
    const Clock::duration left = std::min(last_ + rest, first_ + most) - Clock::now();
    return std::max(left, Clock::duration::zero());
}

std::vector<std::string> FileWatch::Inotify::take_due() {
    if (due_in() != Clock::duration::zero()) {
        return {};
    }
    const std::set<std::string> due = std::exchange(changed_, {});
    return {due.begin(), due.end()};
}

std::vector<std::string> FileWatch::Inotify::changed() {
    take_events();
    return take_due();
}

std::vector<std::string> FileWatch::Inotify::wait() {
    for (;;) {
        std::vector<std::string> out = changed();
        std::uint64_t times = 0;
        const bool is_woken = ::read(woken_.get(), &times, sizeof times) > 0;
        if (!out.empty() || is_woken) {
            return out;
        }
        const std::optional<Clock::duration> left = due_in();
        const int timeout =
            left ? static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(*left).count())
                 : -1;
        std::array<pollfd, 2> both{{{events_.get(), POLLIN, 0}, {woken_.get(), POLLIN, 0}}};
        if (::poll(both.data(), both.size(), timeout) < 0 && errno != EINTR) {
            throw Error("cannot wait for files to change: " +
                        std::generic_category().message(errno));
        }
    }
}

void FileWatch::Inotify::wake() const {
    const std::uint64_t once = 1;
    // It fails where it is awake already.
    const ssize_t written = ::write(woken_.get(), &once, sizeof once);
    static_cast<void>(written);
}

FileWatch::FileWatch() : inotify_(std::make_unique<Inotify>()) {}
FileWatch::FileWatch(FileWatch&&) noexcept = default;
FileWatch& FileWatch::operator=(FileWatch&&) noexcept = default;
FileWatch::~FileWatch() = default;

void FileWatch::watch(std::span<const std::string> paths) {
    inotify_->watch(paths);
}

std::vector<std::string> FileWatch::wait() {
    return inotify_->wait();
}

std::vector<std::string> FileWatch::changed() {
    return inotify_->changed();
}

void FileWatch::wake() const {
    inotify_->wake();
}

} // namespace lutlib::io
