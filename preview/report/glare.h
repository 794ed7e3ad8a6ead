// The bloom that stands for an eye's glare beside the glare that was measured of eyes.
#pragma once

#include <vector>

namespace preview::report {

/// How much of a point's light lies within a circle about it.
struct EncircledLight {
    double radius = 0; ///< texels of a picture of bloom_nominal_height lines
    double model = 0;  ///< of the sum of Gaussians, with what is left where it was
    double measured = 0;
};

/// Spencer, Shirley, Zimmerman and Greenberg, "Physically-Based Glare Effects for Digital Images",
/// SIGGRAPH 1995: the photopic point spread function of an eye, 0.384 f0 + 0.478 f1 + 0.138 f2.
struct GlareModel {
    double field_of_view = 0; ///< degrees of the picture's height
    std::vector<EncircledLight> curve;
    double largest = 0, at_radius = 0; ///< difference of both, and where
    /// The height's field of view at which the largest difference is smallest, and that difference.
    double best_field_of_view = 0, best_largest = 0;
};

/// For a picture that shows so many degrees from its lower to its upper border.
GlareModel glare_model(double field_of_view);

/// Share of the light of Spencer's function within `degrees` of its middle, 0..1.
double spencer_encircled(double degrees);

} // namespace preview::report
