// The passes that every pixel goes through, timed against a plain copy.
//
// Every pass is timed by GPU timestamps, several times a frame over many frames; the median counts.
#pragma once

#include "preview/cli/headless.h"
#include "preview/frame/frame.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace preview {

struct BenchOptions {
    std::uint32_t width = 3840, height = 2160;
    int frames = 60;
    bool json = false, only_effects = false;
    std::string device, output;
};

struct PassRow {
    std::string group, name;
    double milliseconds = 0;
    std::uint64_t bytes = 0;
    double ratio = 0;   ///< to the copy of the same formats
    double allowed = 0; ///< milliseconds for those bytes at the copy's bandwidth
    bool exact = true;  ///< not left to the texture unit's filter
};

/// The sample scene with everything on, by one rasteriser.
struct FrameTimings {
    std::string raster;
    Timings timings;
};

/// run() times everything. Both must outlive it.
class Bench {
  public:
    Bench(const gpu::Device& device, const BenchOptions& options);

    void run();

    const std::vector<PassRow>& rows() const { return rows_; }
    const std::vector<FrameTimings>& frames() const { return frames_; }

  private:
    gpu::Image half_image(const std::vector<float>& texels);
    double time(const Graph& graph, const std::function<bool(const std::string&)>& counts,
                int divisor);
    PassRow measure(std::string group, std::string name, const std::string& pass,
                    const std::function<ImageHandle(Graph&)>& declare);
    void add(PassRow row, const PassRow& copy);
    PassRow time_copy(const std::string& name, const gpu::Image& image);
    void time_lookups(const std::string& format, const gpu::Image& image);
    void time_finishing();
    void time_scopes();
    void time_effects();
    void time_sample();
    void time_parts(FrameInputs inputs, FrameSettings settings);
    void time_slider(const FrameInputs& inputs, FrameSettings settings);
    void time_frame(std::string name, const FrameInputs& inputs, const FrameSettings& settings);

    const gpu::Device& device_;
    const BenchOptions& options_;
    Executor executor_;
    Size size_;
    std::optional<gpu::Image> display_, hdr_, depth_;
    PassRow copy_;
    std::vector<PassRow> rows_;
    Timings frame_; ///< of the last row of a frame
    std::vector<FrameTimings> frames_;
};

} // namespace preview
