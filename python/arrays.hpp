#pragma once
// Makes NumPy arrays that use numbers in the memory of C++ objects, without a copy.

#include <pybind11/numpy.h>

#include <memory>
#include <vector>

namespace armtune::internal::python {

/// Returns an array with the shape `extents`. It takes over the numbers of the vector.
template <class Value>
pybind11::array_t<Value> owning(std::vector<Value> values, std::vector<pybind11::ssize_t> extents) {
  auto* kept = new std::vector<Value>(std::move(values));
  const pybind11::capsule owner(kept, [](void* held) { delete static_cast<std::vector<Value>*>(held); });
  return pybind11::array_t<Value>(std::move(extents), kept->data(), owner);
}

/// Returns an array of `count` numbers in the memory of the object `owner`, which the array keeps alive. They
/// are the number at `first` and every `step`-th number after it.
inline pybind11::array view(const double* first, std::size_t count, std::size_t step, pybind11::handle owner,
                            bool writable) {
  pybind11::array_t<double> array({static_cast<pybind11::ssize_t>(count)},
                                  {static_cast<pybind11::ssize_t>(step * sizeof(double))}, first, owner);
  if (!writable) array.attr("setflags")(pybind11::arg("write") = false);
  return array;
}

}  // namespace armtune::internal::python
