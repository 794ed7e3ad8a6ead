// A colour transform: colours go in, colours come out. The one type for a look that is evaluated,
// whatever evaluates it.
#pragma once

#include "lutlib/rgb.h"

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace lutlib {

enum class Interpolation;
struct Lut;
struct Recipe;

/// What a transform computes in, which sets how closely its answers can be held to.
enum class Precision { float32, float64 };

/// Cheap to copy: copies share what they stand for, which never changes. May be called from several
/// threads at once. A call costs one virtual call and allocates nothing, however many colours it
/// gets.
class Transform {
  public:
    /// Changes nothing.
    Transform() = default;

    /// By a function of one colour, RgbD(RgbD).
    template <class F>
    static Transform each(F f) {
        return batch([f = std::move(f)](std::span<RgbD> colors) {
            for (RgbD& c : colors) {
                c = f(c);
            }
        });
    }

    /// By a function of many, void(std::span<RgbD>), which replaces every colour by its image and
    /// is never given an empty span.
    template <class F>
    static Transform batch(F f, Precision precision = Precision::float64) {
        return Transform(std::make_shared<const WorkOf<F>>(std::move(f)), precision);
    }

    /// A look through the double oracle, its cube interpolated as `how` says, else as the look
    /// asks for.
    static Transform of(std::shared_ptr<const Lut> lut, std::optional<Interpolation> how = {});
    /// The same of a look that outlives the transform.
    static Transform of(const Lut& lut, std::optional<Interpolation> how = {});
    static Transform of(const Lut&& lut, std::optional<Interpolation> how = {}) = delete;

    /// A recipe's base and operators, compiled. Colours are converted between code values, linear
    /// light and Oklab only where neighbouring operators differ, so code values are decoded at most
    /// once for a run of operators in light. Operations that are disabled or at their defaults cost
    /// nothing and round nothing: a recipe of such is exactly the identity.
    ///
    /// Every double has a finite answer: NaN reads as 0, and every stage's result is held within
    /// the range of a float. Needs base_lut where the recipe names a base; throws Error otherwise.
    static Transform of(const Recipe& recipe);

    /// Replaces every colour by its image.
    void operator()(std::span<RgbD> colors) const {
        if (work_ && !colors.empty()) {
            work_->apply(colors);
        }
    }
    RgbD operator()(RgbD color) const {
        (*this)(std::span(&color, 1));
        return color;
    }

    Precision precision() const { return precision_; }

  private:
    struct Work {
        virtual ~Work() = default;
        virtual void apply(std::span<RgbD> colors) const = 0;
    };
    template <class F>
    struct WorkOf final : Work {
        explicit WorkOf(F function) : f(std::move(function)) {}
        void apply(std::span<RgbD> colors) const override { f(colors); }
        F f;
    };

    Transform(std::shared_ptr<const Work> work, Precision precision)
        : work_(std::move(work)), precision_(precision) {}

    std::shared_ptr<const Work> work_; ///< null: the identity
    Precision precision_ = Precision::float64;
};

/// One after the other, in the order given, as coarse as the coarsest of them.
Transform in_sequence(std::vector<Transform> steps);

/// Replaces every colour by its image, on all cores.
void apply_in_parallel(const Transform& transform, std::span<RgbD> colors);

/// The image of every input, on all cores.
std::vector<RgbD> images_of(const Transform& transform, std::span<const Rgb> inputs);

} // namespace lutlib
