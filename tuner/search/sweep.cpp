#include "tuner/search/sweep.hpp"

namespace armtune::internal {

std::vector<std::vector<double>> sweep_points(const Study& study) {
  std::vector<std::vector<double>> points;
  if (study.sweep.empty()) return points;
  std::vector<std::size_t> index(study.sweep.size(), 0);
  for (bool more = true; more;) {
    Gains gains = study.space.start;
    for (std::size_t a = 0; a < index.size(); ++a) {
      for (const std::size_t p : study.sweep[a].parameters) {
        value(gains, study.space.free[p].entry) *= study.sweep[a].factors[index[a]];
      }
    }
    points.push_back(study.space.point_of(gains));
    more = false;
    for (std::size_t a = 0; a < index.size() && !more; ++a) {
      more = ++index[a] < study.sweep[a].factors.size();
      if (!more) index[a] = 0;
    }
  }
  return points;
}

}  // namespace armtune::internal
