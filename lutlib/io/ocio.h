// OpenColorIO as the independent oracle of lutlib's own evaluation, and as the reader and writer of
// the LUT formats that lutlib does not know itself. No OpenColorIO header here: the library is
// loaded on first use (module.h).
#pragma once

#include "lutlib/format.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/transform.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib::io {

/// How much OpenColorIO may rewrite a transform before it evaluates it.
enum class Optimization { none, lossless };

struct EvaluationOptions {
    /// Of cubes; OpenColorIO knows trilinear and tetrahedral. Curves are interpolated linearly.
    Interpolation interpolation = Interpolation::tetrahedral;
    Optimization optimization = Optimization::lossless;
};

/// What an OpenColorIO config is asked for: the way from one colour space to another, or to a
/// display as a view shows it.
struct ConfigConversion {
    std::string config;   ///< a .ocio file, or a name of OpenColorIO's own, such as ocio://default
    std::string from, to; ///< colour spaces, roles or aliases
    std::string display, view; ///< instead of `to`; an empty view: the display's default
};

/// The loaded library. Its transforms compute in float.
class Ocio {
  public:
    virtual ~Ocio() = default;
    virtual std::string version() const = 0;
    /// Lower case, without the dot: what OpenColorIO says it can read.
    virtual std::vector<std::string> readable_extensions() const = 0;

    /// Parses a file's bytes with OpenColorIO's own reader, chosen by `extension` first and then by
    /// content. `file` names it in errors. Throws Error.
    Transform parse(std::string_view bytes, const std::string& extension, const std::string& file,
                    const EvaluationOptions& options) const;
    /// The same of the file itself, which OpenColorIO opens at the user's own path. Nothing where
    /// it would not find it there: standard input, and a path with "$" or "%", which it expands as
    /// variables. Throws Error.
    std::optional<Transform> open(const std::string& path, const EvaluationOptions& options) const;
    /// Parses a file into a look: exactly where it is an optional shaper and cube with domains,
    /// else sampled, with the measured error as a loss. Throws Error.
    Reading read(std::string_view bytes, const std::string& extension, const std::string& file,
                 const ReadOptions& options) const;

    /// A look as OpenColorIO's own matrices, curves and cubes. Throws Error.
    virtual Transform from_lut(const Lut& lut, const EvaluationOptions& options) const = 0;

    /// What the user's config does. Throws Error.
    virtual Transform from_config(const ConfigConversion& conversion) const = 0;

    /// The bytes of a file in one of OpenColorIO's own writers' formats, by OpenColorIO's name.
    virtual std::string write(const Lut& lut, const std::string& ocio_name,
                              const WriteOptions& options) const = 0;

    /// parse() and read() of a file that lies at `path`, where nothing in it is expanded.
    virtual Transform parse_at(const std::string& path, const std::string& file,
                               const EvaluationOptions& options) const = 0;
    virtual Reading read_at(const std::string& path, const std::string& file,
                            const ReadOptions& options) const = 0;
};

/// Loads OpenColorIO on the first call. Throws Error when it is not installed.
const Ocio& ocio();

/// A file as OpenColorIO evaluates it, by its own path where it can be. Throws Error.
Transform open_in_ocio(const std::string& path, const EvaluationOptions& options = {});

} // namespace lutlib::io
