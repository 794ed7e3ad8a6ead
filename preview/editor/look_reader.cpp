#include "preview/editor/look_reader.h"

#include "lutlib/io/reason.h"
#include "preview/editor/look_folder.h"

#include <algorithm>
#include <set>
#include <utility>

namespace preview::editor {

namespace {

std::vector<std::uint64_t> tickets_of(const std::vector<LookJob>& jobs) {
    std::vector<std::uint64_t> out;
    for (const LookJob& job : jobs) {
        out.push_back(job.ticket);
    }
    return out;
}

ReadLook done(const LookJob& job) {
    ReadLook out{job.ticket, nullptr};
    try {
        if (job.make_scene) {
            out.scene = job.make_scene();
        } else {
            out.look = job.make();
        }
    } catch (const std::exception& error) {
        out.reason = lutlib::io::reason_of(error);
        std::replace(out.reason.begin(), out.reason.end(), '\n', ' ');
    }
    return out;
}

} // namespace

LookReader::LookReader(std::function<void()> on_ready)
    : on_ready_(std::move(on_ready)), thread_([this] { run(); }) {}

LookReader::~LookReader() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    watch_.wake();
    thread_.join();
}

void LookReader::ask(const std::string& folder, std::vector<LookJob> jobs) {
    {
        const std::lock_guard lock(mutex_);
        if (folder == folder_ && tickets_of(jobs) == tickets_of(jobs_)) {
            return;
        }
        folder_ = folder;
        jobs_ = std::move(jobs);
        asked_anew_ = true;
    }
    watch_.wake();
}

LookReader::News LookReader::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(news_, {});
}

void LookReader::publish(const std::function<void(News&)>& put) {
    {
        const std::lock_guard lock(mutex_);
        put(news_);
    }
    on_ready_();
}

bool LookReader::is_asked_anew() {
    const std::lock_guard lock(mutex_);
    return asked_anew_ || ends_;
}

void LookReader::watch_anew(const std::string& folder) {
    try {
        std::vector<std::string> paths;
        if (!folder.empty()) {
            paths.push_back(folder);
        }
        watch_.watch(paths);
    } catch (const std::exception& error) {
        publish([&](News& news) { news.failure = lutlib::io::reason_of(error); });
    }
}

void LookReader::run() {
    try {
        work();
    } catch (const std::exception& error) {
        publish([&](News& news) { news.failure = lutlib::io::reason_of(error); });
    }
}

void LookReader::work() {
    std::string watched;
    std::set<std::uint64_t> finished; // of the jobs that are wanted still
    for (;;) {
        std::vector<std::string> changed = watch_.wait();
        std::unique_lock lock(mutex_);
        if (ends_) {
            return;
        }
        asked_anew_ = false;
        const std::string folder = folder_;
        const std::vector<LookJob> jobs = jobs_;
        lock.unlock();
        std::erase_if(changed, [&](const std::string& path) { // none wakes the window for nothing
            return path != folder && !may_be_look(path);
        });
        if (folder != watched) {
            watch_anew(folder);
            watched = folder;
        } else if (!changed.empty()) {
            publish([&](News& news) {
                news.changed.insert(news.changed.end(), changed.begin(), changed.end());
            });
        }
        std::set<std::uint64_t> still;
        for (const LookJob& job : jobs) {
            if (finished.count(job.ticket) > 0) {
                still.insert(job.ticket);
            }
        }
        finished = std::move(still);
        for (const LookJob& job : jobs) {
            if (finished.count(job.ticket) > 0) {
                continue;
            }
            if (is_asked_anew()) {
                break; // for what is wanted now, once wait() has come back at once
            }
            ReadLook read = done(job);
            publish([&](News& news) { news.looks.push_back(std::move(read)); });
            finished.insert(job.ticket);
        }
    }
}

} // namespace preview::editor
