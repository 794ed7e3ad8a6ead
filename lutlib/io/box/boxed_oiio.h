// OpenImageIO, whose every picture is read and written by processes of their own, which are kept
// for the next ones.
#pragma once

#include "lutlib/io/box/file_copies.h"
#include "lutlib/io/box/foreign_cache.h"
#include "lutlib/io/box/reader.h"
#include "lutlib/io/box/shared_pool.h"
#include "lutlib/io/oiio.h"

#include <mutex>

namespace lutlib::io::box {

class BoxedOiio final : public Oiio {
  public:
    explicit BoxedOiio(const Foreign& library = openimageio) : library_(library) {}

    /// What holds its readers.
    Held held() const;

    std::string version() const override;
    Size size(const std::string& path) const override;
    SampleImage read(const std::string& path, const std::string& file,
                     const ImageReadOptions& options = {},
                     const Allocate& allocate = {}) const override;
    bool writes(const std::string& path) const override;
    std::vector<std::string> written_extensions() const override;
    Depth written_depth(const std::string& path, const std::string& name, const std::string& file,
                        Depth depth) const override;
    SampleBuffer memory(std::size_t bytes) const override;
    std::vector<std::string> write(const std::string& path, const std::string& name,
                                   const std::string& file, const SampleImage& image,
                                   const ImageWriteOptions& options) const override;
    std::string packed(const PictureSource& source) const override;
    std::shared_ptr<const PictureSource> unpacked(std::string_view bytes) const override;

  private:
    struct Asked {
        std::unique_ptr<Reader> reader;
        ForeignCache pictures; // of its answers
    };

    // What `take` makes of the answer, before its reader is asked anew.
    template <class Take>
    auto ask(const Outgoing& question, const About& about, const Take& take) const;

    const Foreign& library_;
    mutable std::mutex mutex_;
    mutable std::vector<Asked> idle_;
    SharedPool pool_;
    FileCopies copies_;
};

} // namespace lutlib::io::box
