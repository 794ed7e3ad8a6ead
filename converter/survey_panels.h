// The panels of a survey's page about one combination.
#pragma once

#include "lutlib/plot/page.h"
#include "lutlib/survey/survey.h"

namespace converter {

/// Of the recommended combination, and for scripts of every one.
plot::Panels survey_panels(const lutlib::Survey& survey);

} // namespace converter
