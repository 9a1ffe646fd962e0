#include "core/trajectory/harmonic_path.hpp"

#include <cmath>

namespace armtune {

MotionPoint<Vec3> HarmonicPath::at(double t) const {
  MotionPoint<Vec3> point{center, Vec3::Zero(), Vec3::Zero()};
  for (const HarmonicTerm& term : terms) {
    const double kw = term.order * frequency;
    const double angle = term.order * (frequency * t + phase);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const Vec3 wave = term.cosine * c + term.sine * s;
    point.position += wave;
    point.velocity += kw * (term.sine * c - term.cosine * s);
    point.acceleration -= kw * kw * wave;
  }
  return point;
}

}  // namespace armtune
