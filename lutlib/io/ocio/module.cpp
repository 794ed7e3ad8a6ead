// The shared library's one door.

#include "lutlib/io/ocio/config.h"
#include "lutlib/io/ocio/read.h"
#include "lutlib/io/ocio/write.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace lutlib::io {
namespace {

// Corrections of a .ccc or .cdl collection; 0 for other files.
std::size_t corrections_in(std::string_view bytes) {
    // Not the collection's own name, which begins alike.
    constexpr std::string_view name = "ColorCorrection", before = "<:", behind = " \t\r\n>/";
    std::size_t count = 0;
    for (std::size_t at = bytes.find(name); at != std::string_view::npos;
         at = bytes.find(name, at + name.size())) {
        const std::size_t end = at + name.size();
        const bool opens = at > 0 && before.find(bytes[at - 1]) != std::string_view::npos &&
                           !bytes.substr(0, at).ends_with("</");
        count += opens && end < bytes.size() && behind.find(bytes[end]) != std::string_view::npos;
    }
    return count;
}

// Whether OpenColorIO, handed this path, opens this very file.
bool finds(const std::string& path) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error) &&
           std::filesystem::absolute(path, error).string().find_first_of("$%") == path.npos;
}

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

    Transform parse(std::string_view bytes, const std::string& extension, const std::string& file,
                    const EvaluationOptions& options) const override {
        return guarded(file, [&] {
            return transform_of(
                cpu_processor(processor_of_file(bytes, extension, file, options.interpolation),
                              options.optimization));
        });
    }

    std::optional<Transform> open(const std::string& path,
                                  const EvaluationOptions& options) const override {
        if (!finds(path)) {
            return std::nullopt;
        }
        return guarded(path, [&] {
            const std::string absolute = std::filesystem::absolute(path).string();
            return transform_of(cpu_processor(processor_at(absolute, path, options.interpolation),
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

    Reading read(std::string_view bytes, const std::string& extension, const std::string& file,
                 const ReadOptions& options) const override {
        Reading out = [&] {
            try {
                return guarded(file, [&] {
                    return look_of_processor(
                        processor_of_file(bytes, extension, file, std::nullopt), options);
                });
            } catch (const Error& e) {
                throw e.where().file.empty() ? e.in_file(file) : e;
            }
        }();
        if (const std::size_t count = corrections_in(bytes); count > 1) {
            out.losses.push_back({"only the first colour correction is read, of",
                                  static_cast<double>(count), "corrections"});
        }
        return out;
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
