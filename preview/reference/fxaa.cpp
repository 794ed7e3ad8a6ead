#include "preview/reference/fxaa.h"

#include <array>

namespace preview::reference {

namespace {

using lutlib::RgbD;

constexpr double least_contrast = 0.0312, relative_contrast = 0.125, softness = 0.75;
constexpr std::array<int, 11> steps{1, 1, 1, 1, 1, 2, 2, 2, 2, 4, 8};

struct Offset {
    int x, y;
    Offset operator-() const { return {-x, -y}; }
};

class Fxaa {
  public:
    explicit Fxaa(const Image& picture) : picture_(picture) {}

    RgbD texel(int x, int y) const {
        const auto near = [&](int dx, int dy) { return luma(x + dx, y + dy); };
        const RgbD own = picture_.at(x, y);
        const double m = near(0, 0), n = near(0, -1), s = near(0, 1), w = near(-1, 0),
                     e = near(1, 0);
        const double brightest = std::max({m, n, s, w, e});
        const double contrast = brightest - std::min({m, n, s, w, e});
        if (!(contrast >= std::max(least_contrast, relative_contrast * brightest))) {
            return own;
        }
        const double nw = near(-1, -1), ne = near(1, -1), sw = near(-1, 1), se = near(1, 1);
        const double mean = (2 * (n + s + w + e) + nw + ne + sw + se) / 12;
        const double apart = std::clamp(std::abs(mean - m) / contrast, 0.0, 1.0);
        const double smooth = apart * apart * (3 - 2 * apart);
        const double soft = smooth * smooth * softness;

        const bool horizontal =
            std::abs(nw - 2 * w + sw) + 2 * std::abs(n - 2 * m + s) + std::abs(ne - 2 * e + se) >=
            std::abs(nw - 2 * n + ne) + 2 * std::abs(w - 2 * m + e) + std::abs(sw - 2 * s + se);
        const Offset along = horizontal ? Offset{1, 0} : Offset{0, 1};
        const double before = horizontal ? n : w, after = horizontal ? s : e;
        const bool steeper_before = std::abs(before - m) >= std::abs(after - m);
        const Offset forward = horizontal ? Offset{0, 1} : Offset{1, 0};
        const Offset across = steeper_before ? -forward : forward;
        const double other = steeper_before ? before : after;
        const double edge = 0.5 * (other + m), gradient = std::abs(other - m);

        const End back = walk(x, y, across, -along, edge, gradient);
        const End forth = walk(x, y, across, along, edge, gradient);
        const End nearer = back.reach < forth.reach ? back : forth;
        double shift = 0;
        if ((m < edge) != (nearer.departure < 0)) {
            shift = 0.5 - static_cast<double>(nearer.reach) / (back.reach + forth.reach);
        }
        shift = std::max(shift, soft);
        return own * (1 - shift) + picture_.clamped(x + across.x, y + across.y) * shift;
    }

  private:
    struct End {
        int reach;
        double departure;
    };

    double luma(int x, int y) const {
        const RgbD c = picture_.clamped(x, y);
        return 0.299 * c.r + 0.587 * c.g + 0.114 * c.b;
    }

    End walk(int x, int y, Offset across, Offset along, double mean, double gradient) const {
        End end{0, 0};
        for (const int step : steps) {
            end.reach += step;
            const int u = x + end.reach * along.x, v = y + end.reach * along.y;
            end.departure = 0.5 * (luma(u, v) + luma(u + across.x, v + across.y)) - mean;
            if (std::abs(end.departure) >= 0.25 * gradient) {
                break;
            }
        }
        return end;
    }

    const Image& picture_;
};

} // namespace

Image fxaa(const Image& picture, double strength) {
    Image out(picture.width, picture.height);
    const Fxaa pass(picture);
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            out.at(x, y) = picture.at(x, y) * (1 - strength) + pass.texel(x, y) * strength;
        }
    }
    return out;
}

} // namespace preview::reference
