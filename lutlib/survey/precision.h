// Measures what strain.h tells.
#pragma once

#include "lutlib/survey/lattices.h"
#include "lutlib/survey/strain.h"

#include <vector>

namespace lutlib {

std::vector<PrecisionRow> precision_of(const SurveyReference& reference);
std::vector<SensitivityRow> sensitivity_of(const SurveyReference& reference);
std::vector<NoiseRow> noise_of(const SurveyReference& reference);
std::vector<ChainRow> chains_of(const SurveyReference& reference);

inline Strain strain_of(const SurveyReference& reference) {
    return {precision_of(reference), sensitivity_of(reference), noise_of(reference),
            chains_of(reference)};
}

} // namespace lutlib
