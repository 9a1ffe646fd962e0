#pragma once
// NumPy arrays of numbers that C++ holds, without a copy.

#include <pybind11/numpy.h>

#include <memory>
#include <vector>

namespace armtune::internal::python {

/// An array of these extents that owns the vector, which is moved from.
template <class Value>
pybind11::array_t<Value> owning(std::vector<Value> values, std::vector<pybind11::ssize_t> extents) {
  auto* kept = new std::vector<Value>(std::move(values));
  const pybind11::capsule owner(kept, [](void* held) { delete static_cast<std::vector<Value>*>(held); });
  return pybind11::array_t<Value>(std::move(extents), kept->data(), owner);
}

/// Every `step`-th of `count` numbers of an object that the array keeps alive.
inline pybind11::array view(const double* first, std::size_t count, std::size_t step, pybind11::handle owner,
                            bool writable) {
  pybind11::array_t<double> array({static_cast<pybind11::ssize_t>(count)},
                                  {static_cast<pybind11::ssize_t>(step * sizeof(double))}, first, owner);
  if (!writable) array.attr("setflags")(pybind11::arg("write") = false);
  return array;
}

}  // namespace armtune::internal::python
