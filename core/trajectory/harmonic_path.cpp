#include "core/trajectory/harmonic_path.hpp"

#include "core/common/joint_math.hpp"

namespace armtune {

MotionPoint<Vec3> HarmonicPath::at(double t) const {
  MotionPoint<Vec3> point{center, Vec3::Zero(), Vec3::Zero()};
  for (const HarmonicTerm& term : terms) {
    const double kw = term.order * frequency;
    const double angle = term.order * (frequency * t + phase);
    double s = 0.0;
    double c = 0.0;
    sine_and_cosine(angle, s, c);
    const Vec3 wave = term.cosine * c + term.sine * s;
    point.position += wave;
    point.velocity += kw * (term.sine * c - term.cosine * s);
    point.acceleration -= kw * kw * wave;
  }
  return point;
}

}  // namespace armtune
