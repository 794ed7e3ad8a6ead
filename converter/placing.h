// What a look is made for and where it is put, on the command line.
#pragma once

#include "converter/verb.h"
#include "lutlib/recipe/placement.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace converter {

/// --look-input, --look-output, --adaptation and --no-convert.
class PlacingOptions {
  public:
    void declare(Verb& verb);
    /// What was named. Throws UsageError.
    lutlib::LookEncodings look() const;
    bool convert() const { return !no_convert_; }
    /// Any of them.
    bool given() const;
    /// Throws UsageError.
    const lutlib::Adaptation& adaptation() const;

  private:
    std::string input_, output_, adaptation_;
    bool no_convert_ = false;
};

/// {"look": {"input", "output"}, "given", "wanted", "before", "after", "mismatched"}: names, null
/// where they are not known or nothing is converted.
nlohmann::ordered_json to_json(const lutlib::LookPlace& place);

} // namespace converter
