// Looks and built-in scenes made ready for small pictures of them, on a thread of their own, and
// the folder that the looks lie in watched for changes.
#pragma once

#include "lutlib/io/watch.h"
#include "preview/look/look_bake.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace preview {
struct Shown;
}

namespace preview::editor {

/// Who asks again, as after a change, takes another ticket.
struct LookJob {
    std::uint64_t ticket = 0;
    /// On the reader's thread; null: the file is no look at all. What it throws becomes a reason.
    std::function<std::shared_ptr<const LoadedLook>()> make;
    /// In place of a look: a scene, likewise.
    std::function<std::shared_ptr<const Shown>()> make_scene{};
};

struct ReadLook {
    std::uint64_t ticket = 0;
    std::shared_ptr<const LoadedLook> look; ///< null: there is none
    std::shared_ptr<const Shown> scene{};   ///< likewise
    std::string reason{};                   ///< why not, in one line; empty where it is no look
};

class LookReader {
  public:
    /// `on_ready` is called on the reading thread whenever take() has something. Throws
    /// lutlib::Error where the system tells of no changes.
    explicit LookReader(std::function<void()> on_ready);
    ~LookReader();
    LookReader(const LookReader&) = delete;
    LookReader& operator=(const LookReader&) = delete;

    /// These are wanted, in this order, and no others any more; each ticket is done once. `folder`
    /// is watched; empty: none is.
    void ask(const std::string& folder, std::vector<LookJob> jobs);

    struct News {
        std::vector<ReadLook> looks;
        /// Files of the folder that may be looks, or the folder itself where all may have.
        std::vector<std::string> changed;
        std::string failure{}; ///< why changes are not seen, said once for a folder
    };
    /// What there is since the last call.
    News take();

  private:
    void run();
    void work();
    void watch_anew(const std::string& folder);
    void publish(const std::function<void(News&)>& put);
    bool is_asked_anew();

    std::function<void()> on_ready_;
    std::mutex mutex_;
    std::string folder_;
    std::vector<LookJob> jobs_;
    bool asked_anew_ = false, ends_ = false;
    News news_;
    // The thread's own.
    lutlib::io::FileWatch watch_;
    std::thread thread_;
};

} // namespace preview::editor
