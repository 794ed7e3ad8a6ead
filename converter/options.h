// Options that several verbs share.
#pragma once

#include "converter/verb.h"
#include "lutlib/engine/engine.h"
#include "lutlib/interpolation/interpolation.h"

#include <optional>
#include <string>
#include <vector>

namespace converter {

/// --engine NAME, with every row of lutlib::engines() in its help.
class EngineOption {
  public:
    /// An empty default leaves the engine open.
    void declare(Verb& verb, const std::string& default_name);
    bool given() const { return !name_.empty(); }
    const lutlib::Engine& get() const;
    /// Of several with commas between. Throws UsageError.
    std::vector<const lutlib::Engine*> all() const;

  private:
    std::string name_;
};

/// --interpolation NAME, with every row of lutlib::interpolations() in its help.
class InterpolationOption {
  public:
    void declare(Verb& verb, const std::string& help);
    /// Nothing where it was not given: as the look asks for. Throws UsageError.
    std::optional<lutlib::Interpolation> get() const;

  private:
    std::string name_;
};

/// The names of a list with commas between: "a,b".
std::vector<std::string> names_in_list(const std::string& list);

/// --reference-white, in cd/m2, for colour differences; at first BT.2408's.
void declare_reference_white(Verb& verb, double& nits);

} // namespace converter
