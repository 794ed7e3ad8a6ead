// A picture library that does what its file tells it, as a library with a fault would do what a
// stranger's file wants.
#include "lutlib/error.h"
#include "lutlib/io/oiio.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <map>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace lutlib::io {
namespace {

[[noreturn]] void tell(bool has_managed) {
    throw Error(has_managed ? "managed" : "held");
}

void crash() {
    ::raise(SIGSEGV);
}

void run_for_ever() {
    std::atomic<int> turns{0};
    for (;;) {
        ++turns;
    }
}

void take_memory() {
    std::vector<std::vector<char>> all;
    for (;;) {
        all.emplace_back(std::size_t{16} << 20, 'x');
    }
}

void read_a_secret() {
    tell(::open("/etc/passwd", O_RDONLY) >= 0);
}

void write_a_file() {
    tell(::open("/tmp/lutlib_hostile", O_WRONLY | O_CREAT, 0600) >= 0);
}

void remove_a_file() {
    tell(::unlink("/tmp/lutlib_hostile_victim") == 0);
}

void call_home() {
    tell(::socket(AF_INET, SOCK_STREAM, 0) >= 0);
}

void start_a_program() {
    const pid_t child = ::fork();
    if (child == 0) {
        ::_exit(0);
    }
    tell(child > 0);
}

void become_a_program() {
    ::execl("/bin/true", "true", nullptr);
    tell(false);
}

void leave() {
    std::exit(0);
}

// Answers with memory that a thread goes on writing to.
void change_for_ever(SampleBuffer& picture) {
    // Its memory stays, as the reader uses it for the next picture.
    std::thread([first = reinterpret_cast<volatile float*>(picture.data())] {
        for (;;) {
            *first = *first + 1;
        }
    }).detach();
}

class Hostile final : public Oiio {
  public:
    std::string version() const override { return "1"; }

    Size size(const std::string&) const override { return {}; }
    SampleImage read(const std::string& path, const std::string&, const ImageReadOptions&,
                     const Allocate& allocate) const override {
        static const std::map<std::string, void (*)()> deeds{{"crash", crash},
                                                             {"abort", std::abort},
                                                             {"run for ever", run_for_ever},
                                                             {"take memory", take_memory},
                                                             {"read a secret", read_a_secret},
                                                             {"write a file", write_a_file},
                                                             {"remove a file", remove_a_file},
                                                             {"call home", call_home},
                                                             {"start a program", start_a_program},
                                                             {"become a program", become_a_program},
                                                             {"leave", leave}};
        std::ifstream file(path, std::ios::binary);
        const std::string deed(std::istreambuf_iterator<char>(file), {});
        if (const auto found = deeds.find(deed); found != deeds.end()) {
            found->second();
        }
        SampleImage out;
        out.width = out.height = 1;
        out.alpha = true;
        out.samples = allocate(out.bytes());
        constexpr std::array<float, 4> picture{0, 0.25F, 0.5F, 1};
        std::copy(picture.begin(), picture.end(), out.samples.as<float>().begin());
        if (deed == "lie") {
            out.width = 1000;
        } else if (deed == "keep hold") {
            change_for_ever(out.samples);
        }
        out.source = std::make_shared<PictureSource>();
        return out;
    }

    bool writes(const std::string&) const override { return false; }
    std::vector<std::string> written_extensions() const override { return {}; }
    Depth written_depth(const std::string&, const std::string&, const std::string&,
                        Depth depth) const override {
        return depth;
    }
    SampleBuffer memory(std::size_t bytes) const override { return SampleBuffer(bytes); }
    std::vector<std::string> write(const std::string&, const std::string&, const std::string&,
                                   const SampleImage&, const ImageWriteOptions&) const override {
        return {};
    }
    std::string packed(const PictureSource&) const override { return {}; }
    std::shared_ptr<const PictureSource> unpacked(std::string_view) const override {
        return nullptr;
    }
};

} // namespace
} // namespace lutlib::io

extern "C" __attribute__((visibility("default"))) const lutlib::io::Oiio* lutlib_oiio();

extern "C" const lutlib::io::Oiio* lutlib_oiio() {
    static const lutlib::io::Hostile library;
    return &library;
}
