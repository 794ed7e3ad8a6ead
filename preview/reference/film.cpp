#include "preview/reference/film.h"

#include "preview/reference/hash.h"

namespace preview::reference {

namespace {

/// The noise of one channel.
double noise_at(double x, double y, std::uint32_t frame, std::size_t channel) {
    const double left = std::floor(x), top = std::floor(y);
    double sum = 0, squares = 0;
    for (int dy = 0; dy < 2; ++dy) {
        for (int dx = 0; dx < 2; ++dx) {
            const double weight = (1 - std::abs(x - left - dx)) * (1 - std::abs(y - top - dy));
            const Words words =
                pcg3d(static_cast<std::uint32_t>(static_cast<int>(left) + dx),
                      static_cast<std::uint32_t>(static_cast<int>(top) + dy), frame);
            sum += weight * triangular_of(words[channel]);
            squares += weight * weight;
        }
    }
    return sum / std::sqrt(squares / 6);
}

} // namespace

Image film_grain(const Image& picture, const Grain& grain) {
    Image out = picture;
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            const double luma = luma_of(picture.at(x, y));
            for (std::size_t c = 0; c < 3; ++c) {
                const double noise = noise_at((x + 0.5) / grain.cell, (y + 0.5) / grain.cell,
                                              grain.frame, grain.is_colored ? c : 0);
                out.at(x, y)[c] += grain.amplitude * 4 * luma * (1 - luma) * noise;
            }
            out.at(x, y) = saturated(out.at(x, y));
        }
    }
    return out;
}

Image chromatic_aberration(const Image& light, double corner) {
    const double middle_x = light.width / 2.0, middle_y = light.height / 2.0;
    const double half_diagonal = std::hypot(middle_x, middle_y);
    Image out = light;
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            const double dx = x + 0.5 - middle_x, dy = y + 0.5 - middle_y;
            const double share = std::hypot(dx, dy) / half_diagonal; // of the way to a corner
            const double stretch = corner / half_diagonal * share * share;
            out.at(x, y).r =
                light.sample(middle_x + dx * (1 + stretch), middle_y + dy * (1 + stretch)).r;
            out.at(x, y).b =
                light.sample(middle_x + dx * (1 - stretch), middle_y + dy * (1 - stretch)).b;
        }
    }
    return out;
}

Image sharpened(const Image& picture, double strength, int reach) {
    Image out = picture;
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                const double own = picture.at(x, y)[c];
                const std::array<double, 4> beside{
                    picture.clamped(x, y - reach)[c], picture.clamped(x, y + reach)[c],
                    picture.clamped(x - reach, y)[c], picture.clamped(x + reach, y)[c]};
                double least = own, most = own, sum = 0;
                for (const double value : beside) {
                    least = std::min(least, value);
                    most = std::max(most, value);
                    sum += value;
                }
                const double room = std::min(least, 1 - most) / std::max(most, 1e-4);
                const double weight = -0.2 * std::sqrt(std::clamp(room, 0.0, 1.0));
                const double sharp = std::clamp((own + weight * sum) / (1 + 4 * weight), 0.0, 1.0);
                out.at(x, y)[c] = own + strength * (sharp - own);
            }
        }
    }
    return out;
}

} // namespace preview::reference
