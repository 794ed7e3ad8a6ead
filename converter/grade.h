// One picture through a look, from its file into a new one.
#pragma once

#include "converter/grade_pixels.h"
#include "lutlib/io/image.h"
#include "lutlib/io/look.h"
#include "lutlib/recipe/placement.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace converter {

/// How a picture's alpha stands to its colours.
struct AlphaRule {
    std::string_view name, help;
    std::optional<bool> premultiplied; ///< unset: as the file type says
    bool ignored = false;              ///< the look sees the stored colours
};
std::span<const AlphaRule> alpha_rules();

/// What is the same for every picture of a run.
struct Grading {
    const lutlib::io::Look& look;
    const AlphaRule& alpha;
    std::optional<lutlib::Encoding> picture_encoding, output_encoding; ///< as they were named
    bool converts = true;                                              ///< between encodings
    const lutlib::Adaptation& adaptation;
    std::string depth{}; ///< of the result; empty: the nearest to the picture's own
    lutlib::io::ImageReadOptions reading{}; ///< of the picture
    double strength = 1;   ///< of the look: 0 the picture's own codes, 1 the graded ones
    bool explains = false; ///< what was left out is said
    LookOfPixels pixels{look};
};

/// Of a picture, or of many.
struct PixelCounts {
    std::size_t pixels = 0;
    std::size_t outside_domain = 0; ///< whose input was clamped to the LUT's domain
    std::size_t clamped = 0;        ///< whose output an integer file clamps to 0..1
    std::size_t not_a_number = 0;   ///< that a conversion read as 0

    PixelCounts& operator+=(const PixelCounts& more);
};

/// What became of a picture.
struct Graded {
    int width = 0, height = 0;
    bool has_alpha = false;
    PixelCounts counts;
    double share = 1; ///< of its pixels that its file holds
    const lutlib::io::DepthInfo* depth = nullptr;
    lutlib::LookPlace place;
    std::vector<std::string> remarks{};  ///< of channels that were chosen
    std::vector<std::string> lost{};     ///< of the picture's file, a phrase each
    std::vector<std::string> left_out{}; ///< as it was not needed, a sentence each
};

/// Throws UsageError for a depth that files of the type of `output` cannot store, and for a type
/// that cannot be written; the answer is those that they can.
std::vector<lutlib::io::Depth> require_depth(const std::string& depth, const std::string& output);

/// `held` is what require_depth() answered for `output`. Both files may be `-`. Throws Error.
Graded grade_file(const Grading& grading, const std::string& picture, const std::string& output,
                  std::span<const lutlib::io::Depth> held);

} // namespace converter
