// The renderer's health on a device, for one scene or picture: extreme inputs, faults planted at
// the inputs of its passes, and how far the finished picture moves when a value hardly does.
//
// Bounds
// - Behind the HDR resolve no texel of any pass is NaN or infinite, whatever comes in.
// - In front of it none is either, unless what comes in is not finite, is planted, or is more light
//   than half floats hold (which is infinite there, and 65504 behind).
// - A pass that has a twin in double agrees with it as far as twins.cpp says.
// - What a NaN or infinity at a pass's input changes of the resolved light is within planted_reach
//   texels of it.
// - A change of a millionth moves 99 % of the finished picture by no more than most_p99. By more
//   than a code it moves at most most_moved of its texels, those of one edge that antialiasing
//   walks along to an end which hangs on a rounding, and, where it moves the geometry on the
//   screen, of the texels beside edges the share by which rasterisers move these when they round
//   corners.
#pragma once

#include "preview/check/situation.h"
#include "preview/check/twins.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace preview {

inline constexpr int planted_reach = 16;    ///< texels of the resolved light
inline constexpr double nudge_share = 1e-6; ///< of a value, or radians, metres
inline constexpr double most_p99 = 0.25;    ///< codes of 255
inline constexpr double most_moved = 0.001; ///< of the texels
/// Of those beside edges: a corner may be rounded by 1/256 of a texel, along both axes.
inline constexpr double most_moved_of_edges = 2.0 / 256;
/// How many texels fxaa.comp walks to the end of an edge.
inline constexpr double antialiasing_reach = 25;
/// A difference of neighbours from which fxaa.comp takes it for an edge, of 0..1.
inline constexpr double edge_contrast = 0.0312;

struct PassCount {
    std::string pass, name;
    std::uint64_t texels = 0;
    NonFinite bad;
};

/// What happened to a frame, pass by pass.
struct FrameFinding {
    std::vector<PassCount> passes;       ///< in the order of the frame
    std::string first_bad;               ///< the pass that first has a texel that is not finite
    std::uint64_t before = 0, after = 0; ///< such texels up to the HDR resolve, and from it on
    std::uint64_t nan_before = 0;        ///< those of `before` that are NaN
};

FrameFinding finding_of(const Graph& graph, const std::vector<Observed>& observed);

struct ExtremeResult {
    std::string name, help;
    std::string skipped{}; ///< why this device or input cannot do it; else empty
    FrameFinding frame{};
    std::vector<TwinFigure> twins{};
    std::vector<std::string> faults{}; ///< a sentence for each bound that does not hold
};

struct PlantResult {
    std::string pass, name; ///< who has written the image, and the image
    std::string value;
    FrameFinding frame{};
    /// Texels of the resolved light from the planted one to the farthest that is changed; empty for
    /// images that do not lie on the picture.
    std::optional<int> reach{};
    std::vector<std::string> faults{};
};

/// How far a pass's result moves, in shares of its mean magnitude.
struct PassMove {
    std::string pass, name;
    double largest = 0, p99 = 0, mean = 0;
};

struct NudgeResult {
    std::string name, help;
    std::vector<PassMove> passes{};
    double largest = 0, p99 = 0; ///< of the finished picture, codes of 255
    double moved = 0;            ///< share of its texels that move by more than a code
    double may_move = 0;         ///< share of them that may
    std::string stiffest{};      ///< the pass that moves most for what its inputs do
    double gain = 0;             ///< by how much more, of means
    std::vector<std::string> faults{};
};

struct CheckReport {
    std::vector<ExtremeResult> extremes;
    std::vector<PlantResult> plants;
    std::vector<NudgeResult> nudges;
    /// How many results have a fault.
    std::size_t failed() const;
};

class Checker {
  public:
    /// `situation` as it is asked for. Throws lutlib::Error when this device cannot render it.
    Checker(const gpu::Device& device, Situation situation);

    ExtremeResult check(const Extreme& row);
    /// Every value at every image of floats that a pass up to the HDR resolve samples.
    std::vector<PlantResult> check_plants();
    NudgeResult check(const Nudge& row);

    const Situation& situation() const { return situation_; }

  private:
    /// A frame that has been rendered.
    struct Seen {
        Graph graph;
        FrameHandles handles;
        std::vector<Observed> observed;
    };
    /// GPU objects of what is shown, kept while it is the same.
    FrameInputs inputs_of(const Situation& situation, std::optional<Scene>& moved);
    Seen see(const Situation& situation, bool with_all_apart = false);
    PlantResult plant(const Seen& plain, std::uint32_t version, std::string_view name, float value);

    const gpu::Device& device_;
    Situation situation_;
    Executor executor_;
    std::optional<GpuShown> on_gpu_;
    std::optional<Seen> unmoved_; ///< for nudges
};

/// Everything. `progress` is told of each row before it is rendered.
CheckReport run_check(Checker& checker, const std::function<void(const std::string&)>& progress);

} // namespace preview
