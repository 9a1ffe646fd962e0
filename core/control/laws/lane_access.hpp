#pragma once
// Access to the numbers of a single arm in code that is a template over its scalar type T. T is double for
// one arm, or Pack<W> (core/common/pack.hpp) for W arms, each of which has one lane.

#include <Eigen/Core>
#include <type_traits>

#include "core/common/select.hpp"

namespace armtune::internal {

/// Base class that gives templates over T these functions. They are members of a template, and not free
/// functions, because the name of every function that is compiled for one kind of processor must contain its
/// Pack<W> (scripts/check-lanes).
template <typename T>
class LaneAccessT {
 protected:
  /// Number of arms in a T.
  static constexpr int kLanes = static_cast<int>(sizeof(T) / sizeof(double));

  static void put([[maybe_unused]] int lane, double value, T& to) {
    if constexpr (std::is_same_v<T, double>) {
      to = value;
    } else {
      to.set(lane, value);
    }
  }
  template <typename Vector>
  static void put_all(int lane, const double* from, Vector& to) {
    for (Eigen::Index i = 0; i < to.size(); ++i) put(lane, from[i], to[i]);
  }
  static double get([[maybe_unused]] int lane, const T& from) {
    if constexpr (std::is_same_v<T, double>) {
      return from;
    } else {
      return from[lane];
    }
  }
  /// Writes the numbers of a vector or of a matrix, column by column.
  template <typename Matrix>
  static void get_all(int lane, const Matrix& from, double* to) {
    for (Eigen::Index i = 0; i < from.size(); ++i) to[i] = get(lane, from.data()[i]);
  }

  static void mark([[maybe_unused]] int lane, bool value, MaskT<T>& to) {
    if constexpr (std::is_same_v<MaskT<T>, bool>) {
      to = value;
    } else {
      to[lane] = value ? -1 : 0;
    }
  }
  static bool is_marked([[maybe_unused]] int lane, const MaskT<T>& mask) {
    if constexpr (std::is_same_v<MaskT<T>, bool>) {
      return mask;
    } else {
      return mask[lane] != 0;
    }
  }
  static MaskT<T> both(const MaskT<T>& a, const MaskT<T>& b) {
    if constexpr (std::is_same_v<MaskT<T>, bool>) {
      return a && b;
    } else {
      return a & b;
    }
  }
  static MaskT<T> either(const MaskT<T>& a, const MaskT<T>& b) {
    if constexpr (std::is_same_v<MaskT<T>, bool>) {
      return a || b;
    } else {
      return a | b;
    }
  }
  static MaskT<T> no(const MaskT<T>& a) {
    if constexpr (std::is_same_v<MaskT<T>, bool>) {
      return !a;
    } else {
      return ~a;
    }
  }

  /// Returns x within low .. high.
  static T clamped(const T& x, const T& low, const T& high) {
    return select(x < low, low, select(high < x, high, x));
  }
};

}  // namespace armtune::internal
