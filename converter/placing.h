// What a look is made for and where it is put, on the command line.
#pragma once

#include "converter/verb.h"
#include "lutlib/recipe/placement.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace converter {

/// --look-input and --look-output.
class LookEncodingOptions {
  public:
    void declare(Verb& verb);
    bool given() const { return !input_.empty() || !output_.empty(); }
    /// What was named. Throws UsageError.
    lutlib::LookEncodings look() const;

  private:
    std::string input_, output_;
};

/// The same, --adaptation and --no-convert.
class PlacingOptions {
  public:
    void declare(Verb& verb);
    /// What was named. Throws UsageError.
    lutlib::LookEncodings look() const { return look_.look(); }
    bool convert() const { return !no_convert_; }
    /// Any of them.
    bool given() const;
    /// Throws UsageError.
    const lutlib::Adaptation& adaptation() const;

  private:
    LookEncodingOptions look_;
    std::string adaptation_;
    bool no_convert_ = false;
};

/// {"look": {"input", "output"}, "given", "wanted", "before", "after", "mismatched"}: names, null
/// where they are not known or nothing is converted.
nlohmann::ordered_json to_json(const lutlib::LookPlace& place);

} // namespace converter
