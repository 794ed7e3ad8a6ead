// The user's own OpenColorIO config on the command line.
#pragma once

#include "converter/verb.h"
#include "lutlib/transform.h"

#include <string>

namespace converter {

/// --ocio-config with --from and --to, or --display and --view.
class ConfigOptions {
  public:
    void declare(Verb& verb);
    bool given() const { return !config_.empty(); }
    /// Loads OpenColorIO. Throws UsageError for options that do not belong together, Error for
    /// what the config lacks.
    lutlib::Transform transform() const;
    /// "config.ocio, from A to B"
    std::string text() const;

  private:
    std::string config_, from_, to_, display_, view_;
};

} // namespace converter
