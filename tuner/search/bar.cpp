#include "tuner/search/bar.hpp"

#include <algorithm>

namespace armtune {
namespace {

/// NLopt's parents of ESCH, and of CRS2 per parameter and one.
constexpr std::size_t kEschParents = 40;
constexpr std::size_t kCrsPerParameter = 10;

}  // namespace

Bar::Bar(const std::string& algorithm, std::size_t parameters) {
  if (algorithm == "ESCH" || algorithm == "CRS2") {
    kind_ = Kind::kElite;
    size_ = algorithm == "ESCH" ? kEschParents : kCrsPerParameter * (parameters + 1);
  } else if (algorithm == "NELDERMEAD") {
    kind_ = Kind::kSimplex;
    size_ = parameters + 1;
  }
}

void Bar::told(double value) {
  if (kind_ == Kind::kSimplex) return told_simplex(value);
  if (kind_ == Kind::kNone) return;
  elite_.push(value);
  if (elite_.size() > size_) elite_.pop();
}

double Bar::now() const {
  if (kind_ == Kind::kElite && elite_.size() == size_) return elite_.top();
  if (kind_ != Kind::kSimplex) return HUGE_VAL;
  switch (step_) {
    case Step::kBuild:
      return HUGE_VAL;
    case Step::kReflect:
      return simplex_.back();
    case Step::kExpand:
    case Step::kContract:
      return std::min(reflected_, simplex_.back());
  }
  return HUGE_VAL;
}

void Bar::replace_worst(double value) {
  simplex_.pop_back();
  simplex_.insert(std::upper_bound(simplex_.begin(), simplex_.end(), value), value);
  step_ = Step::kReflect;
}

void Bar::told_simplex(double value) {
  switch (step_) {
    case Step::kBuild:
      simplex_.push_back(value);
      if (simplex_.size() < size_) return;
      std::sort(simplex_.begin(), simplex_.end());
      step_ = Step::kReflect;
      return;
    case Step::kReflect:
      reflected_ = value;
      if (value < simplex_.front()) {
        step_ = Step::kExpand;
      } else if (value < *(simplex_.end() - 2)) {
        replace_worst(value);
      } else {
        step_ = Step::kContract;
      }
      return;
    case Step::kExpand:
      replace_worst(std::min(value, reflected_));
      return;
    case Step::kContract:
      if (value < reflected_ && value < simplex_.back()) {
        replace_worst(value);
      } else {  // all but the best shrink towards it and are asked for anew
        simplex_.resize(1);
        step_ = Step::kBuild;
      }
      return;
  }
}

}  // namespace armtune
