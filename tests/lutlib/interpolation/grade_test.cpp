#include "lutlib/interpolation/grade.h"

#include "lutlib/interpolation/sample.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <ostream>
#include <random>
#include <stdexcept>

namespace lutlib {
namespace {

constexpr Domain odd_domain{{-1, 0, 0.25F}, {3, 0.7F, 2}};

struct Shape {
    int size;        // of the cube; 0: none
    int shaper_size; // 0: none
    Domain domain;
    float range = 1;      // how far the nodes reach
    bool is_held = false; // to 0..1, as no node is else

    friend void PrintTo(const Shape& s, std::ostream* out) {
        *out << s.size << (s.is_held ? " held" : "") << " nodes up to " << s.range
             << ", a 1D table of " << s.shaper_size << (s.domain.is_unit() ? "" : ", odd domain");
    }
};

// Channels mix and bend; neighbouring nodes differ as a look's do.
Lut look_of(const Shape& shape) {
    Lut lut;
    if (shape.size > 0) {
        lut.cube = identity_cube(shape.size);
        for (Rgb& c : lut.cube->nodes) {
            const float y = 0.2F * c.r + 0.7F * c.g + 0.1F * c.b;
            for (std::size_t k = 0; k < 3; ++k) {
                c[k] = shape.range * (y + 1.2F * (c[k] - y) + 0.05F * std::sin(5 * c[(k + 1) % 3]));
                c[k] = shape.is_held ? std::clamp(c[k], 0.0F, 1.0F) : c[k];
            }
        }
        lut.cube->domain = shape.shaper_size > 0 ? Domain{} : shape.domain;
    }
    if (shape.shaper_size > 0) {
        lut.shaper = Lut1D{shape.domain, {}};
        for (int i = 0; i < shape.shaper_size; ++i) {
            const float t = static_cast<float>(i) / static_cast<float>(shape.shaper_size - 1);
            lut.shaper->entries.push_back({std::sqrt(t), t * t, 1 - t});
        }
    }
    return lut;
}

// A picture in memory of its own, with bytes before, between and after that must stay.
struct Layout {
    const char* name;
    std::size_t channels;
    bool planar;
    std::size_t gap;     // samples between pixels
    std::size_t row_gap; // bytes between rows, a multiple of four
    bool upside_down = false;
};
constexpr Layout packed_rgba{"packed RGBA", 4, false, 0, 0};
constexpr Layout layouts[] = {packed_rgba,
                              {"packed RGB", 3, false, 0, 0},
                              {"RGBA rows apart", 4, false, 0, 12},
                              {"RGB pixels apart", 3, false, 2, 4},
                              {"planar RGBA", 4, true, 0, 8},
                              {"planar RGB, samples apart", 3, true, 1, 0},
                              {"RGBA upside down", 4, false, 0, 4, true}};

class Picture {
  public:
    Picture(const Layout& layout, Element element, std::size_t width, std::size_t height) {
        const std::size_t bytes = info_of(element).bytes;
        const std::size_t pixel = bytes * ((layout.planar ? 1 : layout.channels) + layout.gap);
        const std::size_t row = (pixel * width + layout.row_gap + 3) / 4 * 4;
        const std::size_t plane = row * height;
        constexpr std::size_t around = 64;
        memory_.assign(2 * around + plane * (layout.planar ? layout.channels : 1), std::byte{0xA5});
        view_.element = element;
        view_.width = width;
        view_.height = height;
        view_.pixel_stride = static_cast<std::ptrdiff_t>(pixel);
        view_.row_stride = static_cast<std::ptrdiff_t>(row) * (layout.upside_down ? -1 : 1);
        for (std::size_t c = 0; c < layout.channels; ++c) {
            view_.channel[c] = memory_.data() + around + c * (layout.planar ? plane : bytes) +
                               (layout.upside_down && height > 0 ? row * (height - 1) : 0);
        }
    }
    Picture(const Picture&) = delete;
    void copy_samples_of(const Picture& other) { memory_ = other.memory_; }

    const PictureView& view() const { return view_; }
    const std::vector<std::byte>& memory() const { return memory_; }

    std::size_t channels() const { return view_.has_alpha() ? 4 : 3; }
    template <class F>
    void for_each_sample(F f) const {
        for (std::size_t y = 0; y < view_.height; ++y) {
            for (std::size_t x = 0; x < view_.width; ++x) {
                for (std::size_t c = 0; c < channels(); ++c) {
                    f(c, x, y);
                }
            }
        }
    }

  private:
    std::vector<std::byte> memory_;
    PictureView view_;
};

// In and around the domain; of floats, NaN and infinities in every channel among them. Codes are
// any.
void fill(Picture& picture, const Domain& domain) {
    std::mt19937 random(7);
    const auto place = [&] { return -0.1 + 1.2 / 4294967296 * static_cast<double>(random()); };
    constexpr float inf = std::numeric_limits<float>::infinity();
    constexpr float specials[] = {
        std::numeric_limits<float>::quiet_NaN(),  inf,  -inf,  0,   -0.0F, 1,
        std::numeric_limits<float>::denorm_min(), 6e4F, -6e4F, 0.5F};
    const Element element = picture.view().element;
    std::size_t n = 0;
    picture.for_each_sample([&](std::size_t c, std::size_t x, std::size_t y) {
        std::byte* const at = picture.view().at(c, x, y);
        const ElementInfo& info = info_of(element);
        if (info.maximum > 0) {
            const auto code =
                static_cast<std::uint16_t>(random() % (static_cast<unsigned>(info.maximum) + 1));
            const auto low = static_cast<std::uint8_t>(code);
            std::memcpy(at, info.bytes == 1 ? static_cast<const void*>(&low) : &code, info.bytes);
            return;
        }
        const std::size_t k = std::min<std::size_t>(c, 2);
        double value = std::lerp(static_cast<double>(domain.min[k]),
                                 static_cast<double>(domain.max[k]), place());
        if (++n % 11 == 0) {
            value = static_cast<double>(specials[n / 11 % std::size(specials)]);
        }
        if (element == Element::float32) {
            const auto v = static_cast<float>(value);
            std::memcpy(at, &v, sizeof v);
        } else if (std::isfinite(value)) {
            store_sample(element, value, at);
        } else {
            const std::uint16_t bits = std::isnan(value) ? 0x7E01 : value > 0 ? 0x7C00 : 0xFC00;
            std::memcpy(at, &bits, sizeof bits);
        }
    });
}

TEST(Grade, counts_the_pixels_outside_a_domain_of_every_element_wherever_they_lie) {
    for (const Domain& domain : {Domain{}, odd_domain, Domain{{-9e4F, 0, 0}, {9e4F, 1, 70000}}}) {
        for (const ElementInfo& info : elements()) {
            for (const Layout& layout : layouts) {
                Picture picture(layout, info.element, 53, 29);
                fill(picture, domain);
                const PictureView& view = picture.view();
                std::size_t wanted = 0;
                for (std::size_t y = 0; y < view.height; ++y) {
                    for (std::size_t x = 0; x < view.width; ++x) {
                        bool is_inside = true;
                        for (std::size_t c = 0; c < 3; ++c) {
                            const double value = sample_value(info.element, view.at(c, x, y));
                            is_inside = is_inside && value >= static_cast<double>(domain.min[c]) &&
                                        value <= static_cast<double>(domain.max[c]);
                        }
                        wanted += !is_inside;
                    }
                }
                EXPECT_EQ(pixels_outside(domain, view), wanted) << info.name << ' ' << layout.name;
            }
        }
    }
}

// The double oracle's answers to a picture's colours.
struct Exact {
    const Lut& lut;
    Interpolation how;
    const Picture& in;

    double operator()(std::size_t c, std::size_t x, std::size_t y) const {
        RgbD color;
        for (std::size_t k = 0; k < 3; ++k) {
            color[k] = sample_value(in.view().element, in.view().at(k, x, y));
        }
        return evaluate_exact(lut, color, how)[c];
    }
    // A cube passes on the roundings of the table before it.
    double bound() const { return lut.shaper && lut.cube ? 3e-7 : 2e-7; }
};

// Their order, so that halves next to each other differ by 1.
int rank_of_half(const std::byte* at) {
    std::int16_t bits;
    std::memcpy(&bits, at, sizeof bits);
    return bits < 0 ? -(bits & 0x7FFF) : bits;
}

// Floats: a difference from `exact` of its bound at most, of values above 1 times the value. Else:
// one code or half, in fewer than 0.5 % of samples (of few samples, in one).
void expect_close(const Picture& got, const Picture& wanted, const Exact& exact) {
    const Element element = got.view().element;
    std::size_t off = 0, all = 0;
    double largest = 0;
    got.for_each_sample([&](std::size_t c, std::size_t x, std::size_t y) {
        const std::byte* const a = got.view().at(c, x, y);
        const std::byte* const b = wanted.view().at(c, x, y);
        const std::size_t bytes = info_of(element).bytes;
        if (c == 3) {
            EXPECT_EQ(std::memcmp(a, b, bytes), 0) << "alpha of " << x << " " << y;
            return;
        }
        ++all;
        if (element != Element::float32 && std::memcmp(a, b, bytes) == 0) {
            return;
        }
        ++off;
        const double difference =
            element == Element::float32 ? std::abs(sample_value(element, a) - exact(c, x, y)) /
                                              std::max(1.0, std::abs(exact(c, x, y)))
            : element == Element::half
                ? std::abs(rank_of_half(a) - rank_of_half(b))
                : std::round(std::abs(sample_value(element, a) - sample_value(element, b)) *
                             info_of(element).maximum);
        largest = std::isnan(difference) ? 1e9 : std::max(largest, difference);
    });
    EXPECT_LE(largest, element == Element::float32 ? exact.bound() : 1);
    if (element != Element::float32) {
        EXPECT_LE(static_cast<double>(off), std::max(1.0, 0.005 * static_cast<double>(all)));
    }
}

template <class F>
void on_every_processor(F f) {
    for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1) {
        hwy::SetSupportedTargetsForTest(left & -left);
        SCOPED_TRACE(hwy::TargetName(left & -left));
        f();
    }
    hwy::SetSupportedTargetsForTest(0);
}

class GradeEveryElement : public testing::TestWithParam<ElementInfo> {};
INSTANTIATE_TEST_SUITE_P(Elements, GradeEveryElement,
                         testing::ValuesIn(elements().begin(), elements().end()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(GradeEveryElement, is_as_the_plain_twin_on_every_processor) {
    const Shape shapes[] = {{2, 0, {}},           {17, 0, odd_domain},   {33, 0, {}},
                            {33, 0, {}, 3},       {33, 0, {}, 1, true},  {65, 0, {}, 1, true},
                            {66, 0, {}},          {17, 256, odd_domain}, {0, 64, {}},
                            {0, 4096, odd_domain}};
    for (const Shape& shape : shapes) {
        SCOPED_TRACE(testing::PrintToString(shape));
        const Lut lut = look_of(shape);
        Picture in(packed_rgba, GetParam().element, 1023, 5);
        fill(in, shape.domain);
        for (const InterpolationInfo& how : interpolations()) {
            if (how.kind == Interpolation::nearest && GetParam().maximum == 0) {
                continue; // floats that lie between two nodes: below
            }
            SCOPED_TRACE(std::string(how.name));
            Picture wanted(packed_rgba, GetParam().element, 1023, 5);
            grade_plainly(lut, how.kind, in.view(), wanted.view());
            const Grading look(lut, how.kind);
            on_every_processor([&] {
                Picture got(packed_rgba, GetParam().element, 1023, 5);
                grade(look, in.view(), got.view(), 1);
                expect_close(got, wanted, Exact{lut, how.kind, in});
            });
        }
    }
}

TEST_P(GradeEveryElement, takes_any_layout_and_touches_nothing_else) {
    const Lut lut = look_of({17, 0, {}});
    const Grading look(lut);
    for (const Layout& layout : layouts) {
        SCOPED_TRACE(layout.name);
        for (const std::size_t width : {1U, 7U, 300U}) {
            Picture in(layout, GetParam().element, width, 3),
                packed(packed_rgba, GetParam().element, width, 3),
                wanted(packed_rgba, GetParam().element, width, 3),
                got(layout, GetParam().element, width, 3);
            fill(in, {});
            grade(Grading(Lut{}), in.view(), packed.view(), 1);
            grade(look, packed.view(), wanted.view(), 1);
            grade(look, in.view(), got.view(), 1);
            // What belongs to no sample is as it was.
            Picture expected(layout, GetParam().element, width, 3);
            grade(Grading(Lut{}), wanted.view(), expected.view(), 1);
            EXPECT_EQ(got.memory(), expected.memory());
            Picture in_place(layout, GetParam().element, width, 3);
            in_place.copy_samples_of(in);
            grade(look, in_place.view(), in_place.view(), 1);
            EXPECT_EQ(in_place.memory(), got.memory());
        }
    }
}

TEST_P(GradeEveryElement, gives_the_same_bytes_whatever_the_number_of_threads) {
    // More than the caches keep, written past them; in place through them.
    const Element element = GetParam().element;
    constexpr std::size_t width = 1031, height = 1031;
    for (const int size : {17, 0}) {
        const Grading look(look_of({size, size == 0 ? 64 : 0, {}}));
        Picture in(packed_rgba, element, width, height), once(packed_rgba, element, width, height);
        fill(in, {});
        grade(look, in.view(), once.view(), 1);
        for (const int threads : {0, 2, 7}) {
            Picture again(packed_rgba, element, width, height);
            grade(look, in.view(), again.view(), threads);
            EXPECT_EQ(again.memory() == once.memory(), true) << threads << " threads";
        }
        grade(look, in.view(), in.view(), 0);
        EXPECT_EQ(in.memory() == once.memory(), true) << "in place";
    }
}

TEST_P(GradeEveryElement, looks_up_runs_of_one_color_as_any_others) {
    const Lut lut = look_of({33, 0, {}});
    const Element element = GetParam().element;
    Picture in(packed_rgba, element, 1023, 5), wanted(packed_rgba, element, 1023, 5);
    fill(in, {});
    // From the middle of the first row on, two rows of one colour, then one pixel that differs.
    const std::size_t bytes = 4 * info_of(element).bytes;
    for (std::size_t i = 500; i < 2500; ++i) {
        std::memcpy(in.view().at(0, 0, 0) + i * bytes, in.view().at(0, 3, 0), bytes);
    }
    std::memcpy(in.view().at(0, 0, 0) + 2000 * bytes, in.view().at(0, 4, 0), bytes);
    grade_plainly(lut, Interpolation::tetrahedral, in.view(), wanted.view());
    on_every_processor([&] {
        Picture got(packed_rgba, element, 1023, 5);
        grade(Grading(lut), in.view(), got.view(), 1);
        expect_close(got, wanted, Exact{lut, Interpolation::tetrahedral, in});
        Picture in_place(packed_rgba, element, 1023, 5);
        in_place.copy_samples_of(in);
        grade(Grading(lut), in_place.view(), in_place.view(), 1);
        EXPECT_EQ(in_place.memory() == got.memory(), true) << "in place";
    });
}

TEST_P(GradeEveryElement, goes_into_every_other_element) {
    const Lut lut = look_of({33, 0, {}});
    Picture in(packed_rgba, GetParam().element, 1001, 3);
    fill(in, {});
    for (const ElementInfo& to : elements()) {
        SCOPED_TRACE(std::string(to.name));
        Picture wanted(packed_rgba, to.element, 1001, 3), got(packed_rgba, to.element, 1001, 3);
        grade_plainly(lut, Interpolation::tetrahedral, in.view(), wanted.view());
        grade(Grading(lut), in.view(), got.view(), 1);
        expect_close(got, wanted, Exact{lut, Interpolation::tetrahedral, in});
    }
}

TEST(Grade, reads_the_nearest_node_of_floats_where_one_is_nearer) {
    const Shape shape{17, 0, odd_domain};
    const Lut lut = look_of(shape);
    Picture in(packed_rgba, Element::float32, 513, 3);
    fill(in, shape.domain);
    Picture wanted(packed_rgba, Element::float32, 513, 3);
    grade_plainly(lut, Interpolation::nearest, in.view(), wanted.view());
    on_every_processor([&] {
        Picture got(packed_rgba, Element::float32, 513, 3);
        grade(Grading(lut, Interpolation::nearest), in.view(), got.view(), 1);
        expect_close(got, wanted, Exact{lut, Interpolation::nearest, in});
    });
}

TEST(Grade, leaves_the_alpha_alone_that_its_input_lacks) {
    const std::array<std::uint8_t, 3> in{10, 20, 30};
    std::array<std::uint8_t, 4> out{1, 2, 3, 77};
    grade(Grading(look_of({17, 0, {}})), interleaved(in.data(), Element::uint8, 3, 1, 1),
          interleaved(out.data(), Element::uint8, 4, 1, 1));
    EXPECT_EQ(out[3], 77);
    EXPECT_NE(out[0], 1);
}

TEST(Grade, refuses_pictures_of_different_sizes) {
    std::array<float, 8> memory{};
    const auto view = interleaved(memory.data(), Element::float32, 4, 2, 1);
    EXPECT_THROW(grade(Grading(Lut{}), view, interleaved(memory.data(), Element::float32, 4, 1, 1)),
                 std::invalid_argument);
}

} // namespace
} // namespace lutlib
