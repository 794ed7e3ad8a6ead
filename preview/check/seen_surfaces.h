// The surfaces that a g-buffer shows, as the lighting pass reads them.
#pragma once

#include "preview/check/read_by.h"
#include "preview/reference/lighting.h"
#include "preview/reference/occlusion.h"

namespace preview {

/// `normals`: null where nobody reads them.
reference::SeenSurfaces seen_surfaces(const TwinInput& in, const Observed& depth,
                                      const Observed* normals);

class GBufferRead {
  public:
    /// `has_detail`: it holds the surfaces themselves, else the numbers of their materials.
    GBufferRead(const TwinInput& in, const ReadBy& read, bool has_detail);

    bool shows(int x, int y) const { return seen_.shows(x, y); }
    glm::dvec3 direction(int x, int y) const; ///< from the eye, unit
    reference::LitSurface at(int x, int y) const;
    /// By how many metres floats may place it elsewhere.
    double rounding(int x, int y) const;

  private:
    void find_face(reference::LitSurface& surface, int x, int y) const;

    reference::SeenSurfaces seen_;
    const Observed* words_; ///< null: nobody reads them
    const Observed* albedo_ = nullptr;
    const Observed* emission_ = nullptr;
    const Observed* occlusion_ = nullptr;
    bool takes_light_; ///< else there is none, and surfaces only give their own
    bool has_detail_;
    std::vector<MaterialBlock> materials_;
};

} // namespace preview
