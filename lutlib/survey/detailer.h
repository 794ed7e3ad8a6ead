// Looks closer at one combination after the other.
#pragma once

#include "lutlib/survey/details.h"
#include "lutlib/survey/lattices.h"

#include <vector>

namespace lutlib {

/// Errors are dE2000.
class Detailer {
  public:
    explicit Detailer(const SurveyReference& reference);

    const DetailColors& colors() const { return colors_; }
    /// Of a combination that reads as `read` does. `errors` are those of many colours.
    Details of(const Transform& read, const Lut& lut, const Lookup& lookup, Rgb worst,
               std::vector<double> errors) const;

  private:
    std::vector<double> errors_of(const Transform& read, const std::vector<Rgb>& inputs) const;

    const SurveyReference& reference_;
    DetailColors colors_;
    std::vector<Rgb> all_; ///< of the planes and the patches
    std::vector<RgbD> expected_;
};

} // namespace lutlib
