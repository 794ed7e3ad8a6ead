// A look by an implementation that is not ours, to bake from and to prove bakes against.
#pragma once

#include "lutlib/interpolation/interpolation.h"
#include "lutlib/io/ocio.h"
#include "lutlib/transform.h"

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace converter {

/// Whether it is OpenColorIO that reads these bytes, rather than lutlib. Throws Error when nothing
/// does.
bool is_opencolorios(const std::string& bytes, const std::string& path);

/// A file's bytes as OpenColorIO's own reader evaluates them, operators and curves included. A file
/// that names an interpolation for its cube is read so, whatever `how`. Throws Error.
lutlib::Transform in_opencolorio(const std::string& bytes, const std::string& path,
                                 lutlib::Interpolation how);

/// The look that a picture is held against, by OpenColorIO's parser wherever it can read the file,
/// else from our reading of it, with the reason. What OpenColorIO does not know is evaluated
/// exactly, in double, by lutlib: recipes, and nearest interpolation.
class Reference {
  public:
    /// Reads the file as every verb does, so that what no verb takes is no reference. Throws Error.
    explicit Reference(const std::string& path);

    lutlib::Transform oracle(lutlib::Interpolation how);
    /// Who answers, for reports.
    std::string name(lutlib::Interpolation how) const;

    /// Whether an interpolation has a part in it.
    bool is_table() const { return !recipe_; }

    /// Why OpenColorIO could not read the file itself; empty when it could, or was not asked yet.
    const std::string& refusal() const { return refusal_; }

  private:
    lutlib::Transform evaluator(lutlib::Interpolation how);

    std::string bytes_, path_, refusal_;
    std::shared_ptr<const lutlib::Lut> lut_;
    std::optional<lutlib::Transform> recipe_; ///< evaluated instead
    std::map<lutlib::Interpolation, lutlib::Transform> transforms_;
};

} // namespace converter
