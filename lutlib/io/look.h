// A look that a program was handed, opened once: a LUT of any format, a LUT picture or a recipe.
#pragma once

#include "lutlib/bake/bake.h"
#include "lutlib/format.h"
#include "lutlib/recipe/recipe.h"
#include "lutlib/transform.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lutlib::io {

struct LookOptions {
    std::string format = {};        ///< a row of file_formats(); empty: recognised
    int row = 0;                    ///< of lattices stacked in a picture, from the top
    const Layout* layout = nullptr; ///< of pictures, whatever their content shows
    /// The engine that a picture was made for, where its content does not tell.
    const Engine* engine = nullptr;
    std::optional<Interpolation> interpolation = {}; ///< in place of what the look asks for
    LookEncodings encodings = {};                    ///< in place of what the look says
};

/// As what a look was recognised.
struct LookKind {
    std::string format;             ///< a row of file_formats(), or "recipe"
    const Layout* layout = nullptr; ///< of a picture
    const Engine* engine = nullptr; ///< that a picture's text names
};

/// A file that a look was read from: its own, or the base of a recipe.
struct LookFile {
    std::string name;                      ///< for messages
    std::vector<Loss> losses;              ///< what of it was not read
    std::vector<std::string> keywords;     ///< lines of it that are kept but not acted on
    std::vector<std::string> remarks = {}; ///< guesses and contradictions, a sentence each
};

/// A look as a table, with the measured error of what the table does not hold.
struct LookTable {
    std::shared_ptr<const Lut> lut;
    std::vector<Loss> losses;
};

/// The codes of a picture that holds one lattice and nothing else.
struct LookPicture {
    CodeImage codes;
    const Layout* layout = nullptr;
    const Engine* engine = nullptr; ///< that its text names
    int size = 0;
};

/// A look by somebody else's evaluation, to hold others against.
struct LookReference {
    Transform look;
    std::string name; ///< who answers, for reports
    /// Why OpenColorIO evaluates what lutlib read, not the file itself; empty when it does.
    std::string refusal{};
    /// In what OpenColorIO's reading of the file and lutlib's differ by a factor, and why lutlib's
    /// counts, which OpenColorIO then evaluates; empty where they do not.
    std::string scale{};
};

class Look {
  public:
    /// `-` reads standard input. Throws Error, UsageError.
    static Look open(const std::string& path, const LookOptions& options = {});
    /// The same of bytes that have been read from `path`.
    static Look of_bytes(std::string bytes, const std::string& path,
                         const LookOptions& options = {});
    /// Nothing for a file that is no look and does not say that it is one, by its name or as
    /// recipes do. Throws Error for a look that cannot be read, UsageError.
    static std::optional<Look> open_if_look(const std::string& path,
                                            const LookOptions& options = {});

    const std::string& path() const { return path_; }
    const LookKind& kind() const { return kind_; }
    /// Itself first.
    const std::vector<LookFile>& files() const { return files_; }
    const std::string& title() const;
    /// The inputs that the look is meant for.
    Domain domain() const;
    /// The inputs to which it clamps others; none where it clamps none.
    std::optional<Domain> clamps_to() const;

    /// What its code values are, as far as the options, the recipe or the file say.
    LookEncodings encodings() const;

    /// Null unless it is one; its base has been read.
    const Recipe* recipe() const { return recipe_ ? &*recipe_ : nullptr; }
    /// The recipe, or an empty one on top of the look.
    Recipe as_recipe() const;

    /// Whether a table holds all of it.
    bool is_table() const { return !recipe_ && table_losses_.empty(); }
    /// Whether it is read between nodes, so that an interpolation has a part in it.
    bool is_interpolated() const { return !recipe_; }
    /// By what: the options' word, else the look's own, else tetrahedral.
    Interpolation interpolation() const;

    /// Where it may bend: at the nodes of its table, or of a recipe's base and anywhere else.
    Breaks breaks() const;
    /// Nodes a side of a table that is a lattice over 0..1 alone.
    std::optional<int> nodes() const;

    /// A recipe or a table in double; what no table holds in OpenColorIO's evaluation.
    Transform exact() const;

    /// `size`: nodes per axis of a cube that has to be sampled; 0: the look's own choice. What is
    /// sampled is measured against exact().
    LookTable table(int size = 0) const;

    /// Nothing unless it is one.
    std::optional<LookPicture> picture() const;

    /// Evaluated by OpenColorIO, which opens the user's own path, or else is given its bytes, both
    /// independently of lutlib's reader wherever it can; else what lutlib read. What it does not
    /// know is exact(): recipes, and nearest interpolation. Throws Error where OpenColorIO is not
    /// installed.
    LookReference reference(Interpolation how) const;

  private:
    Look(const std::string& path, const LookOptions& options);
    void read_recipe();
    void read_table();
    ReadOptions read_options(int size) const;
    void take(Reading reading, const FileFormat& format);
    Transform in_opencolorio(Interpolation how) const;
    Transform opened_by_opencolorio(Interpolation how) const;

    std::string bytes_; ///< empty: it was read in pieces
    std::string path_, name_;
    LookOptions options_;
    LookKind kind_;
    std::vector<LookFile> files_;
    std::optional<Recipe> recipe_;
    std::shared_ptr<const Lut> lut_; ///< null: a recipe
    std::vector<Loss> table_losses_;
};

} // namespace lutlib::io
