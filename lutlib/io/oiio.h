// The door of the OpenImageIO module. No OpenImageIO header here.
#pragma once

#include "lutlib/io/image.h"

#include <functional>
#include <string>
#include <vector>

namespace lutlib::io {

class Oiio {
  public:
    virtual ~Oiio() = default;

    /// Gives the memory that a picture of so many bytes is decoded into; is asked once, before.
    using Allocate = std::function<SampleBuffer(std::size_t bytes)>;

    virtual std::string version() const = 0;
    /// `file` names the picture at `path` in errors. Its type is told by its bytes.
    virtual SampleImage read(const std::string& path, const std::string& file,
                             const ImageReadOptions& options = {},
                             const Allocate& allocate = {}) const = 0;
    /// Pixels of all parts, and their bytes in the file's own types, by its header; zeros where it
    /// cannot be read.
    struct Size {
        std::size_t pixels = 0, bytes = 0;
    };
    virtual Size size(const std::string& path) const = 0;
    /// Whether a picture of the extension of `path` can be written, whatever its depth.
    virtual bool writes(const std::string& path) const = 0;
    /// An extension of each type of picture that can be written, without its dot.
    virtual std::vector<std::string> written_extensions() const = 0;
    /// The depth that a picture of the extension of `name`, written with this depth, then has;
    /// tried out on `path`. `file` as above.
    virtual Depth written_depth(const std::string& path, const std::string& name,
                                const std::string& file, Depth depth) const = 0;
    /// Memory for samples from where write() takes them without a copy.
    virtual SampleBuffer memory(std::size_t bytes) const = 0;
    /// Writes a picture of the extension of `name` to `path`. `file` as above; the answer as of
    /// write_samples().
    virtual std::vector<std::string> write(const std::string& path, const std::string& name,
                                           const std::string& file, const SampleImage& image,
                                           const ImageWriteOptions& options) const = 0;
    /// What has been kept of a picture that read() read, as bytes; empty: nothing but its base.
    virtual std::string packed(const PictureSource& source) const = 0;
    /// From bytes of packed(). Throws Error for others.
    virtual std::shared_ptr<const PictureSource> unpacked(std::string_view bytes) const = 0;
};

/// Loads OpenImageIO on the first call. Throws Error when it is not installed.
const Oiio& oiio();

} // namespace lutlib::io
