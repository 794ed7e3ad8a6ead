// The picture that verify looks at, the engine it is for, and in what it breaks that engine's
// contract.
#pragma once

#include "lutlib/bake/bake.h"
#include "lutlib/io/png.h"

#include <optional>
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
    /// Of those, what the PNG's chunks say of its colours, in words; empty when they do no harm.
    std::string tags;
    std::vector<std::string> notes; ///< what the engine ignores

    /// Whether its nodes are chosen for what lies between them, as its text says.
    bool fitted() const;
};

/// The chunks of a PNG that say what its codes mean: of sRGB, gAMA, cHRM, iCCP those it has.
std::vector<std::string_view> color_chunks(const lutlib::io::PngImage& image);

/// In what a picture of `size` nodes in the engine's layout is not what the engine wants; empty: it
/// takes the picture as it is.
std::vector<std::string> contract_points(const lutlib::io::PngImage& image,
                                         const lutlib::Engine& engine, int size);

/// Reads a picture of any type. Without `engine` the picture's own word decides, else its content.
/// `row` picks one of several lattices below each other, from the top. Throws Error when the layout
/// cannot be told, UsageError for a row that is not there.
Subject open_subject(const std::string& path, const lutlib::Engine* engine,
                     std::optional<int> row = std::nullopt);

} // namespace converter
