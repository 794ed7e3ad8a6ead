// The pictures that match learns from: which belong together, and what their pixels are.
#pragma once

#include "lutlib/color/encoding.h"
#include "lutlib/engine/layout.h"
#include "lutlib/match/shift.h"

#include <span>
#include <string>
#include <vector>

namespace converter {

/// The same picture before and after a grade.
struct PairPaths {
    std::string before, after;
};

/// Of words in turns, BEFORE AFTER BEFORE AFTER; folders are paired by the names of their files,
/// patterns (lutlib/io/frames.h) by the numbers of their frames. What a folder leaves out is said.
/// Throws Error for what has no partner, UsageError.
std::vector<PairPaths> pairs_of(std::span<const std::string> words, const std::string& frames);

/// What the codes are, as options name it; unset: as the files say, else sRGB.
struct PairEncodings {
    lutlib::LookEncodings pictures; ///< before and after
    lutlib::LookEncodings look;     ///< unset: the pictures', of light sRGB
};

struct PicturePair {
    /// Codes of the look's encodings. Pixels that nobody sees, as their alpha is 0, are NaN.
    lutlib::Picture before, after;
    lutlib::LookEncodings look; ///< both set
    lutlib::Shift shift;        ///< of the picture after, which has been moved back by it
    int bits = 0;               ///< of a sample of the picture after; 0: floats
    bool is_lossy = false;      ///< the file of the picture after, so that pixels are not exact
    /// What was guessed, and what a lossy file does to codes, a sentence each.
    std::vector<std::string> remarks;
};

/// One picture alone, as one of a pair is read.
struct LonePicture {
    lutlib::Picture colors; ///< codes of `encoding`; NaN where nobody sees them
    lutlib::Encoding encoding;
    std::vector<std::string> remarks;
};
/// `option` names the encoding. Throws Error.
LonePicture read_lone(const std::string& path, const std::optional<lutlib::Encoding>& encoding,
                      const char* option);

/// The encoding of a look for pictures of this one: sRGB for light, whose codes lie too far apart
/// where the eye sees most.
lutlib::Encoding for_a_lattice(const lutlib::Encoding& pictures);

/// Upright, alpha divided out, moved onto each other by whole pixels. Throws Error, also for
/// pictures of two sizes and such as no shift lays on each other.
PicturePair read_pair(const PairPaths& paths, const PairEncodings& encodings);

} // namespace converter
