#include "converter/watch.h"

#include "converter/command.h"
#include "converter/many_looks.h"
#include "converter/replaceable.h"
#include "converter/report.h"
#include "lutlib/error.h"
#include "lutlib/io/cleanup.h"
#include "lutlib/io/file.h"
#include "lutlib/io/reason.h"
#include "lutlib/io/recipe_file.h"
#include "lutlib/io/watch.h"

#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <exception>
#include <filesystem>
#include <iterator>
#include <set>
#include <system_error>

namespace converter {
namespace {

namespace fs = std::filesystem;
namespace io = lutlib::io;

// One name for a file, whether it is there or not.
fs::path own_name(const std::string& path) {
    std::error_code unknown;
    const fs::path out = fs::weakly_canonical(fs::absolute(path, unknown), unknown);
    return unknown ? fs::path(path) : out;
}

bool is_a_folder(const std::string& path) {
    std::error_code unknown;
    return fs::is_directory(path, unknown);
}

std::string time_now() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    ::localtime_r(&now, &local);
    return fmt::format("{:02}:{:02}:{:02}", local.tm_hour, local.tm_min, local.tm_sec);
}

void tell_event(const std::string& sentence) {
    print("lutconv: " + time_now() + " " + sentence + "\n", std::string(io::standard_stream));
}

std::string names_text(const std::vector<std::string>& paths) {
    std::string out;
    for (const std::string& path : paths) {
        out += (out.empty() ? "" : ", ") + one_line(path);
    }
    return out;
}

// An error names a file mostly, which need not be the work's own: a recipe's base.
void tell_failure(const std::string& input, const std::exception& error) {
    const std::string reason = one_line(io::reason_of(error));
    tell_event(reason.starts_with(input) ? reason : input + ": " + reason);
}

void require_files(std::span<const std::string> words, const std::string& output) {
    for (const std::string& word : words) {
        if (word == io::standard_stream || io::is_special(word)) {
            throw lutlib::UsageError("--watch waits for files to change, and " +
                                     io::input_name(word) + " is none; name a file");
        }
    }
    if (output == io::standard_stream || io::is_special(output)) {
        throw lutlib::UsageError("--watch writes a file again and again, and " +
                                 io::output_name(output) + " is none; name a file");
    }
}

/// The files of some work, by the names that it gives them. A recipe may name a base in a folder
/// that cannot be watched; reading it says why not.
std::vector<std::string> files_of(const WatchedWork& work) {
    std::vector<std::string> out = work.from;
    for (const std::string& path : work.from) {
        if (std::string base = io::base_named_in(path); !base.empty() && io::can_be_watched(base)) {
            out.push_back(std::move(base));
        }
    }
    return out;
}

bool lies_in(const std::string& path, const std::string& folder) {
    return fs::path(path).parent_path() == (fs::path(folder) / "x").parent_path();
}

// A folder is told in place of its files where it is not known what of it has changed.
bool is_among(const std::vector<std::string>& files, const std::string& changed) {
    return std::any_of(files.begin(), files.end(), [&](const std::string& file) {
        return file == changed || lies_in(changed, file) || lies_in(file, changed);
    });
}

class Watching {
  public:
    Watching(std::span<const std::string> words,
             const std::function<std::vector<WatchedWork>()>& find)
        : find_(find) {
        std::copy_if(words.begin(), words.end(), std::back_inserter(folders_), is_a_folder);
    }

    [[noreturn]] void run() {
        works_ = find_();
        look_for_files();
        for (std::size_t i = 0; i < works_.size(); ++i) {
            require_apart(i);
        }
        for (std::size_t i = 0; i < works_.size(); ++i) {
            work_on(i, true);
        }
        for (;;) {
            const std::vector<std::string> changed = watch_.wait();
            if (std::any_of(changed.begin(), changed.end(),
                            [&](const std::string& path) { return is_news(path); })) {
                find_again();
            }
            look_for_files();
            for (std::size_t i = 0; i < works_.size(); ++i) {
                if (std::any_of(changed.begin(), changed.end(), [&](const std::string& path) {
                        return is_among(files_[i], path);
                    })) {
                    work_on(i, false);
                }
            }
        }
    }

  private:
    // The command line's inputs may be others now.
    bool is_news(const std::string& path) const {
        return std::find(folders_.begin(), folders_.end(), path) != folders_.end() ||
               (is_look_file(path) &&
                std::none_of(files_.begin(), files_.end(),
                             [&](const auto& files) { return is_among(files, path); }));
    }

    void find_again() {
        try {
            works_ = find_();
        } catch (const std::exception& error) {
            tell_failure(names_text(folders_), error);
        }
    }

    // What is written is not waited for.
    void look_for_files() {
        std::set<fs::path> written;
        for (const WatchedWork& work : works_) {
            written.insert(own_name(work.to));
        }
        files_.clear();
        std::vector<std::string> all = folders_;
        for (const WatchedWork& work : works_) {
            files_.push_back(files_of(work));
            std::copy_if(files_.back().begin(), files_.back().end(), std::back_inserter(all),
                         [&](const std::string& file) {
                             return std::find(all.begin(), all.end(), file) == all.end() &&
                                    !written.contains(own_name(file));
                         });
        }
        watch_.watch(all);
    }

    void require_apart(std::size_t at) const {
        const fs::path output = own_name(works_[at].to);
        for (const std::string& folder : folders_) {
            if (output.parent_path() == own_name(folder)) {
                throw lutlib::UsageError("--watch waits for new looks in '" + folder +
                                         "' and would find what it writes there; write to another "
                                         "folder");
            }
        }
        for (const std::vector<std::string>& files : files_) {
            for (const std::string& file : files) {
                if (own_name(file) == output) {
                    throw lutlib::UsageError("--watch would wait for what it writes: '" + file +
                                             "' is an input too; name another file with -o");
                }
            }
        }
    }

    void work_on(std::size_t at, bool is_first) const {
        const WatchedWork& work = works_[at];
        const std::string input = names_text(work.from);
        try {
            require_apart(at);
            require_replaceable(work.to, {});
            const int code = work.run();
            tell_event(input + (code == ok ? " -> " + output_text(work.to)
                                           : std::string(": nothing was written")));
        } catch (const lutlib::UsageError& error) {
            if (is_first) {
                throw;
            }
            tell_failure(input, error);
        } catch (const std::exception& error) {
            tell_failure(input, error);
        }
    }

    const std::function<std::vector<WatchedWork>()>& find_;
    std::vector<std::string> folders_; ///< of the command line
    std::vector<WatchedWork> works_;
    std::vector<std::vector<std::string>> files_; ///< of each work
    io::FileWatch watch_;
};

} // namespace

void WatchOption::declare(Verb& verb) {
    verb.add_flag("--watch", given_,
                  "write again whenever an input or a recipe's base changes, until Ctrl-C or "
                  "SIGTERM; a line for each on standard error");
}

void WatchOption::run(std::span<const std::string> words, const std::string& output,
                      const std::function<std::vector<WatchedWork>()>& find) const {
    require_files(words, output);
    const io::EndedBySignals ended;
    Watching(words, find).run();
}

} // namespace converter
