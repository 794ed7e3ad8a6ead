// Bakes the looks of both sides on a thread of its own, so that a frame never waits for one.
#pragma once

#include "preview/editor/model.h"
#include "preview/look/look_bake.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace preview::editor {

/// What the look of a side depends on.
struct LookRequest {
    lutlib::Recipe recipe;
    std::array<Side, 2> sides;
    PictureCodes picture{};
};
bool same(const LookRequest& a, const LookRequest& b);

struct BakedLooks {
    std::array<LoadedLook, 2> sides;
    std::string error; ///< why there are none; empty when there are
    double milliseconds = 0;
};

/// The look of one side, on these codes; a recipe's is a quick table. Throws lutlib::Error for what
/// its lookup cannot hold.
LoadedLook look_of(const lutlib::Recipe& recipe, const Side& side,
                   const PictureCodes& picture = {});

/// Bakes a request's looks at once. When no other follows for a moment, tables that stand for the
/// recipe are measured against it, and finer ones are made where the difference could be seen.
class LookBaker {
  public:
    /// `on_ready` is called on the baking thread after each bake.
    explicit LookBaker(std::function<void()> on_ready);
    ~LookBaker();
    LookBaker(const LookBaker&) = delete;
    LookBaker& operator=(const LookBaker&) = delete;

    /// Replaces a request that is still waiting: only the newest is baked.
    void request(LookRequest request);
    /// The newest finished looks, once.
    std::optional<BakedLooks> take();
    /// A request is waiting, being baked, or has not been taken.
    bool is_busy();

  private:
    void run();
    void publish(BakedLooks baked, bool is_last);
    void refine(const LookRequest& request, BakedLooks baked);
    bool is_outdated();

    std::function<void()> on_ready_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<LookRequest> waiting_;
    std::optional<BakedLooks> finished_;
    bool bakes_ = false, ends_ = false;
    std::thread thread_;
};

} // namespace preview::editor
