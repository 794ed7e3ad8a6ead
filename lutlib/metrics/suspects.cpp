#include "lutlib/metrics/suspects.h"

#include "lutlib/metrics/eye_form.h"
#include "lutlib/nodes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <numeric>
#include <span>

namespace lutlib {
namespace {

using Axes = UnionAxes;

struct Found {
    float bound;
    std::uint32_t at;
};

bool comes_before(const Found& x, const Found& y) {
    return x.bound != y.bound ? x.bound > y.bound : x.at < y.at;
}

// The largest of many.
class Largest {
  public:
    explicit Largest(std::size_t count) : count_(count) {}

    float floor() const { return floor_; }

    void add(float bound, std::size_t at) {
        if (bound > floor_) {
            found_.push_back({bound, static_cast<std::uint32_t>(at)});
            if (found_.size() >= 4 * count_) {
                cut();
            }
        }
    }
    void add(Largest other) {
        other.cut();
        found_.insert(found_.end(), other.found_.begin(), other.found_.end());
    }
    const std::vector<Found>& cut() {
        if (found_.size() > count_) {
            const auto last = found_.begin() + static_cast<std::ptrdiff_t>(count_);
            std::nth_element(found_.begin(), last, found_.end(), comes_before);
            // Of those that are equal to the last, the first of the grid stay.
            floor_ = std::max(floor_, std::nextafter(last->bound, 0.0F));
            found_.erase(last, found_.end());
        }
        return found_;
    }

  private:
    std::size_t count_;
    float floor_ = 0;
    std::vector<Found> found_;
};

// What the eye sees of an error around any colour of codes, by the nearest of a lattice of them.
class EyeForms {
  public:
    explicit EyeForms(const Viewing& viewing) {
        std::vector<RgbD> codes;
        for_each_node(side, [&](int r, int g, int b) {
            codes.push_back(RgbD{1.0 * r, 1.0 * g, 1.0 * b} * (1.0 / (side - 1)));
        });
        forms_ = eye_forms(codes, viewing);
        for (const EyeForm& form : forms_) {
            most_.push_back(form.most());
        }
    }

    std::size_t nearest(Rgb code) const {
        std::size_t out = 0;
        for (const float x : {code.b, code.g, code.r}) {
            const float held = x > 0 ? std::min(x, 1.0F) : 0.0F; // NaN too
            out = out * side + static_cast<std::size_t>(held * (side - 1) + 0.5F);
        }
        return out;
    }
    const EyeForm& form(std::size_t i) const { return forms_[i]; }
    /// The most that an error of 1 in every channel is seen as.
    float most(std::size_t i) const { return most_[i]; }

  private:
    static constexpr int side = 17;
    std::vector<EyeForm> forms_;
    std::vector<float> most_;
};

struct Four {
    Rgb mean, mixed; // as shares of the four
};

Four four(Rgb x00, Rgb x10, Rgb x01, Rgb x11) {
    const Rgb even = x00 + x11, odd = x10 + x01;
    return {(even + odd) * 0.25F, (even - odd) * 0.25F};
}

float largest(Rgb a) {
    return std::max({std::abs(a.r), std::abs(a.g), std::abs(a.b)});
}

struct Results {
    Largest code_cells, eye_cells, code_nodes, eye_nodes;

    explicit Results(const SuspectCount& count)
        : code_cells(count.cells), eye_cells(count.cells), code_nodes(count.nodes),
          eye_nodes(count.nodes) {}
    void add(Results other) {
        code_cells.add(std::move(other.code_cells));
        eye_cells.add(std::move(other.eye_cells));
        code_nodes.add(std::move(other.code_nodes));
        eye_nodes.add(std::move(other.eye_nodes));
    }
};

// One of a cell's faces, or its volume: what may lie in its middle.
struct Bounds {
    const EyeForms& forms;
    std::size_t around; // of the forms
    float code_floor, eye_floor;
    float code = 0, eye = 0;

    // The mean error, and how far each map may be from the mean of its corners.
    void take(Rgb mean, Rgb a, Rgb b) {
        Rgb sum;
        for (std::size_t c = 0; c < 3; ++c) {
            sum[c] = std::abs(mean[c]) + std::abs(a[c]) + std::abs(b[c]);
        }
        const float most = largest(sum);
        code = std::max(code, most);
        if (most * forms.most(around) > std::max(eye, eye_floor)) {
            const EyeForm& form = forms.form(around);
            eye = std::max(eye, form.length(mean) + form.length(a) + form.length(b));
        }
    }
};

class Scan {
  public:
    Scan(const Transform& a, const Transform& b, const Axes& axis, const EyeForms& forms)
        : a_(a), b_(b), axis_(axis), forms_(forms), width_(axis[0].size()),
          height_(axis[1].size()) {}

    /// The cells between the blue coordinates of `first` and `last`, and the colours from the first
    /// up to it.
    void operator()(std::size_t first, std::size_t last, Results& out) const {
        Plane low = plane(first), high;
        for (std::size_t k = first; k < last; ++k) {
            nodes(low, k, out);
            if (k + 1 < axis_[2].size()) {
                high = plane(k + 1);
                cells(low, high, k, out);
                std::swap(low, high);
            }
        }
    }

    Rgb color(std::size_t at) const {
        return {axis_[0][at % width_], axis_[1][at / width_ % height_],
                axis_[2][at / width_ / height_]};
    }
    std::array<std::size_t, 3> place(std::size_t at) const {
        return {at % width_, at / width_ % height_, at / width_ / height_};
    }

  private:
    // What the first map gives, and by how much the second gives less.
    struct Plane {
        std::vector<Rgb> a, error;
    };

    Plane plane(std::size_t k) const {
        constexpr std::size_t at_once = 512;
        Plane out{std::vector<Rgb>(width_ * height_), std::vector<Rgb>(width_ * height_)};
        std::array<RgbD, at_once> a, b;
        for (std::size_t first = 0; first < out.a.size(); first += at_once) {
            const std::size_t count = std::min(at_once, out.a.size() - first);
            for (std::size_t i = 0; i < count; ++i) {
                a[i] = b[i] = to_double(color((k * height_ * width_) + first + i));
            }
            a_(std::span(a).first(count));
            b_(std::span(b).first(count));
            for (std::size_t i = 0; i < count; ++i) {
                out.a[first + i] = to_float(a[i]);
                out.error[first + i] = to_float(a[i] - b[i]);
            }
        }
        return out;
    }

    void nodes(const Plane& plane, std::size_t k, Results& out) const {
        for (std::size_t i = 0; i < plane.a.size(); ++i) {
            const std::size_t at = k * width_ * height_ + i;
            const float code = largest(plane.error[i]);
            out.code_nodes.add(code, at);
            const std::size_t around = forms_.nearest(plane.a[i]);
            if (code * forms_.most(around) > out.eye_nodes.floor()) {
                out.eye_nodes.add(forms_.form(around).length(plane.error[i]), at);
            }
        }
    }

    void cells(const Plane& low, const Plane& high, std::size_t k, Results& out) const {
        for (std::size_t g = 0; g + 1 < height_; ++g) {
            for (std::size_t r = 0; r + 1 < width_; ++r) {
                const std::size_t i = g * width_ + r;
                const std::array<std::size_t, 4> corner{i, i + 1, i + width_, i + width_ + 1};
                std::array<Rgb, 8> a, error;
                for (std::size_t c = 0; c < 4; ++c) {
                    a[c] = low.a[corner[c]];
                    a[c + 4] = high.a[corner[c]];
                    error[c] = low.error[corner[c]];
                    error[c + 4] = high.error[corner[c]];
                }
                Bounds bounds{forms_, forms_.nearest((a[0] + a[7]) * 0.5F), out.code_cells.floor(),
                              out.eye_cells.floor()};
                // The faces through its first corner; of the last cells, the domain's own too.
                take_face(bounds, a, error, {0, 1, 2, 3});
                take_face(bounds, a, error, {0, 1, 4, 5});
                take_face(bounds, a, error, {0, 2, 4, 6});
                if (k + 2 == axis_[2].size()) {
                    take_face(bounds, a, error, {4, 5, 6, 7});
                }
                if (g + 2 == height_) {
                    take_face(bounds, a, error, {2, 3, 6, 7});
                }
                if (r + 2 == width_) {
                    take_face(bounds, a, error, {1, 3, 5, 7});
                }
                take_volume(bounds, a, error);
                const std::size_t at = k * width_ * height_ + i;
                out.code_cells.add(bounds.code, at);
                out.eye_cells.add(bounds.eye, at);
            }
        }
    }

    static void take_face(Bounds& bounds, const std::array<Rgb, 8>& a,
                          const std::array<Rgb, 8>& error, const std::array<std::size_t, 4>& at) {
        const Four of_a = four(a[at[0]], a[at[1]], a[at[2]], a[at[3]]);
        const Four of_error = four(error[at[0]], error[at[1]], error[at[2]], error[at[3]]);
        bounds.take(of_error.mean, of_a.mixed, of_a.mixed - of_error.mixed);
    }

    static void take_volume(Bounds& bounds, const std::array<Rgb, 8>& a,
                            const std::array<Rgb, 8>& error) {
        Rgb mean_a, mean_error;
        for (std::size_t c = 0; c < 8; ++c) {
            mean_a = mean_a + a[c] * 0.125F;
            mean_error = mean_error + error[c] * 0.125F;
        }
        for (std::size_t c = 0; c < 4; ++c) {
            const Rgb of_a = (a[c] + a[7 - c]) * 0.5F - mean_a;
            const Rgb of_error = (error[c] + error[7 - c]) * 0.5F - mean_error;
            bounds.take(mean_error, of_a, of_a - of_error);
        }
    }

    const Transform& a_;
    const Transform& b_;
    const Axes& axis_;
    const EyeForms& forms_;
    std::size_t width_, height_;
};

void append_middles(std::vector<Rgb>& out, const Axes& axis,
                    const std::array<std::size_t, 3>& cell) {
    for (int k = 0; k < 27; ++k) {
        const std::array<int, 3> step{k % 3, k / 3 % 3, k / 9};
        if (step[0] != 1 && step[1] != 1 && step[2] != 1) {
            continue;
        }
        Rgb color;
        for (std::size_t c = 0; c < 3; ++c) {
            const float low = axis[c][cell[c]], high = axis[c][cell[c] + 1];
            color[c] = step[c] == 0 ? low : step[c] == 2 ? high : std::midpoint(low, high);
        }
        out.push_back(color);
    }
}

std::vector<std::uint32_t> of_both(Largest& one, Largest& other) {
    std::vector<std::uint32_t> out;
    for (Largest* largest : {&one, &other}) {
        for (const Found& found : largest->cut()) {
            out.push_back(found.at);
        }
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

} // namespace

std::vector<Rgb> suspects(const Transform& a, const Transform& b, const Axes& axis,
                          const Viewing& viewing, const SuspectCount& count) {
    const EyeForms forms(viewing);
    const Scan scan(a, b, axis, forms);
    // Both maps are evaluated twice where two parts meet.
    constexpr std::size_t planes = 8;
    Results all(count);
    std::mutex mutex;
    tbb::parallel_for(std::size_t{0}, (axis[2].size() + planes - 1) / planes,
                      [&](std::size_t part) {
                          Results here(count);
                          scan(part * planes, std::min((part + 1) * planes, axis[2].size()), here);
                          const std::lock_guard lock(mutex);
                          all.add(std::move(here));
                      });
    std::vector<Rgb> out;
    for (const std::uint32_t at : of_both(all.code_nodes, all.eye_nodes)) {
        out.push_back(scan.color(at));
    }
    for (const std::uint32_t at : of_both(all.code_cells, all.eye_cells)) {
        append_middles(out, axis, scan.place(at));
    }
    return out;
}

} // namespace lutlib
