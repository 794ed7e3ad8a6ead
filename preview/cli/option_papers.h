// lutpreview's man page and completions.
#pragma once

#include "terminal/papers.h"

namespace preview {

/// Of the program whose options are declared on `app`, which must outlive the answer.
terminal::Papers papers(const CLI::App& app);

} // namespace preview
