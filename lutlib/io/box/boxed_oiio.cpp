#include "lutlib/io/box/boxed_oiio.h"

#include "lutlib/io/box/box.h"
#include "lutlib/io/box/serve.h"
#include "lutlib/io/box/shared_bytes.h"
#include "lutlib/io/box/source.h"
#include "lutlib/io/box/values.h"
#include "lutlib/io/file.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <system_error>

namespace lutlib::io::box {
namespace {

[[noreturn]] void fail(const char* message, const std::string& file) {
    throw Error(message + (": " + std::generic_category().message(errno)), {file, 0, {}});
}

// A file as it is now, for a process that may open none. Answers its size.
std::size_t copy_into(int memory, const std::string& path, const std::string& file) {
    const Descriptor from(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    struct stat info {};
    if (from.get() < 0 || ::fstat(from.get(), &info) != 0) {
        fail("cannot open the file", file);
    }
    std::size_t left = static_cast<std::size_t>(info.st_size);
    while (left > 0) {
        const ssize_t copied = ::sendfile(memory, from.get(), nullptr, left);
        if (copied < 0 && errno != EINTR) {
            fail("cannot read the file", file);
        }
        if (copied == 0) {
            break; // it has become shorter meanwhile
        }
        left -= static_cast<std::size_t>(std::max<ssize_t>(copied, 0));
    }
    return static_cast<std::size_t>(info.st_size);
}

void write_all(const std::string& path, std::span<const std::byte> bytes, const std::string& file) {
    const Descriptor to(::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
    if (to.get() < 0) {
        fail("cannot open the file for writing", file);
    }
    while (!bytes.empty()) {
        const ssize_t written = ::write(to.get(), bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            fail("cannot write the picture", file);
        }
        bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
}

// A reader's work on a picture of ours, not on a file of so many bytes.
About about_picture(const std::string& file, const SampleImage& image) {
    return {file, image.pixels() * 2};
}

} // namespace

Incoming BoxedOiio::ask(const Outgoing& question, const About& about) const {
    std::unique_ptr<Reader> reader;
    {
        const std::lock_guard lock(mutex_);
        if (!idle_.empty()) {
            reader = std::move(idle_.back());
            idle_.pop_back();
        }
    }
    if (!reader) {
        reader = std::make_unique<Reader>(library_, Allowance{box::memory(), {}});
    }
    const auto keep = [&] {
        if (reader->is_alive()) {
            const std::lock_guard lock(mutex_);
            idle_.push_back(std::move(reader));
        }
    };
    try {
        Incoming answer = reader->ask(question, about);
        keep();
        return answer;
    } catch (...) {
        keep();
        throw;
    }
}

Held BoxedOiio::held() const {
    Incoming answer = ask(question(OiioCall::held, {}), {});
    return take_held(answer);
}

std::string BoxedOiio::version() const {
    return ask(question(OiioCall::version, {}), {}).take_text();
}

Oiio::Size BoxedOiio::size(const std::string& path) const {
    const Descriptor copy(new_memory_file());
    const About about{path, copy_into(copy.get(), path, path)};
    Outgoing asked = question(OiioCall::size, about);
    asked.attach(copy.get());
    return ask(asked, about).take<Size>();
}

SampleImage BoxedOiio::read(const std::string& path, const std::string& file,
                            const ImageReadOptions& options, const Allocate&) const {
    const Descriptor copy(new_memory_file());
    const About about{file, copy_into(copy.get(), path, file)};
    Outgoing asked = question(OiioCall::read, about);
    asked.put(std::string_view(file));
    asked.put(std::string_view(options.layer));
    asked.put(std::uint8_t{options.partial});
    asked.attach(copy.get());
    Incoming answer = ask(asked, about);
    SampleImage out = take_image(answer, Sharing::ended);
    out.source = take_source(answer);
    return out;
}

bool BoxedOiio::writes(const std::string& path) const {
    Outgoing asked = question(OiioCall::writes, {});
    asked.put(std::string_view(path));
    return ask(asked, {}).take_bool();
}

std::vector<std::string> BoxedOiio::written_extensions() const {
    return ask(question(OiioCall::written_extensions, {}), {}).take_texts();
}

Depth BoxedOiio::written_depth(const std::string&, const std::string& name, const std::string& file,
                               Depth depth) const {
    const About about{file};
    Outgoing asked = question(OiioCall::written_depth, about);
    asked.put(std::string_view(name));
    asked.put(std::string_view(file));
    asked.put(depth);
    return ask(asked, about).take<Depth>();
}

SampleBuffer BoxedOiio::memory(std::size_t bytes) const {
    return SharedBytes(bytes).samples();
}

std::vector<std::string> BoxedOiio::write(const std::string& path, const std::string& name,
                                          const std::string& file, const SampleImage& image,
                                          const ImageWriteOptions& options) const {
    const About about = about_picture(file, image);
    Outgoing asked = question(OiioCall::write, about);
    asked.put(std::string_view(name));
    asked.put(std::string_view(file));
    put(asked, image);
    asked.put(std::uint8_t{options.keep_color});
    asked.put_pairs(options.text);
    const auto* const boxed = dynamic_cast<const BoxedSource*>(options.keep);
    put_source(asked, options.keep, boxed ? boxed->packed : SharedBytes());
    Incoming answer = ask(asked, about);
    std::vector<std::string> lost = answer.take_texts();
    write_all(path, SharedBytes::adopt(answer.take_file()).bytes(), file);
    return lost;
}

std::string BoxedOiio::packed(const PictureSource& source) const {
    const auto* const boxed = dynamic_cast<const BoxedSource*>(&source);
    const auto bytes = boxed ? boxed->packed.bytes() : std::span<std::byte>{};
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::shared_ptr<const PictureSource> BoxedOiio::unpacked(std::string_view) const {
    throw Error("a boxed picture is unpacked in its reader");
}

} // namespace lutlib::io::box
