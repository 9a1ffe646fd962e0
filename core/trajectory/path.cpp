#include "core/trajectory/path.hpp"

#include <cmath>

#include "core/common/joint_math.hpp"

namespace armtune::internal {
namespace {

double spline_time(const Path& path, double t) {
  return path.spline_rate * t + path.spline_lead;
}

/// Computes the sine and cosine of a term at t [s].
void turn(const Path& path, const HarmonicTerm& term, double t, double& s, double& c) {
  sine_and_cosine(term.order * (path.frequency * t + path.phase), s, c);
}

}  // namespace

MotionPoint<Vec3> Path::at(double t) const {
  MotionPoint<Vec3> point{center, Vec3::Zero(), Vec3::Zero()};
  if (spline) {
    point = spline->at(spline_time(*this, t));
    point.position += center;
    point.velocity *= spline_rate;
    point.acceleration *= spline_rate * spline_rate;
  }
  for (const HarmonicTerm& term : terms) {
    const double kw = term.order * frequency;
    double s = 0.0;
    double c = 0.0;
    turn(*this, term, t, s, c);
    const Vec3 wave = term.cosine * c + term.sine * s;
    point.position += wave;
    point.velocity += kw * (term.sine * c - term.cosine * s);
    point.acceleration -= kw * kw * wave;
  }
  return point;
}

Vec3 Path::jerk(double t) const {
  Vec3 jerk = Vec3::Zero();
  if (spline) jerk = std::pow(spline_rate, 3) * spline->jerk(spline_time(*this, t));
  for (const HarmonicTerm& term : terms) {
    const double kw = term.order * frequency;
    double s = 0.0;
    double c = 0.0;
    turn(*this, term, t, s, c);
    jerk += kw * kw * kw * (term.cosine * s - term.sine * c);
  }
  return jerk;
}

double Path::period() const {
  if (spline) return spline->loops() ? (spline->end() - spline->begin()) / spline_rate : 0.0;
  return rests() ? 0.0 : 2.0 * M_PI / std::abs(frequency);
}

}  // namespace armtune::internal
