// Many pictures through a look.
#pragma once

#include "converter/grade.h"
#include "converter/many.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace converter {

/// Of a run over many pictures, in the order of its routes.
struct GradedMany {
    std::vector<std::optional<Graded>> pictures; ///< unset: it failed
    std::vector<Failure> failures;
    std::size_t there = 0; ///< left out, as they are there
};

/// `output` is the template of the routes. Throws Error, UsageError for what concerns them all.
GradedMany grade_many(const Grading& grading, std::span<const lutlib::io::Route> routes,
                      const ManyOptions& options, const std::string& output);

/// What was made of them all, said once; each picture by itself as JSON.
void print_report(const GradedMany& graded, const Grading& grading,
                  std::span<const lutlib::io::Route> routes, const std::string& lut,
                  const std::string& output, bool json);

} // namespace converter
