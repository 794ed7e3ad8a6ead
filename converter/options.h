// Options and inputs that several verbs share.
#pragma once

#include "lutlib/bake/bake.h"
#include "lutlib/engine/engine.h"
#include "lutlib/format.h"
#include "lutlib/interpolation/interpolation.h"

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace converter {

/// --engine NAME, with every row of lutlib::engines() in its help.
class EngineOption {
  public:
    /// An empty default leaves the engine open.
    void declare(CLI::App& app, const std::string& default_name);
    bool given() const { return !name_.empty(); }
    const lutlib::Engine& get() const;

  private:
    std::string name_;
};

/// --interpolation NAME, with every row of lutlib::interpolations() in its help.
class InterpolationOption {
  public:
    void declare(CLI::App& app, const std::string& help);
    bool given() const { return given_; }
    lutlib::Interpolation get() const;

  private:
    std::string name_ = "tetrahedral";
    bool given_ = false;
};

/// Reads a LUT of any kind: .cube in both dialects, a LUT picture, and every format of
/// OpenColorIO, which is loaded only for those. What the reading loses goes to standard error.
lutlib::Lut read_lut(const std::string& path);

/// The same, and a recipe, baked as its own settings say; what that loses is measured.
lutlib::Lut read_look(const std::string& path);
/// The same with the losses handed back; an empty `format` is recognised.
lutlib::Reading read_look(const std::string& path, const lutlib::ReadOptions& options,
                          const std::string& format);
/// The same of bytes that have been read from `path`.
lutlib::Lut look_from(const std::string& bytes, const std::string& path);

/// A look to be sampled, without a table in between that the file does not have: a recipe,
/// evaluated exactly; a LUT read through an interpolation; or, of the formats that OpenColorIO
/// reads, what is no LUT or names another interpolation, in OpenColorIO's own evaluation.
struct Look {
    lutlib::Transform exact;
    lutlib::Domain domain;
    std::string title;
};
Look open_look(const std::string& path, lutlib::Interpolation how);

/// Writes a LUT in the format of the path's extension, a .cube to standard output. What the format
/// cannot hold goes to standard error.
void write_look(const lutlib::Lut& lut, const std::string& path);

} // namespace converter
