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
    /// The config's; empty where none was given.
    const std::string& file() const { return config_; }
    /// Throws UsageError for options that do not belong together.
    void check() const;
    /// Throws UsageError where other options say what is converted as well.
    void require_alone(bool others) const;
    /// The config's conversion, then the look; the look alone where no config was given.
    lutlib::Transform before(const lutlib::Transform& look) const;
    /// Loads OpenColorIO. Throws UsageError as check() does, Error for what the config lacks.
    lutlib::Transform transform() const;
    /// "config.ocio, from A to B"
    std::string text() const;

  private:
    std::string config_, from_, to_, display_, view_;
};

} // namespace converter
