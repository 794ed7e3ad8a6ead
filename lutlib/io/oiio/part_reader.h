// Pixels of a part of a file, whole or as far as they are there.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <string>

namespace lutlib::io {

class PartReader {
  public:
    /// Of the file at `path` that `input` has open. `partial`: what cannot be read is left out.
    PartReader(OIIO::ImageInput& input, std::string path, bool partial)
        : input_(input), path_(std::move(path)), partial_(partial) {}

    struct Wanted {
        int part, first, last; ///< channels first..last - 1
        OIIO::TypeDesc type;   ///< UNKNOWN: each channel's own
    };
    /// All its rows without gaps to `to`; the answer is how many pixels are missing, which are
    /// zeros. Throws Error about `file` where it is not whole and has to be, and where nothing is
    /// there.
    std::size_t read(const Wanted& wanted, std::byte* to, const std::string& file) const;

  private:
    bool is_clean() const;
    bool reads_all_at_once(int part) const;
    std::size_t read_rows(const Wanted& wanted, const OIIO::ImageSpec& spec, bool finds_later,
                          std::byte* to) const;

    OIIO::ImageInput& input_;
    std::string path_;
    bool partial_;
};

} // namespace lutlib::io
