#include "converter/grade_pixels.h"

#include "lutlib/resample/simplify.h"

#include <algorithm>
#include <mutex>

namespace converter {
namespace {

namespace io = lutlib::io;

// A hundredth of the step between two codes of 16 bits.
constexpr double not_to_be_seen = 1.5e-7;

bool is_within(const lutlib::Rgb& c) {
    return std::min({c.r, c.g, c.b}) >= 0 && std::max({c.r, c.g, c.b}) <= 1;
}

bool holds_codes(const lutlib::Domain& domain) {
    return std::max({domain.min.r, domain.min.g, domain.min.b}) <= 0 &&
           std::min({domain.max.r, domain.max.g, domain.max.b}) >= 1;
}

bool gives_codes(const lutlib::Lut& lut) {
    const std::vector<lutlib::Rgb>* const last = lut.cube     ? &lut.cube->nodes
                                                 : lut.shaper ? &lut.shaper->entries
                                                              : nullptr;
    return !last || std::all_of(last->begin(), last->end(), is_within);
}

lutlib::PictureView view_of(io::FloatImage& image) {
    return interleaved(image.rgba.data(), lutlib::Element::float32, 4,
                       static_cast<std::size_t>(image.width),
                       static_cast<std::size_t>(image.height));
}

lutlib::Element element_of(io::Depth depth) {
    switch (depth) {
    case io::Depth::uint8:
        return lutlib::Element::uint8;
    case io::Depth::uint16:
        return lutlib::Element::uint16;
    case io::Depth::half:
        return lutlib::Element::half;
    case io::Depth::float32:
        break;
    }
    return lutlib::Element::float32;
}

} // namespace

struct LookOfPixels::Tables {
    Tables(const lutlib::Lut& lut, lutlib::Interpolation how)
        : whole(lut, how), keeps_codes(holds_codes(lut.domain()) && gives_codes(lut)) {
        // What simplify() promises holds between nodes only where they are weighed.
        if (!lut.cube || how != lutlib::Interpolation::nearest) {
            const lutlib::Simplified simplified = simplify(lut, {not_to_be_seen});
            for (const lutlib::Omission& omission : simplified.omissions) {
                left_out.push_back(omission.words);
            }
            if (!left_out.empty()) {
                needed.emplace(simplified.lut, how);
            }
        }
    }

    lutlib::Grading whole;
    std::optional<lutlib::Grading> needed;
    std::vector<std::string> left_out;
    bool keeps_codes;
};

struct LookOfPixels::Lazy {
    explicit Lazy(const io::Look& of) : look(of) {}

    const io::Look& look;
    std::once_flag once;
    std::optional<Tables> tables;
};

LookOfPixels::LookOfPixels(const io::Look& look) : lazy_(std::make_shared<Lazy>(look)) {}

const LookOfPixels::Tables& LookOfPixels::tables() const {
    std::call_once(lazy_->once, [this] {
        lazy_->tables.emplace(*lazy_->look.table().lut, lazy_->look.interpolation());
    });
    return *lazy_->tables;
}

bool LookOfPixels::keeps(io::Depth depth) const {
    return lazy_->look.is_table() && (!io::info_of(depth).integer || tables().keeps_codes);
}

const lutlib::Grading& LookOfPixels::table(bool inside) const {
    const Tables& all = tables();
    return inside && all.needed ? *all.needed : all.whole;
}

std::vector<std::string> LookOfPixels::left_out() const {
    return lazy_->look.is_table() ? tables().left_out : std::vector<std::string>{};
}

lutlib::ConstPictureView view_of(const io::SampleImage& image) {
    return interleaved(image.samples.data(), element_of(image.depth), image.samples_a_pixel(),
                       static_cast<std::size_t>(image.width),
                       static_cast<std::size_t>(image.height));
}

void grade_samples(const LookOfPixels& look, bool inside, io::SampleImage& image,
                   io::SampleBuffer&& graded) {
    const lutlib::ConstPictureView in = view_of(image);
    const bool in_place = graded.size() == 0;
    void* const to = in_place ? image.samples.data() : graded.data();
    grade(look.table(inside), in,
          interleaved(to, in.element, image.samples_a_pixel(), in.width, in.height));
    if (!in_place) {
        image.samples = std::move(graded);
    }
}

void grade_floats(const LookOfPixels& look, bool inside, io::FloatImage& image) {
    grade(look.table(inside), view_of(image), view_of(image));
}

} // namespace converter
