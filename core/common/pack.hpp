#pragma once
// Pack<W>: W doubles side by side, used as one scalar type (SIMD). Each of the W entries, called lanes,
// belongs to a different arm. With Pack<W> as the scalar type, a template therefore computes W arms at once.
// For each arm, the operations and their order are the same as for the arm alone, so the results are
// bit-identical. Pack uses GCC's vector extensions, so any width compiles for any processor.

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <limits>

#include "core/common/joint_math.hpp"
#include "core/common/select.hpp"

namespace armtune::internal {

template <int W>
struct PackRegister;
template <>
struct PackRegister<2> {
  using Doubles = double __attribute__((vector_size(16)));
};
template <>
struct PackRegister<4> {
  using Doubles = double __attribute__((vector_size(32)));
};
template <>
struct PackRegister<8> {
  using Doubles = double __attribute__((vector_size(64)));
};

template <int W>
class Pack {
 public:
  using Register = typename PackRegister<W>::Doubles;
  /// The result of a comparison. In each lane, all bits are set if the comparison is true, else none.
  using Mask = decltype(Register{} < Register{});

  Pack() = default;
  Pack(double x) : v_(x - Register{}) {}  // NOLINT(google-explicit-constructor): doubles convert implicitly
  explicit Pack(const Register& v) : v_(v) {}

  const Register& values() const { return v_; }
  double operator[](int lane) const { return v_[lane]; }
  void set(int lane, double x) { v_[lane] = x; }

  friend Pack operator+(const Pack& a, const Pack& b) { return Pack(a.v_ + b.v_); }
  friend Pack operator-(const Pack& a, const Pack& b) { return Pack(a.v_ - b.v_); }
  friend Pack operator*(const Pack& a, const Pack& b) { return Pack(a.v_ * b.v_); }
  friend Pack operator/(const Pack& a, const Pack& b) { return Pack(a.v_ / b.v_); }
  Pack operator-() const { return Pack(-v_); }
  Pack& operator+=(const Pack& b) { return *this = *this + b; }
  Pack& operator-=(const Pack& b) { return *this = *this - b; }
  Pack& operator*=(const Pack& b) { return *this = *this * b; }
  Pack& operator/=(const Pack& b) { return *this = *this / b; }
  friend Mask operator<(const Pack& a, const Pack& b) { return a.v_ < b.v_; }
  friend Mask operator>(const Pack& a, const Pack& b) { return a.v_ > b.v_; }
  friend Mask operator>=(const Pack& a, const Pack& b) { return a.v_ >= b.v_; }

 private:
  Register v_;
};

/// Returns a where the mask is set, else b.
template <int W>
Pack<W> select(const typename Pack<W>::Mask& where, const Pack<W>& a, const Pack<W>& b) {
  return Pack<W>(where ? a.values() : b.values());
}

template <int W>
Pack<W> abs(const Pack<W>& x) {
  using Mask = typename Pack<W>::Mask;
  constexpr auto kMagnitude = std::numeric_limits<std::int64_t>::max();  // every bit except the sign
  return Pack<W>(std::bit_cast<typename Pack<W>::Register>(std::bit_cast<Mask>(x.values()) & kMagnitude));
}
template <int W>
Pack<W> sqrt(const Pack<W>& x) {
  typename Pack<W>::Register root = x.values();
  for (int lane = 0; lane < W; ++lane) root[lane] = std::sqrt(root[lane]);
  return Pack<W>(root);
}

/// Computes sin and cos of every entry of x (n). If one angle of an arm is too large for the fast method, the
/// slow method is used for all angles of that arm, as it would be for the arm alone.
template <int W>
void sines_and_cosines(const JointVectorT<Pack<W>>& x, JointVectorT<Pack<W>>& sines,
                       JointVectorT<Pack<W>>& cosines) {
  sines.resize(x.size());
  cosines.resize(x.size());
  auto large = Pack<W>(0.0) > Pack<W>(0.0);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    typename Pack<W>::Register s;
    typename Pack<W>::Register c;
    vector_math::sine_cosine(x[i].values(), s, c);
    sines[i] = Pack<W>(s);
    cosines[i] = Pack<W>(c);
    large |= ~(abs(x[i]).values() <= Pack<W>(vector_math::kLargestAngle).values());
  }
  if (!any(large)) return;
  for (int lane = 0; lane < W; ++lane) {
    if (large[lane] == 0) continue;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      sines[i].set(lane, std::sin(x[i][lane]));
      cosines[i].set(lane, std::cos(x[i][lane]));
    }
  }
}

/// Returns e^x of every lane. vector_math::exponential uses the same arithmetic for every width.
template <int W>
Pack<W> exp(const Pack<W>& x) {
  return Pack<W>(vector_math::exponential(x.values()));
}

}  // namespace armtune::internal

namespace Eigen {

template <int W>
struct NumTraits<armtune::internal::Pack<W>> : GenericNumTraits<double> {
  using Real = armtune::internal::Pack<W>;
  using NonInteger = armtune::internal::Pack<W>;
  using Nested = armtune::internal::Pack<W>;
  using Literal = double;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
};

namespace internal {
/// Gives arrays of packs the alignment of a pack. Without AVX, Eigen would align them to only 16 bytes, which
/// Clang rejects.
template <int W, int Size>
struct compute_default_alignment<armtune::internal::Pack<W>, Size> {
  enum { value = 0 };
};
}  // namespace internal
}  // namespace Eigen
