#include "lutlib/io/box/boxed_oiio.h"

#include "lutlib/io/box/box.h"
#include "lutlib/io/box/serve.h"
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

// All of a file behind another's place, within the system. Answers its size.
std::size_t copy_all(int to, int from, const char* failure, const std::string& file) {
    struct stat info {};
    if (::fstat(from, &info) != 0) {
        fail(failure, file);
    }
    off_t at = 0;
    while (at < info.st_size) {
        const ssize_t copied =
            ::sendfile(to, from, &at, static_cast<std::size_t>(info.st_size - at));
        if (copied < 0 && errno != EINTR) {
            fail(failure, file);
        }
        if (copied == 0) {
            break; // it has become shorter meanwhile
        }
    }
    return static_cast<std::size_t>(info.st_size);
}

// A file as it is now, for a process that may open none. Answers its size.
std::size_t copy_into(int memory, const std::string& path, const std::string& file) {
    const Descriptor from(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (from.get() < 0) {
        fail("cannot open the file", file);
    }
    return copy_all(memory, from.get(), "cannot read the file", file);
}

void write_all(const std::string& path, int memory, const std::string& file) {
    const Descriptor to(::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
    if (to.get() < 0) {
        fail("cannot open the file for writing", file);
    }
    copy_all(to.get(), memory, "cannot write the picture", file);
}

// A reader's work on a picture of ours, not on a file of so many bytes.
About about_picture(const std::string& file, const SampleImage& image) {
    return {file, image.pixels() * 2};
}

} // namespace

template <class Take>
auto BoxedOiio::ask(const Outgoing& question, const About& about, const Take& take) const {
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
        auto out = take(answer);
        keep();
        return out;
    } catch (...) {
        keep();
        throw;
    }
}

Held BoxedOiio::held() const {
    return ask(question(OiioCall::held, {}), {}, take_held);
}

std::string BoxedOiio::version() const {
    return ask(question(OiioCall::version, {}), {},
               [](Incoming& answer) { return answer.take_text(); });
}

Oiio::Size BoxedOiio::size(const std::string& path) const {
    const Descriptor copy(new_memory_file());
    const About about{path, copy_into(copy.get(), path, path)};
    Outgoing asked = question(OiioCall::size, about);
    asked.attach(copy.get());
    return ask(asked, about, [](Incoming& answer) { return answer.take<Size>(); });
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
    return ask(asked, about, [](Incoming& answer) {
        SampleImage out = take_image(answer);
        out.source = take_source(answer);
        return out;
    });
}

bool BoxedOiio::writes(const std::string& path) const {
    Outgoing asked = question(OiioCall::writes, {});
    asked.put(std::string_view(path));
    return ask(asked, {}, [](Incoming& answer) { return answer.take_bool(); });
}

std::vector<std::string> BoxedOiio::written_extensions() const {
    return ask(question(OiioCall::written_extensions, {}), {},
               [](Incoming& answer) { return answer.take_texts(); });
}

Depth BoxedOiio::written_depth(const std::string&, const std::string& name, const std::string& file,
                               Depth depth) const {
    const About about{file};
    Outgoing asked = question(OiioCall::written_depth, about);
    asked.put(std::string_view(name));
    asked.put(std::string_view(file));
    asked.put(depth);
    return ask(asked, about, [](Incoming& answer) { return answer.take<Depth>(); });
}

SampleBuffer BoxedOiio::memory(std::size_t bytes) const {
    return pool_.take(bytes);
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
    put_source(asked, options.keep, boxed ? boxed->packed.descriptor() : -1);
    return ask(asked, about, [&](Incoming& answer) {
        std::vector<std::string> lost = answer.take_texts();
        const Descriptor written(answer.take_file());
        write_all(path, written.get(), file);
        return lost;
    });
}

std::string BoxedOiio::packed(const PictureSource& source) const {
    const auto* const boxed = dynamic_cast<const BoxedSource*>(&source);
    const auto bytes = boxed ? boxed->packed.bytes() : std::span<const std::byte>{};
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::shared_ptr<const PictureSource> BoxedOiio::unpacked(std::string_view) const {
    throw Error("a boxed picture is unpacked in its reader");
}

} // namespace lutlib::io::box
