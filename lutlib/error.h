// The one exception of the toolkit: what is wrong with somebody's input, and where.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace lutlib {

/// Where an input went wrong. `line` counts from 1, 0 means that the file has no lines.
struct Where {
    std::string file;
    std::size_t line = 0;
    std::string text;
};

/// Input that cannot be used (exit code 2). what() reads "file:line: message: 'text'".
class Error : public std::runtime_error {
  public:
    explicit Error(const std::string& message, Where where = {});

    const std::string& message() const { return message_; }
    const Where& where() const { return where_; }

    /// The same error, said of `file`; for readers that know bytes and not names.
    Error in_file(const std::string& file) const;

  private:
    std::string message_;
    Where where_;
};

/// A command line that cannot be understood (exit code 3).
class UsageError : public Error {
  public:
    using Error::Error;
};

} // namespace lutlib
