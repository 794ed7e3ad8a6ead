// Any bytes as a picture in a PNG: whole, in part, or refused with an Error; a stream of such files
// is cut into them or refused.
#include "lutlib/error.h"
#include "lutlib/io/png.h"
#include "lutlib/io/png_stream.h"

#include <cstdint>
#include <cstdlib>

namespace {

void hold(bool is_true) {
    if (!is_true) {
        std::abort();
    }
}

void read(std::string_view bytes, bool partial) {
    try {
        const lutlib::io::PngPicture picture =
            lutlib::io::read_png_picture(bytes, "fuzz.png", partial);
        const auto pixels =
            static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
        const auto bytes_a_pixel = static_cast<std::size_t>(picture.channels * picture.bits / 8);
        hold(picture.samples.size() >= pixels * bytes_a_pixel);
        hold(picture.missing_rows >= 0 && picture.missing_rows < picture.height);
        hold(partial || picture.missing_rows == 0);
        for (const lutlib::io::PngChunk& chunk : lutlib::io::kept_chunks(bytes)) {
            hold(chunk.bytes.size() >= 12 && chunk.name().size() == 4);
        }
    } catch (const lutlib::Error&) {
    }
}

class Bytes final : public lutlib::ByteSource {
  public:
    explicit Bytes(std::string_view bytes) : bytes_(bytes) {}
    std::size_t read(char* to, std::size_t most) override {
        const std::size_t some = bytes_.copy(to, most);
        bytes_.remove_prefix(some);
        return some;
    }
    std::size_t remaining() const override { return bytes_.size(); }

  private:
    std::string_view bytes_;
};

void cut(std::string_view bytes) {
    const std::string name = "fuzz";
    Bytes source(bytes);
    lutlib::io::PngStream stream(source, name);
    std::size_t taken = 0;
    try {
        while (const std::optional<std::string> file = stream.next()) {
            hold(bytes.substr(taken, file->size()) == *file);
            taken += file->size();
        }
        hold(taken == bytes.size());
    } catch (const lutlib::Error&) {
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    read(bytes, false);
    read(bytes, true);
    cut(bytes);
    return 0;
}
