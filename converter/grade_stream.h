// Pictures from standard input through a look.
#pragma once

#include "converter/grade_many.h"
#include "lutlib/io/file.h"
#include "lutlib/io/output_names.h"

#include <string>
#include <vector>

namespace converter {

/// What came from standard input, and what became of it.
struct GradedStream {
    std::vector<lutlib::io::Route> routes; ///< "picture 3 of standard input", and where to
    GradedMany graded;
    bool is_one = false; ///< a picture of any type alone, not several PNG files
};

/// One picture, or PNG files one behind the other, each of which goes to `output`: one behind the
/// other to standard output, or into files, numbered from 1. jobs() at once; a bad one is said and
/// left out. Throws Error for one that is alone, and for a stream that breaks off once what came
/// before is written.
GradedStream grade_stream(const Grading& grading, const lutlib::io::OutputTemplate& output,
                          const ManyOptions& options);

} // namespace converter
