#pragma once
// A dual number: a value together with its derivatives along N directions. With dual numbers as the scalar
// type, a function template also computes its exact Jacobian, by forward-mode differentiation (Griewank and
// Walther, Evaluating Derivatives, chapter 3).

#include <Eigen/Core>
#include <cmath>

namespace armtune::internal {

template <int N>
struct Dual {
  double value = 0.0;
  Eigen::Array<double, N, 1> slope = Eigen::Array<double, N, 1>::Zero();

  Dual() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): constants convert implicitly
  Dual(double constant) : value(constant) {}
  Dual(double v, const Eigen::Array<double, N, 1>& d) : value(v), slope(d) {}
  /// Returns the variable with value v whose derivative is 1 along direction k.
  static Dual variable(double v, int k) {
    Dual x(v);
    x.slope[k] = 1.0;
    return x;
  }

  Dual operator-() const { return {-value, -slope}; }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.slope + b.slope}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.slope - b.slope}; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.slope * b.value + b.slope * a.value};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double quotient = a.value / b.value;
    return {quotient, (a.slope - b.slope * quotient) / b.value};
  }
  friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend Dual sin(const Dual& a) { return {std::sin(a.value), a.slope * std::cos(a.value)}; }
  friend Dual cos(const Dual& a) { return {std::cos(a.value), a.slope * -std::sin(a.value)}; }
  friend Dual exp(const Dual& a) {
    const double e = std::exp(a.value);
    return {e, a.slope * e};
  }
  friend Dual sqrt(const Dual& a) {
    const double root = std::sqrt(a.value);
    return {root, a.slope / (2.0 * root)};
  }
};

}  // namespace armtune::internal

template <int N>
struct Eigen::NumTraits<armtune::internal::Dual<N>> : Eigen::NumTraits<double> {
  using Real = armtune::internal::Dual<N>;
  using NonInteger = armtune::internal::Dual<N>;
  using Nested = armtune::internal::Dual<N>;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 1,
    AddCost = N,
    MulCost = 3 * N
  };
};
