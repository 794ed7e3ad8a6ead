#include "lutlib/io/box/boxed_ocio.h"

#include "lutlib/io/box/box.h"
#include "lutlib/io/box/reader.h"
#include "lutlib/io/box/serve.h"
#include "lutlib/io/box/values.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace lutlib::io::box {
namespace {

Allowance to_read(std::vector<std::string> paths) {
    return {memory(), std::move(paths)};
}

About about_file(const std::string& path, const std::string& file) {
    std::error_code none;
    const auto size = std::filesystem::file_size(path, none);
    return {file, none ? 0 : static_cast<std::size_t>(size)};
}

void put_evaluation(Outgoing& to, const EvaluationOptions& options) {
    to.put(options.interpolation);
    to.put(options.optimization);
}

/// What a reader has made, which answers for one batch of colours at a time.
class Session {
  public:
    Session(std::unique_ptr<Reader> reader, About about)
        : reader_(std::move(reader)), about_(std::move(about)) {}

    void operator()(std::span<RgbD> colors) {
        About about = about_;
        about.colors = colors.size();
        Outgoing asked = question(OcioCall::images, about);
        asked.put_all(std::span<const RgbD>(colors));
        const std::lock_guard lock(mutex_);
        Incoming answer = reader_->ask(asked, about);
        const std::vector<RgbD> images = answer.take_all<RgbD>();
        if (images.size() != colors.size()) {
            throw Error("a boxed reader's answer makes no sense", {about.file, 0, {}});
        }
        std::copy(images.begin(), images.end(), colors.begin());
    }

  private:
    std::mutex mutex_;
    std::unique_ptr<Reader> reader_;
    About about_;
};

Transform transform_of(std::unique_ptr<Reader> reader, const About& about) {
    return Transform::batch([session = std::make_shared<Session>(std::move(reader), about)](
                                std::span<RgbD> colors) { (*session)(colors); },
                            Precision::float32);
}

Transform transform_of(const Allowance& allowance, const Outgoing& asked, const About& about) {
    auto reader = std::make_unique<Reader>(opencolorio, allowance);
    reader->ask(asked, about);
    return transform_of(std::move(reader), about);
}

} // namespace

std::string BoxedOcio::version() const {
    return Reader(opencolorio, to_read({})).ask(question(OcioCall::version, {}), {}).take_text();
}

std::vector<std::string> BoxedOcio::readable_extensions() const {
    return Reader(opencolorio, to_read({}))
        .ask(question(OcioCall::readable_extensions, {}), {})
        .take_texts();
}

Transform BoxedOcio::from_lut(const Lut& lut, const EvaluationOptions& options) const {
    const About about;
    Outgoing asked = question(OcioCall::from_lut, about);
    put(asked, lut);
    put_evaluation(asked, options);
    return transform_of(to_read({}), asked, about);
}

Transform BoxedOcio::from_config(const ConfigConversion& conversion) const {
    std::error_code none;
    const std::filesystem::path config = std::filesystem::absolute(conversion.config, none);
    About about = about_file(conversion.config, conversion.config);
    about.bytes += std::size_t{4} << 20; // and the files that it names
    Outgoing asked = question(OcioCall::from_config, about);
    for (const std::string& text :
         {conversion.config, conversion.from, conversion.to, conversion.display, conversion.view}) {
        asked.put(std::string_view(text));
    }
    return transform_of(to_read({config.parent_path().string()}), asked, about);
}

std::string BoxedOcio::write(const Lut& lut, const std::string& ocio_name,
                             const WriteOptions& options) const {
    const About about{{}, 0, std::size_t{1} << 21};
    Outgoing asked = question(OcioCall::write, about);
    put(asked, lut);
    asked.put(std::string_view(ocio_name));
    asked.put(std::string_view(options.title));
    asked.put(std::int32_t{options.size});
    asked.put(std::int32_t{options.bits});
    return Reader(opencolorio, to_read({})).ask(asked, about).take_text();
}

Transform BoxedOcio::parse_at(const std::string& path, const std::string& file,
                              const EvaluationOptions& options) const {
    const About about = about_file(path, file);
    Outgoing asked = question(OcioCall::parse, about);
    asked.put(std::string_view(path));
    asked.put(std::string_view(file));
    put_evaluation(asked, options);
    return transform_of(to_read({path}), asked, about);
}

Reading BoxedOcio::read_at(const std::string& path, const std::string& file,
                           const ReadOptions& options) const {
    About about = about_file(path, file);
    const auto side = static_cast<std::size_t>(std::clamp(options.size, 65, 256));
    about.colors = side * side * side; // as many as it may be sampled at
    Outgoing asked = question(OcioCall::read, about);
    asked.put(std::string_view(path));
    asked.put(std::string_view(file));
    asked.put(std::int32_t{options.size});
    Incoming answer = Reader(opencolorio, to_read({path})).ask(asked, about);
    return take_reading(answer);
}

} // namespace lutlib::io::box
