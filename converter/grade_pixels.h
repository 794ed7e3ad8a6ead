// The colours of a picture through a look, as far as tables hold it: what of the look a picture
// needs, laid out once for all pictures of a run.
#pragma once

#include "lutlib/interpolation/grade.h"
#include "lutlib/io/image.h"
#include "lutlib/io/look.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace converter {

/// A look whose table is laid out when it is first needed. Cheap to copy; may be used from several
/// threads at once.
class LookOfPixels {
  public:
    explicit LookOfPixels(const lutlib::io::Look& look);

    /// Whether samples of this depth go through a table as they are: integers where codes of 0..1
    /// become such codes.
    bool keeps(lutlib::io::Depth depth) const;

    /// Needs a look that is a table. `inside`: no colour lies outside the look's domain.
    const lutlib::Grading& table(bool inside) const;

    /// What a picture inside the domain does not need, a sentence each.
    std::vector<std::string> left_out() const;

  private:
    struct Tables;
    const Tables& tables() const;

    struct Lazy;
    std::shared_ptr<Lazy> lazy_;
};

lutlib::ConstPictureView view_of(const lutlib::io::SampleImage& image);

/// Into `graded`, which is as large as the image's samples and then stands for them; in place where
/// it is empty. `inside`: no colour lies outside the look's domain.
void grade_samples(const LookOfPixels& look, bool inside, lutlib::io::SampleImage& image,
                   lutlib::io::SampleBuffer&& graded);

/// RGBA floats, in place.
void grade_floats(const LookOfPixels& look, bool inside, lutlib::io::FloatImage& image);

} // namespace converter
