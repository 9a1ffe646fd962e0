#pragma once
// The largest error of a law over all its samples, and finite differences to hold laws against.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace armtune::internal::test {

/// |a - b| / max(|a|, |b|, floor), Euclidean norms; zero when both are equal. Where two sides may vanish,
/// `floor` is the size of the terms that cancel.
template <typename A, typename B>
double relative_error(const A& a, const B& b, double floor = 0.0) {
  const double size = std::max({a.norm(), b.norm(), floor});
  const double difference = (a - b).norm();
  return difference == 0.0 ? 0.0 : difference / size;
}
inline double relative_error(double a, double b, double floor = 0.0) {
  const double size = std::max({std::abs(a), std::abs(b), floor});
  return a == b ? 0.0 : std::abs(a - b) / size;
}

/// Collects the errors of one law. At the end of its scope the largest must be within the tolerance, and
/// there must have been one; it is recorded as a property of the test (--gtest_output=xml).
class WorstError {
 public:
  WorstError(std::string law, double tolerance) : law_(std::move(law)), tolerance_(tolerance) {}
  WorstError(const WorstError&) = delete;
  WorstError& operator=(const WorstError&) = delete;
  ~WorstError() {
    testing::Test::RecordProperty(law_, fmt::format("{:.2g}", worst_));
    EXPECT_GE(worst_, 0.0) << law_ << ": nothing was compared";
    EXPECT_LE(worst_, tolerance_) << law_ << ": worst on " << where_;
  }

  void add(double error, const std::string& where) {
    if (!std::isfinite(error)) error = std::numeric_limits<double>::infinity();
    if (error <= worst_) return;
    worst_ = error;
    where_ = where;
  }
  template <typename A, typename B>
  void compare(const A& a, const B& b, const std::string& where, double floor = 0.0) {
    add(relative_error(a, b, floor), where);
  }

 private:
  std::string law_;
  double tolerance_;
  double worst_ = -1.0;
  std::string where_ = "nothing";
};

/// f'(0) by the five-point central difference: error h^4/30 times the fifth derivative, plus about
/// 1e-16 |f| / h of rounding. With h = 1e-3 both are 1e-13 of a pose, a sinusoid of each joint angle.
template <typename F>
auto derivative(const F& f, double h = 1e-3) {
  using Value = decltype(f(0.0));
  return Value((f(-2.0 * h) - f(2.0 * h) + 8.0 * (f(h) - f(-h))) / (12.0 * h));
}

}  // namespace armtune::internal::test
