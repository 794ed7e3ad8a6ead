// The picture that verify looks at, the engine it is for, and in what it breaks that engine's
// contract.
#pragma once

#include "lutlib/bake/bake.h"
#include "lutlib/io/png.h"

#include <string>
#include <vector>

namespace converter {

/// How the engine came to be known.
enum class NamedBy {
    option,  ///< --engine
    picture, ///< the text entry that bake writes
    content, ///< the first engine with the layout that the content shows
};

struct Subject {
    lutlib::io::PngImage image;
    lutlib::CodeImage codes;
    const lutlib::Engine* engine = nullptr;
    NamedBy named_by = NamedBy::option;
    int size = 0;                      ///< 0 when the engine's layout has no such picture
    std::vector<std::string> contract; ///< each point in which it is not what the engine wants

    /// Whether its nodes are chosen for what lies between them, as its text says.
    bool fitted() const;
};

/// Reads a PNG. Without `engine` the picture's own word decides, else its content. Throws Error
/// when the layout cannot be told.
Subject open_subject(const std::string& path, const lutlib::Engine* engine);

} // namespace converter
