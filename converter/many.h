// A verb over many files: which of them, on every core, and what became of them.
#pragma once

#include "converter/progress.h"
#include "converter/verb.h"
#include "lutlib/io/output_names.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace converter {

/// --frames, --resume, --missing, --shard, --jobs, --memory and --verbose.
class ManyOptions {
  public:
    void declare(Verb& verb);

    const std::string& frames() const { return frames_; }
    bool resumes() const { return resume_; }
    /// Nothing is made; what is not there is said.
    bool only_says_missing() const { return missing_; }
    bool is_verbose() const { return verbose_; }
    /// Those that --shard leaves. Throws UsageError.
    std::vector<lutlib::io::Route> of_shard(std::vector<lutlib::io::Route> routes) const;
    /// Files that are worked on at once: --jobs, else as many as there are cores.
    std::size_t jobs() const;
    /// --memory, else 224 MB for each of jobs(), in bytes.
    std::size_t memory() const;

  private:
    std::string frames_, shard_;
    int jobs_ = 0, memory_ = 0;
    bool resume_ = false, missing_ = false, verbose_ = false;
};

/// Takes out the routes whose output is newer than its input and all of `others`; the answer is how
/// many.
std::size_t take_out_done(std::vector<lutlib::io::Route>& routes, std::vector<std::string> others);

/// Prints the outputs that are missing, as --missing does; the answer is an ExitCode.
int tell_missing(std::span<const lutlib::io::Route> missing, std::size_t there,
                 std::string_view what, bool json);

struct Failure {
    std::string file, reason;
};

/// Work on one of many files.
struct Work {
    std::string_view what; ///< what is counted, "pictures"
    /// How much memory it takes, by what can be known before; 0: not worth counting.
    std::function<std::size_t(const lutlib::io::Route&)> bytes;
    /// Throws Error for this file alone. The answer is said under --verbose.
    std::function<std::string(const lutlib::io::Route&, std::size_t index)> run;
};

/// Works on all routes, jobs() at once, as far as memory() allows; one that needs more runs alone.
/// One that fails is said on standard error when it does, and the others go on. The answer is in
/// the order of `routes`. `output` as for print().
std::vector<Failure> run_each(std::span<const lutlib::io::Route> routes, const Work& work,
                              const ManyOptions& options, const std::string& output);

/// Says each on standard error.
void tell_remarks(std::span<const std::string> remarks);

} // namespace converter
