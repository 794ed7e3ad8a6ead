#include "converter/grade_stream.h"

#include "converter/grade_text.h"
#include "converter/replaceable.h"
#include "converter/report.h"
#include "lutlib/error.h"
#include "lutlib/io/png.h"
#include "lutlib/io/png_stream.h"
#include "lutlib/io/reason.h"

#include <fmt/core.h>

#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

namespace converter {
namespace {

namespace io = lutlib::io;

// Bytes that have been read before those of a file.
class Rest final : public lutlib::ByteSource {
  public:
    Rest(std::string head, io::FileInput& file) : head_(std::move(head)), file_(file) {}
    std::size_t read(char* to, std::size_t most) override {
        const std::size_t some = head_.copy(to, most);
        head_.erase(0, some);
        return some > 0 ? some : file_.read(to, most);
    }
    std::size_t remaining() const override { return 0; }
    std::string all() { return file_.all_of(std::move(head_)); }

  private:
    std::string head_;
    io::FileInput& file_;
};

// The bytes of a picture as those of standard input; `png` is what then went to standard output.
Graded grade_apart(const Grading& grading, std::string bytes, const std::string& output,
                   std::span<const io::Depth> held, std::string& png) {
    io::StandardStreamsInstead streams(std::move(bytes));
    Graded out = grade_file(grading, std::string(io::standard_stream), output, held);
    png = std::move(streams.output);
    return out;
}

// Takes pictures in turn, grades them at once, and writes them in turn.
class Stream {
  public:
    Stream(const Grading& grading, const io::OutputTemplate& output, const ManyOptions& options,
           io::PngStream& source, std::vector<std::string> begun)
        : grading_(grading), output_(output), options_(options), source_(source),
          begun_(std::move(begun)),
          held_(require_depth(grading.depth, output.path_for({"-", "1"}))) {}

    GradedStream all() {
        std::vector<std::thread> others;
        for (std::size_t i = 1; i < options_.jobs(); ++i) {
            others.emplace_back([this] { work_off(); });
        }
        work_off();
        for (std::thread& other : others) {
            other.join();
        }
        if (broken_) {
            std::rethrow_exception(broken_);
        }
        return std::move(out_);
    }

  private:
    // Of the next picture; nothing where there is none.
    std::optional<std::string> take(std::size_t& index) {
        const std::lock_guard lock(reading_);
        if (broken_ || is_done_) {
            return std::nullopt;
        }
        index = taken_++;
        if (index < begun_.size()) {
            return std::move(begun_[index]);
        }
        try {
            std::optional<std::string> bytes = source_.next();
            is_done_ = !bytes;
            return bytes;
        } catch (...) {
            broken_ = std::current_exception();
            return std::nullopt;
        }
    }

    void work_off() {
        std::size_t index = 0;
        while (std::optional<std::string> bytes = take(index)) {
            io::Route route{{fmt::format("picture {} of standard input", index + 1)},
                            output_.path_for({"-", std::to_string(index + 1)})};
            std::optional<Graded> graded;
            std::string reason;
            std::string png;
            try {
                require_replaceable(std::span(&route, 1));
                graded = grade_apart(grading_, std::move(*bytes), route.to, held_, png);
            } catch (const std::exception& error) {
                reason = io::reason_of(error);
            }
            put(index, std::move(route), std::move(graded), reason, png);
        }
    }

    // In the order of the stream.
    void put(std::size_t index, io::Route route, std::optional<Graded> graded,
             const std::string& reason, const std::string& png) {
        std::unique_lock lock(writing_);
        turn_.wait(lock, [&] { return put_ == index; });
        if (!graded) {
            print("lutconv: " + one_line(route.from.path + ": " + reason) + '\n',
                  std::string(io::standard_stream));
            out_.graded.failures.push_back({route.from.path, reason});
        } else {
            write(png);
            if (options_.is_verbose()) {
                print(fmt::format("{} -> {}: {}\n", route.from.path, output_text(route.to),
                                  size_text(*graded)),
                      output_.text());
            }
        }
        out_.routes.push_back(std::move(route));
        out_.graded.pictures.push_back(std::move(graded));
        ++put_;
        turn_.notify_all();
    }

    // Who reads may have gone: then the rest is not made.
    void write(const std::string& png) {
        try {
            if (!png.empty()) {
                io::write_file(std::string(io::standard_stream), png);
            }
        } catch (...) {
            const std::lock_guard lock(reading_);
            broken_ = std::current_exception();
        }
    }

    const Grading& grading_;
    const io::OutputTemplate& output_;
    const ManyOptions& options_;
    io::PngStream& source_;
    std::vector<std::string> begun_;
    std::vector<io::Depth> held_;
    std::mutex reading_, writing_;
    std::condition_variable turn_;
    std::exception_ptr broken_;
    bool is_done_ = false;
    std::size_t taken_ = 0, put_ = 0;
    GradedStream out_;
};

} // namespace

GradedStream grade_stream(const Grading& grading, const io::OutputTemplate& output,
                          const ManyOptions& options) {
    const std::string name = io::input_name(std::string(io::standard_stream));
    io::FileInput file{std::string(io::standard_stream)};
    constexpr std::size_t enough_to_tell = 8;
    std::string head = file.head(enough_to_tell);
    const bool is_png = io::is_png(head);
    Rest rest(std::move(head), file);
    io::PngStream source(rest, name);
    std::vector<std::string> begun{is_png ? *source.next() : rest.all()};
    std::exception_ptr broken;
    std::optional<std::string> second;
    try {
        second = is_png ? source.next() : std::nullopt;
    } catch (...) {
        broken = std::current_exception();
    }
    if (second) {
        begun.push_back(std::move(*second));
    } else {
        const std::string to = output.path_for({"-", "1"});
        const std::vector<io::Depth> held = require_depth(grading.depth, to);
        std::string png;
        GradedStream out{{{{"-"}, to}}, {}, true};
        out.graded.pictures.emplace_back(
            grade_apart(grading, std::move(begun.front()), to, held, png));
        if (!png.empty()) {
            io::write_file(std::string(io::standard_stream), png);
        }
        if (broken) {
            std::rethrow_exception(broken);
        }
        return out;
    }
    if (!output.varies() && output.text() != io::standard_stream) {
        throw lutlib::UsageError("standard input holds several pictures: write them to -, or give "
                                 "-o a place for their number, as out.####.png");
    }
    return Stream(grading, output, options, source, std::move(begun)).all();
}

} // namespace converter
