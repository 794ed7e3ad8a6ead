// Is this picture the lattice that fitting this look to that engine's lookup gives?
#pragma once

#include "lutlib/bake/bake.h"
#include "lutlib/fit/acceptance.h"
#include "lutlib/verify/diagnose.h"

#include <string>
#include <vector>

namespace lutlib {

/// A fitted lattice's texels need not be the look's values, so they are held against a fit made
/// anew. Where texels differ from it, the engine's lookup must be about as good as that fit's:
/// around each of them by the largest error, and over all colours by the mean.
struct FittedCheck {
    Difference result;        ///< measure_lookup() of the picture
    Difference refit;         ///< of the fit made anew
    Difference point_sampled; ///< of the look's own samples
    std::size_t texels = 0;
    std::size_t moved = 0; ///< texels further from the new fit than rounding explains
    std::vector<std::string> faults;

    bool right() const { return faults.empty(); }
};

/// The picture's dimensions must be those of the engine's layout for `size`. Takes as long as
/// bake_fitted() does.
FittedCheck check_fitted(const CodeImage& picture, const Engine& engine, int size,
                         const Transform& look, const FitView& view = {});

} // namespace lutlib
