// Errors that the window shows until they are closed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace preview::panels {

struct Ui;

class Errors {
  public:
    /// So many are in sight; the older ones follow as those are closed.
    static constexpr std::size_t most_shown = 4;
    /// So many different ones are kept; of the oldest beyond only their number.
    static constexpr std::size_t most_kept = 50;

    struct Row {
        std::string text;
        std::size_t count = 1; ///< how often it was said
    };

    /// One that is there already is said once more, and is the newest again.
    void add(std::string text);
    void close(std::size_t at);
    void clear();

    /// The newest first.
    const std::vector<Row>& rows() const { return rows_; }
    bool empty() const { return rows_.empty(); }
    /// A sentence of those that are not in sight; empty: all are.
    std::string more() const;

  private:
    std::vector<Row> rows_;
    std::size_t dropped_ = 0;
};

/// They and how they are closed, over a part of the picture.
void error_window(Ui& ui);

} // namespace preview::panels
