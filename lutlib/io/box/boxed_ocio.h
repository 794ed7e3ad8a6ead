// OpenColorIO, whose every file is read by a process of its own. A transform lives in the process
// that has read it.
#pragma once

#include "lutlib/io/ocio.h"

namespace lutlib::io::box {

class BoxedOcio final : public Ocio {
  public:
    std::string version() const override;
    std::vector<std::string> readable_extensions() const override;
    Transform from_lut(const Lut& lut, const EvaluationOptions& options) const override;
    Transform from_config(const ConfigConversion& conversion) const override;
    std::string write(const Lut& lut, const std::string& ocio_name,
                      const WriteOptions& options) const override;
    Transform parse_at(const std::string& path, const std::string& file,
                       const EvaluationOptions& options) const override;
    Reading read_at(const std::string& path, const std::string& file,
                    const ReadOptions& options) const override;
};

} // namespace lutlib::io::box
