#include "converter/many.h"

#include "converter/command.h"
#include "converter/report.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace converter {
namespace {

using lutlib::io::Route;

constexpr std::size_t megabyte = std::size_t{1} << 20;

// What is worked on at once fits; what never fits is worked on alone.
class MemoryBudget {
  public:
    explicit MemoryBudget(std::size_t bytes) : free_(bytes), all_(bytes) {}

    void take(std::size_t bytes) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return bytes <= free_ || free_ == all_; });
        free_ -= std::min(bytes, free_);
    }
    void give(std::size_t bytes) {
        const std::lock_guard lock(mutex_);
        free_ = std::min(free_ + bytes, all_);
        changed_.notify_all();
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::size_t free_, all_;
};

struct Shard {
    std::size_t number = 1, of = 1;
};

Shard shard_of(const std::string& text) {
    const auto number = [](std::string_view digits) -> std::size_t {
        std::size_t value = 0;
        const char* const end = digits.data() + digits.size();
        const auto read = std::from_chars(digits.data(), end, value);
        return read.ec == std::errc{} && read.ptr == end ? value : 0;
    };
    const std::string_view whole = text;
    const std::size_t slash = std::min(whole.find('/'), whole.size());
    const Shard out{number(whole.substr(0, slash)),
                    slash < whole.size() ? number(whole.substr(slash + 1)) : 0};
    if (out.number < 1 || out.number > out.of) {
        throw lutlib::UsageError("--shard takes K/N with K from 1 to N, as 3/8, not '" + text +
                                 "'");
    }
    return out;
}

std::string reason_now() {
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return "not enough memory for it";
    } catch (const std::exception& error) {
        return error.what();
    }
}

class WorkOff {
  public:
    WorkOff(std::span<const Route> routes, const Work& work, const ManyOptions& options,
            const std::string& output)
        : routes_(routes), work_(work), options_(options), output_(output),
          budget_(options.memory()), reasons_(routes.size()),
          progress_(routes.size(), work.what, options.is_verbose()) {}

    std::vector<Failure> all() {
        std::vector<std::thread> others;
        for (std::size_t i = 1; i < std::min(options_.jobs(), routes_.size()); ++i) {
            others.emplace_back([this] { work_off(); });
        }
        work_off();
        for (std::thread& other : others) {
            other.join();
        }
        std::vector<Failure> out;
        for (std::size_t i = 0; i < routes_.size(); ++i) {
            if (reasons_[i]) {
                out.push_back({routes_[i].from.path, *reasons_[i]});
            }
        }
        return out;
    }

  private:
    void work_off() {
        for (std::size_t i = next_++; i < routes_.size(); i = next_++) {
            try {
                work_on(i);
            } catch (...) {
                reasons_[i] = reason_now();
                progress_.say("lutconv: " + one_line(*reasons_[i]) + '\n',
                              std::string(lutlib::io::standard_stream));
            }
            progress_.step();
        }
    }

    void work_on(std::size_t i) {
        const std::size_t bytes = work_.bytes ? work_.bytes(routes_[i]) : 0;
        struct Lease {
            MemoryBudget& budget;
            std::size_t bytes;
            ~Lease() { budget.give(bytes); }
        };
        budget_.take(bytes);
        std::string line;
        {
            const Lease lease{budget_, bytes};
            line = work_.run(routes_[i], i);
        }
        if (options_.is_verbose()) {
            progress_.say(fmt::format("{} ({} of {})\n", line, ++finished_, routes_.size()),
                          output_);
        }
    }

    std::span<const Route> routes_;
    const Work& work_;
    const ManyOptions& options_;
    const std::string& output_;
    MemoryBudget budget_;
    std::vector<std::optional<std::string>> reasons_;
    Progress progress_;
    std::atomic<std::size_t> next_ = 0, finished_ = 0;
};

} // namespace

void ManyOptions::declare(Verb& verb) {
    const std::string heading = "Many files";
    verb.add_option("--frames", frames_,
                    "the frames of a pattern (shot.####.exr, shot.%04d.exr): 1001-1100, "
                    "1001-1100x2, and several with commas between (default: those that are there)")
        .group(heading);
    verb.add_flag("--resume", resume_,
                  "leave out files whose output is there and newer than all that it is made of")
        .group(heading);
    verb.add_flag("--missing", missing_,
                  "make nothing; list outputs that are not there, or older than what they are made "
                  "of, and exit with 1 if any is")
        .group(heading);
    verb.add_option("--shard", shard_,
                    "K/N: every N-th file from the K-th on, to share them between N machines")
        .group(heading);
    verb.add_option("--jobs", jobs_, "files that are worked on at once (default: one a core)")
        .takes(Takes::count)
        .group(heading);
    verb.add_option("--memory", memory_,
                    "megabytes for what is worked on at once (default: 224 for each of --jobs)")
        .takes(Takes::count)
        .group(heading);
    verb.add_flag("-v,--verbose", verbose_, "a line for each file, in place of a bar")
        .group(heading);
}

std::vector<Route> ManyOptions::of_shard(std::vector<Route> routes) const {
    if (shard_.empty()) {
        return routes;
    }
    const Shard shard = shard_of(shard_);
    std::vector<Route> out;
    for (std::size_t i = shard.number - 1; i < routes.size(); i += shard.of) {
        out.push_back(std::move(routes[i]));
    }
    return out;
}

std::size_t ManyOptions::jobs() const {
    return jobs_ > 0 ? static_cast<std::size_t>(jobs_)
                     : std::max(1U, std::thread::hardware_concurrency());
}

std::size_t ManyOptions::memory() const {
    constexpr std::size_t usual = 224;
    return (memory_ > 0 ? static_cast<std::size_t>(memory_) : usual * jobs()) * megabyte;
}

std::vector<Failure> run_each(std::span<const Route> routes, const Work& work,
                              const ManyOptions& options, const std::string& output) {
    return WorkOff(routes, work, options, output).all();
}

std::size_t take_out_done(std::vector<Route>& routes, std::vector<std::string> others) {
    others.emplace_back();
    return std::erase_if(routes, [&](const Route& route) {
        others.back() = route.from.path;
        return lutlib::io::is_up_to_date(route.to, others);
    });
}

int tell_missing(std::span<const Route> missing, std::size_t there, std::string_view what,
                 bool json) {
    if (json) {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (const Route& route : missing) {
            list.push_back(route.to);
        }
        print(nlohmann::ordered_json{{"missing", list}, {"were_there", there}}, "");
    } else {
        std::string text = fmt::format("{} of {} {} there\n", there, there + missing.size(), what);
        for (const Route& route : missing) {
            text += "  missing: " + output_text(route.to) + '\n';
        }
        print(text, "");
    }
    return missing.empty() ? ok : verification_failed;
}

void tell_remarks(std::span<const std::string> remarks) {
    for (const std::string& remark : remarks) {
        print("lutconv: " + one_line(remark) + '\n', std::string(lutlib::io::standard_stream));
    }
}

} // namespace converter
