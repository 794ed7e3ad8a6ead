// Colour science in one include; each part says where its formulas come from.
#pragma once

#include "lutlib/color/difference.h" // IWYU pragma: export
#include "lutlib/color/matrix.h"     // IWYU pragma: export
#include "lutlib/color/primaries.h"  // IWYU pragma: export
#include "lutlib/color/transfer.h"   // IWYU pragma: export
