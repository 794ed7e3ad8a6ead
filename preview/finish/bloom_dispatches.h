// Which steps of a bloom's plan one dispatch does. Between two dispatches a GPU waits until the
// first has ended; for small images that takes longer than their work.
#pragma once

#include "preview/finish/blooms.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace preview {

struct BloomDispatch {
    enum class Kind : std::uint8_t {
        step,    ///< one step
        quarter, ///< two halvings
        blur,    ///< both axes of a Gaussian
        small,   ///< steps whose images lie in the shared memory of a single group
    } kind = Kind::step;
    std::size_t first = 0, count = 1; ///< of the plan's steps
    int source =
        BloomPlan::picture_image; ///< of a small one: the one image that it reads from outside
    /// Of a small one, by step: where its target begins in shared memory, in texels. The last
    /// step's target is an image, the only one that others read.
    std::vector<int> places;

    static constexpr int group_texels = 3456; ///< of shared memory: 27 KiB of half floats
    static constexpr int group_threads = 640; ///< of a small one
    static constexpr int thread_texels = 4;   ///< that one of them makes
    static constexpr std::size_t most_steps = 16, most_rows = 224; ///< of a small one
    static constexpr int most_reach = 12; ///< of a blur, in texels on either side
};

/// All steps of the plan, in its order. `fuses`: else each by itself.
std::vector<BloomDispatch> bloom_dispatches(const BloomPlan& plan, bool fuses = true);

/// Whether a step halves by single texels of the four by four about the target's, once its taps are
/// texel_taps().
bool halves_by_texels(const BloomStep& step);

/// How many rows of weights a step takes in a small dispatch: of both axes its taps, of one each
/// texel that some of a thread's neighbouring results lie near. Whole fours.
std::size_t rows_of(const BloomStep& step);

/// Weights of single texels that half a Gaussian's taps stand for: the centre's, then outward.
std::vector<float> texel_weights(const std::vector<BloomTap>& half);

} // namespace preview
