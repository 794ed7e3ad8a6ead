#include "lutlib/io/oiio/decode.h"

#include "lutlib/error.h"
#include "lutlib/io/oiio/depths.h"
#include "lutlib/limits.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace lutlib::io {
namespace {

// Some channels of a part, a pixel's one after the other.
struct Channels {
    const std::byte* first = nullptr;
    std::size_t stride = 0;           ///< bytes from a pixel to the next
    std::vector<std::size_t> offset;  ///< of each channel in a pixel
    std::vector<OIIO::TypeDesc> type; ///< of each channel
};

// Those that the picture has, to their places, as `image.depth`; grey three times.
void gather(const Channels& all, const PictureChannels& picture, int first, SampleImage& image) {
    const std::size_t size = bytes_of(image.depth), channels = image.samples_a_pixel();
    const OIIO::TypeDesc wanted = type_of(image.depth);
    for (std::size_t c = 0; c < channels; ++c) {
        const auto at = static_cast<std::size_t>(picture.at[c] - first);
        const std::byte* from = all.first + all.offset[at];
        std::byte* to = image.samples.data() + c * size;
        for (std::size_t i = 0; i < image.pixels(); ++i) {
            if (all.type[at] == wanted) {
                std::memcpy(to, from, size);
            } else {
                OIIO::convert_pixel_values(all.type[at], from, wanted, to, 1);
            }
            from += all.stride;
            to += channels * size;
        }
    }
}

} // namespace

Depth picture_depth(const OIIO::ImageSpec& spec, const PictureChannels& picture) {
    const Depth first = depth_of(spec.channelformat(picture.at[0]));
    const bool are_alike = std::all_of(picture.at.begin(), picture.at.end(), [&](int c) {
        return c < 0 || depth_of(spec.channelformat(c)) == first;
    });
    return are_alike ? first : Depth::float32;
}

bool has_others(const OIIO::ImageSpec& spec, const PictureChannels& picture) {
    return spec.nchannels > (picture.has_alpha() ? 4 : 3);
}

void decode(const PartReader& reader, const PictureChannels& picture, const std::string& file,
            SampleImage& image) {
    const auto [least, most] =
        std::minmax_element(picture.at.begin(), picture.at.end() - (image.alpha ? 0 : 1));
    const int first = *least, last = *most + 1;
    const auto count = static_cast<std::size_t>(last - first);
    const std::size_t size = bytes_of(image.depth);
    const bool is_in_place = picture.at[1] == first + 1 && picture.at[2] == first + 2 &&
                             (!image.alpha || picture.at[3] == first + 3);
    SampleBuffer apart = is_in_place ? SampleBuffer() : SampleBuffer(image.pixels() * count * size);
    std::byte* const to = is_in_place ? image.samples.data() : apart.data();
    image.missing_pixels =
        reader.read({static_cast<int>(picture.part), first, last, type_of(image.depth)}, to, file);
    if (!is_in_place) {
        Channels all{apart.data(), count * size, {}, {count, type_of(image.depth)}};
        for (std::size_t c = 0; c < count; ++c) {
            all.offset.push_back(c * size);
        }
        gather(all, picture, first, image);
    }
}

std::vector<KeptPart> kept_parts(const PartReader& reader, std::vector<OIIO::ImageSpec> specs,
                                 const PictureChannels& picture, const std::string& file,
                                 std::size_t& missing) {
    std::vector<KeptPart> out;
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < specs.size(); ++i) {
        KeptPart part{std::move(specs[i]), {}};
        if (i != picture.part || has_others(part.spec, picture)) {
            const std::size_t own = part.spec.image_bytes(true);
            check_size(part.spec, file);
            bytes += own;
            if (bytes > limits::max_file_bytes) {
                throw Error("its other channels and parts are larger than " +
                                std::to_string(limits::max_file_bytes >> 20) + " MB",
                            {file, 0, {}});
            }
            part.pixels.resize(own);
            const std::size_t lacks =
                reader.read({static_cast<int>(i), 0, part.spec.nchannels, OIIO::TypeDesc::UNKNOWN},
                            part.pixels.data(), file);
            missing = i == picture.part ? lacks : missing;
        }
        out.push_back(std::move(part));
    }
    return out;
}

void gather(const KeptPart& part, const PictureChannels& picture, SampleImage& image) {
    Channels all{part.pixels.data(), 0, {}, {}};
    for (int c = 0; c < part.spec.nchannels; ++c) {
        all.offset.push_back(all.stride);
        all.type.push_back(part.spec.channelformat(c));
        all.stride += all.type.back().size();
    }
    gather(all, picture, 0, image);
}

} // namespace lutlib::io
