// Frames for the report: what a pass has made and the finished picture, in doubles, and how long
// passes take.
#pragma once

#include "lutlib/survey/timing.h"
#include "preview/check/situation.h"
#include "preview/frame/frame.h"
#include "preview/frame/shown.h"
#include "preview/graph/execute.h"
#include "preview/reference/image.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace preview::report {

/// What is looked at of a frame beside the finished picture.
struct Looked {
    /// What is compared of a pass: declares what it needs and returns it, or gives an empty handle;
    /// null: the finished picture itself.
    ImageHandle (*result)(Graph& graph, const FrameHandles& handles) = nullptr;
    bool light = false; ///< in front of the bloom
    bool depth = false;
};

struct Frame {
    reference::Image finished, result, light; ///< `result` is `finished` where nothing else is
    std::vector<float> depth;                 ///< 1 - near / z; 1: nothing
};

/// What a frame costs as it stands.
struct Costs {
    std::size_t passes = 0;   ///< that run
    std::uint64_t bytes = 0;  ///< of images that they read or write, once each
    std::uint64_t memory = 0; ///< of images and buffers that live within the frame
    lutlib::Timing time;      ///< of all of them, by the device's timestamps
};

/// Which passes are timed, by name.
using Counts = bool (*)(std::string_view pass);

class Renderer {
  public:
    /// Throws lutlib::Error on a device without timestamps.
    explicit Renderer(const gpu::Device& device);

    /// One frame; maps stay from the one before where nothing has moved. Situations with the same
    /// `shown` share its GPU objects.
    Frame render(const Situation& situation, const Looked& looked = {});

    /// As the program itself draws it: measured first, and then a frame after one that was alike.
    Frame render_as_usual(const Situation& situation);
    /// Of frames as the program draws them, and the picture of the last.
    std::pair<Costs, reference::Image> costs_of(const Situation& situation, int rounds);

    /// Seconds that the passes take that `counts` accepts, of all situations in turn, `rounds`
    /// times, warm.
    std::vector<lutlib::Timing> time(std::span<const Situation> situations, Counts counts,
                                     int rounds);

    /// Forgets the GPU objects of what has been shown.
    void forget();

    /// The graph of a frame of this runs on this.
    FrameInputs inputs_of(const Situation& situation);
    Executor& executor() { return executor_; }

    const gpu::Device& device() const { return device_; }
    bool is_cpu() const { return is_cpu_; }
    /// Whether shaders can write images of that format and sample them, filtered.
    bool can_store(Format format) const;

  private:
    /// With the HDR maximum measured, as far as the frame asks for it.
    FrameInputs measured(const Situation& situation);

    const gpu::Device& device_;
    bool is_cpu_;
    Executor executor_; ///< of all frames, for it keeps maps from one to the next
    std::vector<std::unique_ptr<GpuShown>> shown_;
};

inline double milliseconds(double seconds) {
    return 1e3 * seconds;
}

} // namespace preview::report
