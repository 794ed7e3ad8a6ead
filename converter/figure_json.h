// The numbers of a figure.
#pragma once

#include "lutlib/plot/figure.h"

#include <nlohmann/json_fwd.hpp>

namespace converter {

/// {"title", "x", "y", "lines": [{"name", "points"}], "cells": [{"name", "columns", "rows",
/// "labels", "srgb"}], "dots": [{"name", "places", "srgb"}], "notes": [{"x", "y", "text"}]}, of
/// which what there is none of is left out. What is not finite is null; colours are sRGB codes to
/// six digits behind the point, not held to 0..1.
nlohmann::ordered_json to_json(const plot::Figure& figure);

} // namespace converter
