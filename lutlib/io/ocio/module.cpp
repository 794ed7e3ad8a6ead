// The shared library's one door.

#include "lutlib/io/ocio/config.h"
#include "lutlib/io/ocio/read.h"
#include "lutlib/io/ocio/write.h"

#include <algorithm>
#include <cstdlib>

namespace lutlib::io {
namespace {

class Library final : public Ocio {
  public:
    Library() {
        OCIO::SetLoggingLevel(OCIO::LOGGING_LEVEL_NONE);
        // It would override the optimisation that an oracle is asked for.
        ::unsetenv(OCIO::OCIO_OPTIMIZATION_FLAGS_ENVVAR);
    }

    std::string version() const override { return OCIO::GetVersion(); }

    std::vector<std::string> readable_extensions() const override {
        std::vector<std::string> out;
        for (int i = 0; i < OCIO::FileTransform::GetNumFormats(); ++i) {
            out.emplace_back(OCIO::FileTransform::GetFormatExtensionByIndex(i));
        }
        std::sort(out.begin(), out.end());
        out.erase(std::unique(out.begin(), out.end()), out.end());
        return out;
    }

    Transform parse_at(const std::string& path, const std::string& file,
                       const EvaluationOptions& options) const override {
        return guarded(file, [&] {
            return transform_of(cpu_processor(processor_at(path, file, options.interpolation),
                                              options.optimization));
        });
    }

    Transform from_lut(const Lut& lut, const EvaluationOptions& options) const override {
        return guarded({}, [&] {
            return transform_of(
                cpu_processor(processor_of_transform(group_of_lut(lut, options.interpolation)),
                              options.optimization));
        });
    }

    Transform from_config(const ConfigConversion& conversion) const override {
        return guarded(conversion.config, [&] {
            return transform_of(
                cpu_processor(processor_of_config(conversion), Optimization::lossless));
        });
    }

    Reading read_at(const std::string& path, const std::string& file,
                    const ReadOptions& options) const override {
        try {
            return guarded(file, [&] {
                return look_of_processor(processor_at(path, file, std::nullopt), options);
            });
        } catch (const Error& e) {
            throw e.where().file.empty() ? e.in_file(file) : e;
        }
    }

    std::string write(const Lut& lut, const std::string& ocio_name,
                      const WriteOptions& options) const override {
        return write_with_ocio(lut, ocio_name, options);
    }
};

} // namespace
} // namespace lutlib::io

extern "C" __attribute__((visibility("default"))) const lutlib::io::Ocio* lutlib_ocio();

extern "C" const lutlib::io::Ocio* lutlib_ocio() {
    static const lutlib::io::Library library;
    return &library;
}
