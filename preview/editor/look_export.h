// The look as a LUT file or an engine's picture, made ready before anything is written, so that
// what it would lose can be seen first. Throws lutlib::Error.
#pragma once

#include "lutlib/color/encoding.h"
#include "preview/editor/model.h"

#include <string>

namespace preview::editor {

/// What the file is to be.
struct ExportChoice {
    int size = 0;                      ///< nodes a side; 0: the look's own, of a strip the engine's
    int bits = 0;                      ///< of a strip; 0: the engine's
    lutlib::LookEncodings encodings{}; ///< of a LUT file; unset: as the look has them
    friend bool operator==(const ExportChoice&, const ExportChoice&) = default;
};

struct PreparedExport {
    std::string path, bytes;
    std::string report{}; ///< what it is, and what of the look is lost with which error, in lines
    bool loses = false;   ///< more than floats round
};

/// The recipe as a LUT in the format of the path's extension. Its error is measured against the
/// recipe, exactly evaluated, as the file is read.
PreparedExport prepare_lut(const State& state, const ExportChoice& choice, const std::string& path);
/// The recipe as a strip for that engine, as `lutconv bake` makes it, its error as that engine
/// reads it.
PreparedExport prepare_strip(const State& state, const lutlib::Engine& engine,
                             const ExportChoice& choice, const std::string& path);
/// Writes it whole or not at all.
void write(const PreparedExport& prepared);

} // namespace preview::editor
