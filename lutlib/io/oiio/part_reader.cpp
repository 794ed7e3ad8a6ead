#include "lutlib/io/oiio/part_reader.h"

#include "lutlib/io/oiio/depths.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

namespace lutlib::io {

namespace {

// Readers that give row by row what is there. The others decode all at once, and after a failure
// give rows that nobody has read.
struct RowReader {
    std::string_view type;
    bool finds_later; ///< each row by itself: behind a gap there may be more
};
constexpr std::array<RowReader, 7> row_readers{{{"openexr", true},
                                                {"tiff", true},
                                                {"bmp", true},
                                                {"dpx", true},
                                                {"jpeg", false},
                                                {"pnm", false},
                                                {"hdr", false}}};

} // namespace

// Of a file that ends early some readers tell so only here. WebP's complains whenever it goes back
// to the first frame, which it has decoded by then.
bool PartReader::is_clean() const {
    return !input_.has_error() || std::string_view(input_.format_name()) == "webp";
}

// Of strips that zlib has packed, read many at a time, TIFF's overlooks those that do not unpack.
bool PartReader::reads_all_at_once(int part) const {
    const OIIO::ImageSpec spec = input_.spec(part);
    return std::string_view(input_.format_name()) != "tiff" || spec.tile_width > 0 ||
           spec.get_string_attribute("compression") != "zip";
}

std::size_t PartReader::read(const Wanted& wanted, std::byte* to, const std::string& file) const {
    const OIIO::ImageSpec spec = input_.spec_dimensions(wanted.part);
    const bool at_once = reads_all_at_once(wanted.part);
    if (at_once ? input_.read_image(wanted.part, 0, wanted.first, wanted.last, wanted.type, to) &&
                      is_clean()
                : read_rows(wanted, spec, false, to) == 0) {
        return 0;
    }
    const std::string why = at_once ? input_.geterror() : "it is damaged";
    const std::size_t pixels = spec.image_pixels();
    const auto* const row =
        std::find_if(row_readers.begin(), row_readers.end(),
                     [&](const RowReader& r) { return r.type == input_.format_name(); });
    const bool has_rows = partial_ && row != row_readers.end();
    const std::size_t missing = has_rows ? read_rows(wanted, spec, row->finds_later, to) : pixels;
    if (missing == pixels) {
        fail("cannot read the pixels", why, path_, file);
    }
    return missing;
}

// Row by row, or by rows of tiles.
std::size_t PartReader::read_rows(const Wanted& wanted, const OIIO::ImageSpec& spec,
                                  bool finds_later, std::byte* to) const {
    const bool is_native = wanted.type == OIIO::TypeDesc::UNKNOWN;
    const auto channels = static_cast<std::size_t>(wanted.last - wanted.first);
    const std::size_t pixel_bytes = is_native ? spec.pixel_bytes(wanted.first, wanted.last, true)
                                              : channels * wanted.type.size();
    const auto width = static_cast<std::size_t>(spec.width);
    const int step = spec.tile_width > 0 ? spec.tile_height : 1;
    std::size_t missing = 0;
    bool has_ended = false;
    for (int y = 0; y < spec.height; y += step) {
        const int end = std::min(y + step, spec.height);
        const int top = spec.y + y, bottom = spec.y + end;
        const auto rows = static_cast<std::size_t>(end - y);
        const auto read = [&] {
            const bool is_read =
                spec.tile_width > 0
                    ? input_.read_tiles(wanted.part, 0, spec.x, spec.x + spec.width, top, bottom,
                                        spec.z, spec.z + 1, wanted.first, wanted.last, wanted.type,
                                        to)
                    : input_.read_scanlines(wanted.part, 0, top, bottom, spec.z, wanted.first,
                                            wanted.last, wanted.type, to);
            const bool is_whole = is_clean() && is_read;
            input_.geterror();
            return is_whole;
        };
        // OpenEXR's fails once more after it has failed.
        const bool is_read = !has_ended && (read() || (finds_later && read()));
        if (!is_read) {
            std::memset(to, 0, rows * width * pixel_bytes);
            missing += rows * width;
            has_ended = !finds_later;
        }
        to += rows * width * pixel_bytes;
    }
    return missing;
}

} // namespace lutlib::io
