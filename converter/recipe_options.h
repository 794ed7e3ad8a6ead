// Recipes on the command line: operators as flags, in the order in which they are given.
#pragma once

#include "converter/verb.h"
#include "lutlib/format.h"
#include "lutlib/recipe/recipe.h"
#include "lutlib/resample/resample.h"

#include <cstdint>
#include <string>
#include <vector>

namespace converter {

/// One flag for each parameter of each operator, made from the descriptors.
class OperatorFlags {
  public:
    void declare(Verb& verb);

    /// The operators that the flags describe. A flag opens an operator, unless it belongs to the
    /// one before it and is not set there yet: `--contrast 1.2 --contrast-pivot .4` is one.
    /// `--opacity` belongs to the one before it, `--cdl-id` to the `--cdl-file` before it, which is
    /// an operator; what of the file that does not hold is added to `losses`. Throws Error.
    std::vector<lutlib::Operation> operations(std::vector<lutlib::Loss>& losses) const;

  private:
    struct Flag {
        enum class Kind : std::uint8_t { parameter, opacity, file, id };
        Kind kind = Kind::parameter;
        const lutlib::Op* op = nullptr; ///< of a parameter
        std::size_t parameter = 0;
    };
    const Verb* verb_ = nullptr;
    std::vector<Flag> flags_; ///< by their number in the verb
};

/// The lattice of the result: --size, --domain, --shaper, --shaper-size.
class SamplingOptions {
  public:
    /// `recipe`: the 1D table may follow the recipe's tones.
    void declare(Verb& verb, bool recipe);
    /// Overwrites what was given.
    void apply_to(lutlib::BakeSettings& settings) const;
    lutlib::Sampling sampling() const;
    /// The same of the lattice that these looks make. Throws UsageError for a size that a cube
    /// cannot have.
    lutlib::Sampling sampling_of(const std::vector<const lutlib::Lut*>& looks) const;
    /// How the entries of a composed or blended curve were chosen, where nobody said; empty of
    /// others.
    std::string choice_text(const lutlib::Lut& made) const;

  private:
    int size_ = 0, shaper_size_ = 0;
    std::vector<std::string> domain_;
    std::string shaper_;
    bool recipe_ = false;
};

/// --interpolation of the looks that are sampled, with every row of resampling_methods();
/// where it is not given, each look as it asks for.
class MethodOption {
  public:
    void declare(Verb& verb);
    const lutlib::ResamplingMethod& get() const;

  private:
    std::string name_;
};

/// What every verb that makes one LUT of others asks: where to, on which lattice, how the others
/// are read, and what the figures are in.
struct NewLutOptions {
    void declare(Verb& verb);
    /// Throws UsageError.
    lutlib::Encoding results() const;

    std::string output, encoding = "srgb";
    SamplingOptions sampling;
    MethodOption method;
    bool json = false;
};

/// lutlib::require_encoding() for a flag. Throws UsageError naming it.
lutlib::Encoding encoding_of(const std::string& name, const std::string& flag);
/// Help of an encoding's flag: what it is of, and what it takes.
std::string encoding_help(const std::string& what);

} // namespace converter
