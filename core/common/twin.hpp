#pragma once
// A twin is a pair of numbers. Every operation acts on both numbers at once. If they are doubles, they fit
// into one SSE2 register, which every x86-64 processor has. The dynamics use twins where two quantities go
// through the same arithmetic, such as linear and angular velocity, or force and moment.

namespace armtune::internal {

template <typename T>
class Twin {
 public:
  Twin() = default;
  Twin(const T& first, const T& second) : first_(first), second_(second) {}
  static Twin both(const T& x) { return {x, x}; }

  const T& first() const { return first_; }
  const T& second() const { return second_; }

  friend Twin operator+(const Twin& a, const Twin& b) { return {a.first_ + b.first_, a.second_ + b.second_}; }
  friend Twin operator-(const Twin& a, const Twin& b) { return {a.first_ - b.first_, a.second_ - b.second_}; }
  friend Twin operator*(const Twin& a, const Twin& b) { return {a.first_ * b.first_, a.second_ * b.second_}; }
  friend Twin operator*(const Twin& a, const T& b) { return {a.first_ * b, a.second_ * b}; }
  Twin operator-() const { return {-first_, -second_}; }
  Twin& operator+=(const Twin& b) { return *this = *this + b; }
  Twin& operator-=(const Twin& b) { return *this = *this - b; }
  void add_first(const T& x) { first_ += x; }
  void add_second(const T& x) { second_ += x; }

 private:
  T first_, second_;
};

template <>
class Twin<double> {
 public:
  Twin() = default;
  Twin(double first, double second) : v_{first, second} {}
  static Twin both(double x) { return {x, x}; }

  double first() const { return v_[0]; }
  double second() const { return v_[1]; }

  friend Twin operator+(Twin a, Twin b) { return Twin(a.v_ + b.v_); }
  friend Twin operator-(Twin a, Twin b) { return Twin(a.v_ - b.v_); }
  friend Twin operator*(Twin a, Twin b) { return Twin(a.v_ * b.v_); }
  friend Twin operator*(Twin a, double b) { return Twin(a.v_ * b); }
  Twin operator-() const { return Twin(-v_); }
  Twin& operator+=(Twin b) { return *this = *this + b; }
  Twin& operator-=(Twin b) { return *this = *this - b; }
  // Subtracts -x, so that the other number stays bit-identical: y - 0 is y, while y + 0 turns -0 into 0.
  void add_first(double x) { v_ -= Register{-x, 0.0}; }
  void add_second(double x) { v_ -= Register{0.0, -x}; }

 private:
  using Register = double __attribute__((vector_size(16)));
  explicit Twin(Register v) : v_(v) {}
  Register v_;
};

}  // namespace armtune::internal
