// What is chosen among combinations, and the fits, against brute force and known answers.
#include "preview/finish/blooms.h"
#include "preview/report/budget.h"
#include "preview/report/glare.h"
#include "preview/report/growth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace preview::report {
namespace {

using Passes = std::vector<std::vector<ChoiceOption>>;

Passes some_passes(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(0, 1);
    Passes out(4);
    for (auto& options : out) {
        for (int i = 0; i < 5; ++i) {
            options.push_back({std::to_string(i), number(random), number(random)});
        }
    }
    return out;
}

/// The least error of any combination within the time; infinite where there is none.
double least_error(const Passes& passes, double seconds, std::size_t pass = 0) {
    if (pass == passes.size()) {
        return seconds >= 0 ? 0 : HUGE_VAL;
    }
    double least = HUGE_VAL;
    for (const ChoiceOption& option : passes[pass]) {
        least =
            std::min(least, option.error + least_error(passes, seconds - option.seconds, pass + 1));
    }
    return least;
}

TEST(CombinationFront, has_the_best_of_every_budget) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        const Passes passes = some_passes(seed);
        const std::vector<Combination> front = combination_front(passes);
        for (double budget = 0; budget < 4; budget += 0.07) {
            const Combination* const best = within_budget(front, budget);
            const double least = least_error(passes, budget);
            ASSERT_EQ(best == nullptr, std::isinf(least)) << budget;
            if (best != nullptr) {
                EXPECT_NEAR(best->error, least, 1e-12) << budget;
                double seconds = 0, error = 0;
                for (std::size_t i = 0; i < passes.size(); ++i) {
                    seconds += passes[i][best->options[i]].seconds;
                    error += passes[i][best->options[i]].error;
                }
                EXPECT_NEAR(seconds, best->seconds, 1e-12);
                EXPECT_NEAR(error, best->error, 1e-12);
            }
        }
    }
}

TEST(CombinationFront, costs_more_for_less_error_from_one_to_the_next) {
    const std::vector<Combination> front = combination_front(some_passes(7));
    ASSERT_GT(front.size(), 5U);
    for (std::size_t i = 1; i < front.size(); ++i) {
        EXPECT_GT(front[i].seconds, front[i - 1].seconds);
        EXPECT_LT(front[i].error, front[i - 1].error);
    }
}

TEST(Growth, finds_the_exponent_of_a_power) {
    std::vector<double> x, y;
    for (const double amount : {1.0, 4.0, 16.0, 300.0}) {
        x.push_back(amount);
        y.push_back(0.02 * std::pow(amount, 1.37));
    }
    EXPECT_NEAR(fitted_exponent(x, y), 1.37, 1e-12);
}

/// Spencer's functions as they are printed, in degrees, summed over rings of the hemisphere.
double summed_spencer(double degrees) {
    const auto summed = [](double to, double (*f)(double)) {
        double sum = 0;
        const int rings = 40000;
        // Finer in the middle: radii are squares.
        for (int i = 0; i < rings; ++i) {
            const double from = to * std::pow(i / static_cast<double>(rings), 3),
                         end = to * std::pow((i + 1) / static_cast<double>(rings), 3);
            const double middle = (from + end) / 2;
            sum += 2 * std::numbers::pi * middle * f(middle) * (end - from);
        }
        return sum;
    };
    const auto share = [&](double (*f)(double)) { return summed(degrees, f) / summed(90, f); };
    return 0.384 * share([](double t) { return 2.61e6 * std::exp(-t * t / (0.02 * 0.02)); }) +
           0.478 * share([](double t) { return 20.91 / std::pow(t + 0.02, 3); }) +
           0.138 * share([](double t) { return 72.37 / std::pow(t + 0.02, 2); });
}

TEST(Glare, of_eyes_is_the_integral_of_the_published_function) {
    for (const double degrees : {0.01, 0.1, 1.0, 10.0}) {
        EXPECT_NEAR(spencer_encircled(degrees), summed_spencer(degrees), 1e-4) << degrees;
    }
    EXPECT_EQ(spencer_encircled(0), 0);
    EXPECT_NEAR(spencer_encircled(90), 1, 1e-12);
}

TEST(Glare, of_the_model_holds_all_light_in_the_end_and_says_where_it_differs_most) {
    const GlareModel glare = glare_model(40);
    EXPECT_GT(glare.curve.back().model, 0.999);
    double largest = 0;
    for (const EncircledLight& at : glare.curve) {
        largest = std::max(largest, std::abs(at.model - at.measured));
    }
    EXPECT_EQ(largest, glare.largest);
    EXPECT_LE(glare.best_largest, glare.largest);
}

} // namespace
} // namespace preview::report
