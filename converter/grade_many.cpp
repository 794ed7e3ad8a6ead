#include "converter/grade_many.h"

#include "converter/grade_text.h"
#include "converter/report.h"
#include "lutlib/io/file.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace converter {
namespace {

namespace io = lutlib::io;
using io::Route;

// What files of each extension can store.
class Depths {
  public:
    Depths(const Grading& grading, std::span<const Route> routes) {
        for (const Route& route : routes) {
            const std::string extension = io::extension_of(route.to);
            if (!by_extension_.contains(extension)) {
                by_extension_[extension] = require_depth(grading.depth, route.to);
            }
        }
    }
    std::span<const io::Depth> of(const Route& route) const {
        return by_extension_.at(io::extension_of(route.to));
    }

  private:
    std::map<std::string, std::vector<io::Depth>> by_extension_;
};

// "3 pictures", "1 picture"
std::string pictures(std::size_t count) {
    return fmt::format("{} picture{}", count, count == 1 ? "" : "s");
}

// Lines that pictures share, in the order of their first one.
class SharedLines {
  public:
    void add(const std::string& line, const std::string& picture) {
        const auto found = std::find_if(lines_.begin(), lines_.end(),
                                        [&](const Line& l) { return l.text == line; });
        if (found != lines_.end()) {
            ++found->count;
        } else {
            lines_.push_back({line, picture, 1});
        }
    }
    std::string text(std::size_t all) const {
        std::string out;
        for (const Line& line : lines_) {
            out += "  " + line.text;
            if (line.count < all) {
                out += " (" + input_text(line.first);
                out += line.count > 1 ? fmt::format(" and {} more)", line.count - 1) : ")";
            }
            out += '\n';
        }
        return out;
    }

  private:
    struct Line {
        std::string text, first;
        std::size_t count = 0;
    };
    std::vector<Line> lines_;
};

std::string text_of(const GradedMany& graded, const Grading& grading, std::span<const Route> routes,
                    const std::string& output) {
    SharedLines lines;
    PixelCounts counts;
    std::size_t done = 0;
    for (std::size_t i = 0; i < routes.size(); ++i) {
        if (const auto& picture = graded.pictures[i]) {
            ++done;
            counts += picture->counts;
            lines.add(size_text(*picture), routes[i].from.path);
            for (const std::string& line : lines_of(*picture, grading, routes[i].to)) {
                lines.add(line, routes[i].from.path);
            }
        }
    }
    std::string out = fmt::format("{} -> {}\n", pictures(done), output_text(output));
    if (graded.there > 0) {
        out += fmt::format("  {} more {} there already\n", graded.there,
                           graded.there == 1 ? "was" : "were");
    }
    out += lines.text(done);
    for (const std::string& line : lines_of(counts)) {
        out += "  " + line + '\n';
    }
    if (!graded.failures.empty()) {
        out += fmt::format("  failed: {}, as said on standard error\n",
                           pictures(graded.failures.size()));
    }
    return out;
}

nlohmann::ordered_json json_of(const GradedMany& graded, std::span<const Route> routes,
                               const std::string& lut) {
    nlohmann::ordered_json done = nlohmann::ordered_json::array(),
                           failed = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < routes.size(); ++i) {
        if (graded.pictures[i]) {
            done.push_back(to_json(*graded.pictures[i], routes[i].from.path, routes[i].to));
        }
    }
    for (const Failure& failure : graded.failures) {
        failed.push_back({{"picture", failure.file}, {"reason", failure.reason}});
    }
    return {{"lut", io::input_name(lut)},
            {"pictures", done},
            {"were_there", graded.there},
            {"failed", failed}};
}

} // namespace

GradedMany grade_many(const Grading& grading, std::span<const Route> routes,
                      const ManyOptions& options, const std::string& output) {
    const Depths depths(grading, routes);
    GradedMany out;
    out.pictures.resize(routes.size());
    if (options.is_verbose()) {
        print(fmt::format("{} at once at most, as many as fit into {} MB\n",
                          pictures(options.jobs()), options.memory() >> 20),
              output);
    }
    const Work work{
        "pictures", [](const Route& route) { return io::bytes_in_work(route.from.path); },
        [&](const Route& route, std::size_t index) {
            out.pictures[index] = grade_file(grading, route.from.path, route.to, depths.of(route));
            return fmt::format("{} -> {}: {}", input_text(route.from.path), output_text(route.to),
                               size_text(*out.pictures[index]));
        }};
    out.failures = run_each(routes, work, options, output);
    return out;
}

void print_report(const GradedMany& graded, const Grading& grading, std::span<const Route> routes,
                  const std::string& lut, const std::string& output, bool json) {
    if (json) {
        print(json_of(graded, routes, lut), output);
    } else {
        print(text_of(graded, grading, routes, output), output);
    }
}

} // namespace converter
