#include "core/trajectory/path.hpp"

#include <cmath>

#include "core/common/joint_math.hpp"

namespace armtune {

MotionPoint<Vec3> Path::at(double t) const {
  MotionPoint<Vec3> point{center, Vec3::Zero(), Vec3::Zero()};
  if (spline) {
    point = spline->at(spline_rate * t + spline_lead);
    point.position += center;
    point.velocity *= spline_rate;
    point.acceleration *= spline_rate * spline_rate;
  }
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

double Path::period() const {
  if (spline) return spline->loops() ? (spline->end() - spline->begin()) / spline_rate : 0.0;
  return rests() ? 0.0 : 2.0 * M_PI / std::abs(frequency);
}

}  // namespace armtune
