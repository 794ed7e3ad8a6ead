// The descriptor of a LUT file format, and of what a format can hold.
#pragma once

#include "lutlib/byte_source.h"
#include "lutlib/limits.h"
#include "lutlib/lut.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib {

struct Engine;
struct Layout;

/// One thing that a conversion could not keep, with its figure: {"domain 0..4 cut to 0..1", 3,
/// "of 4 units of input"}. A list of them is printed, and is an error under --strict.
struct Loss {
    std::string what;
    double figure = 0;
    std::string unit; ///< of what the figure counts; "": the figure is a difference of values

    bool is_difference() const { return unit.empty(); }
};

/// A difference of values no larger than what float arithmetic or the last of six decimals makes:
/// --strict passes it.
inline bool is_float_rounding(const Loss& loss) {
    return loss.is_difference() && loss.figure <= 1e-6;
}

/// What a file of a format can say. A Lut is fitted to it before it is written.
struct Holds {
    bool curve = false;              ///< a 1D table alone
    bool cube = false;               ///< a 3D table alone
    bool curve_and_cube = false;     ///< a shaper followed by a cube
    bool curve_domain = false;       ///< an input interval of the 1D table other than 0..1
    bool cube_domain = false;        ///< an input interval of the cube other than 0..1
    bool per_channel_domain = false; ///< the interval may differ between channels
    bool title = false;
    bool keywords = false;      ///< Lut::keywords
    bool encodings = false;     ///< Lut::encodings
    bool interpolation = false; ///< Lut::interpolation, trilinear or tetrahedral
    bool tiny = true;           ///< numbers nearer to 0 than the least normal float, 1.2e-38
    int min_cube_size = limits::min_cube_size;
    int max_cube_size = limits::max_cube_size;
    int integer_bits = 0; ///< codes of so many bits over 0..1, values outside clamped; 0: float
    int decimals = 0;     ///< decimals of a text format that rounds; 0: every bit kept
};

struct ReadOptions {
    /// Nodes per side of the cube onto which a transform is sampled that is no shaper and cube.
    /// 0: 65, or for a transform with a cube in it, the next multiple of its cells from there.
    int size = 0;
    /// The layout in which to read a picture, whatever its content shows; null: the content's.
    const Layout* layout = nullptr;
    /// The engine that a picture was made for: decides where the content does not tell.
    const Engine* engine = nullptr;
    /// Which of a picture's stacked lattices, from the top.
    int row = 0;
};

struct WriteOptions {
    std::string title; ///< replaces the look's own when not empty
    int size = 0;      ///< nodes per side of the cube; 0: the look's own, or as the format needs
    int bits = 16;     ///< of pictures: 8 or 16
};

/// A look as a table, with what that lacks of the file.
struct Reading {
    Lut lut;
    std::vector<Loss> losses{};       ///< what of the file was not read
    std::vector<Loss> table_losses{}; ///< what of the rest no table holds; none: the table is exact
    const Layout* layout = nullptr;   ///< of a picture
    const Engine* engine = nullptr;   ///< that a picture's text names
    /// Guesses and contradictions, a sentence each.
    std::vector<std::string> remarks{};

    std::vector<Loss> all_losses() const {
        std::vector<Loss> out = losses;
        out.insert(out.end(), table_losses.begin(), table_losses.end());
        return out;
    }
};

/// File name extensions, lower case and without the dot; the first is what new files are given.
class Extensions {
  public:
    constexpr Extensions(std::initializer_list<std::string_view> all) {
        for (const std::string_view extension : all) {
            all_.at(count_++) = extension;
        }
    }
    constexpr const std::string_view* begin() const { return all_.data(); }
    constexpr const std::string_view* end() const { return all_.data() + count_; }
    constexpr bool contain(std::string_view extension) const {
        return std::find(begin(), end(), extension) != end();
    }
    std::string first() const { return std::string(all_.front()); }

  private:
    std::array<std::string_view, 9> all_{};
    std::size_t count_ = 0;
};

/// A format of LUT files: one row, at the end of the file that knows the format. Functions that are
/// null make a format that is only written or only read; each is handed its own row.
struct FileFormat {
    /// How many of a file's first bytes are enough to recognise it, where it has read_in_pieces.
    static constexpr std::size_t head_bytes = std::size_t{64} << 10;

    std::string_view name;  ///< as in --format
    std::string_view label; ///< for help
    Extensions extensions;
    Holds holds;
    /// A text within the first 4096 bytes of every such file, and of no other format's.
    std::string_view magic{};
    /// For formats that no such text marks: how surely these bytes (the whole file) are of this
    /// format, 0 no .. 100 yes. With neither only the extension tells.
    int (*recognise)(std::string_view bytes) = nullptr;
    /// Parses a whole file. `file` names it in errors and lends its extension. Throws Error.
    Reading (*read)(const FileFormat& format, std::string_view bytes, const std::string& file,
                    const ReadOptions& options) = nullptr;
    /// The same of a UTF-8 file that arrives in pieces: its first bytes, as many as `recognise`
    /// looks at, and the rest. Null where it must be there whole.
    Lut (*read_in_pieces)(std::string_view head, ByteSource& more,
                          const std::string& file) = nullptr;
    /// As `read`, but values that are no numbers are read as NaN instead of refused: for examining
    /// and repairing. Null where a file of the format cannot hold any.
    Lut (*read_broken)(std::string_view bytes, const std::string& file) = nullptr;
    /// The file's bytes. Expects a Lut that `holds` can hold; throws Error otherwise.
    std::string (*write)(const FileFormat& format, const Lut& lut,
                         const WriteOptions& options) = nullptr;
    /// Which programs do not read a file of this look, or read it otherwise, a sentence each.
    std::vector<std::string> (*readers)(const Lut& lut) = nullptr;
    /// OpenColorIO reads it: its own evaluation of a file may say more than a table of ours.
    bool opencolorio = false;
    std::string_view opencolorio_writer{}; ///< its name for its writer, where it writes the format
    bool picture = false;                  ///< pixels; the extension does not tell that it is a LUT
    const Layout* layout = nullptr;        ///< of pictures in one layout
};

} // namespace lutlib
