// LUT pictures: an engine's baked lattice out as a PNG file, any recognised layout of any file type
// in.
#pragma once

#include "lutlib/bake/bake.h"
#include "lutlib/engine/recognise.h"
#include "lutlib/io/png.h"

#include <optional>
#include <string>
#include <string_view>

namespace lutlib::io {

/// What the PNG's text says of where it came from.
struct BakeOrigin {
    std::string source;
    std::string title;
    std::string_view interpolation;
    bool fitted = false;       ///< to the engine's lookup, rather than sampled at the nodes
    EncodingNames encodings{}; ///< of the picture's codes
    EncodingNames look{};      ///< of the look, where the bake converts
};

/// The file's bytes, with the engine's sRGB tag and text entries Source, Title, Engine,
/// Interpolation, Lattice ("fitted" or "point-sampled"), Tones, Software, "Input encoding" and
/// "Output encoding" of the picture, and "Look input" and "Look output": those encodings that are
/// known.
std::string picture_bytes(const Bake& bake, const BakeOrigin& origin);

/// Text entry "Tones" of a look that is a negative, as nothing else tells it from another look's
/// picture that was turned by 180 degrees since. Its codes are laid out already.
void append_tones(PngImage& image, const Layout& layout, int size);

/// Text entries "Input encoding" and "Output encoding", where they are known.
void append_encodings(PngImage& image, const EncodingNames& names);
/// What a picture's entries say of its own encodings, and of the look's before a bake converted it.
EncodingNames encodings_of(const PngImage& image);
EncodingNames look_encodings_of(const PngImage& image);

/// The RGB codes of a PNG, alpha left out.
CodeImage code_picture(const PngImage& image);

/// A text entry of a PNG, if it has one.
std::optional<std::string> text_entry(const PngImage& image, std::string_view key);

/// Whether a file is a picture that lutconv or lutpreview made, as its text says. False for what
/// cannot be read.
bool is_own_picture(const std::string& path);

/// A picture that may hold a lattice.
struct LutPicture {
    Picture picture;    ///< of codes / largest code; floats as they are
    int bits = 8;       ///< of a code: 8 or 16; 0 where the file stores floats
    bool alpha = false; ///< the file has one, by which colours are divided where it multiplies them
    std::string title;
    const Engine* engine = nullptr; ///< the one that its text names
    EncodingNames encodings{};      ///< that its text names
    bool says_negative = false;     ///< its text says that brighter inputs become darker
    /// What its file type does to codes, a sentence each.
    std::vector<std::string> remarks{};
};

/// PNG by itself, every other type through OpenImageIO. Throws Error.
LutPicture read_lut_picture(std::string_view bytes, const std::string& file);

/// As integer codes, for lookups that read them: of its own bits, floats held to 0..1 in 16.
CodeImage code_picture(const LutPicture& picture);

/// By its content; where that does not tell, by the engine that was `named` or that its text names.
/// Throws Error where nothing tells.
Recognised layout_of(const LutPicture& picture, const std::string& file,
                     const Engine* named = nullptr);

} // namespace lutlib::io
