#include "sim/cell/hull.hpp"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>

namespace armtune::internal {
namespace {

constexpr double kFlat = 1e-4;  // as a share of the extent: points with a smaller thickness have no hull

/// Returns the extent of the points along their thinnest direction [m].
double thickness(std::span<const Vec3> points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / static_cast<double>(points.size());
  Mat3 scatter = Mat3::Zero();
  for (const Vec3& p : points) scatter += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(scatter);
  const Vec3 thinnest = solver.eigenvectors().col(0);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Vec3& p : points) {
    low = std::min(low, thinnest.dot(p - mean));
    high = std::max(high, thinnest.dot(p - mean));
  }
  return high - low;
}

/// Computes one hull by Qhull, and owns Qhull's memory for it.
class Hull {
 public:
  /// coordinates: three per point; they must outlive this object. Facets are divided into triangles.
  explicit Hull(std::vector<double>& coordinates) {
    qh_zero(&qh_, nullptr);
    char options[] = "qhull Qt Pp";
    failed_ =
        nowhere_ == nullptr || qh_new_qhull(&qh_, 3, static_cast<int>(coordinates.size() / 3),
                                            coordinates.data(), False, options, nowhere_, nowhere_) != 0;
  }
  ~Hull() {
    if (nowhere_ == nullptr) return;
    qh_freeqhull(&qh_, qh_ALL);
    int more = 0;
    int memory = 0;
    qh_memfreeshort(&qh_, &more, &memory);
    std::fclose(nowhere_);
  }
  Hull(const Hull&) = delete;
  Hull& operator=(const Hull&) = delete;

  bool failed() const { return failed_; }

  /// Calls see(points, normal) for every triangle. points: indices of its points. normal: points outwards.
  template <typename See>
  void each_triangle(See&& see) {
    for (const facetT* facet = qh_.facet_list; facet != nullptr && facet->next != nullptr;
         facet = facet->next) {
      std::array<int, 3> points{};
      const int corners = qh_setsize(&qh_, facet->vertices);
      if (corners != 3) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        auto* vertex = static_cast<vertexT*>(SETelem_(facet->vertices, i));
        points[i] = qh_pointid(&qh_, vertex->point);
      }
      see(points, Vec3(facet->normal));
    }
  }

 private:
  std::FILE* nowhere_ = std::fopen("/dev/null", "w");  ///< discards Qhull's messages
  qhT qh_{};
  bool failed_ = false;
};

}  // namespace

std::optional<Solid> convex_hull(std::span<const Vec3> points) {
  if (points.size() < 4) return std::nullopt;
  Vec3 lower = points[0];
  Vec3 upper = points[0];
  for (const Vec3& p : points) {
    if (!p.allFinite()) return std::nullopt;
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  const Vec3 center = 0.5 * (lower + upper);
  const double extent = (upper - lower).norm();
  if (!(thickness(points) > kFlat * extent)) return std::nullopt;
  // The points are scaled to the size for which Qhull's tolerances are made.
  std::vector<double> scaled;
  scaled.reserve(3 * points.size());
  for (const Vec3& p : points) {
    const Vec3 x = (p - center) / extent;
    scaled.insert(scaled.end(), x.data(), x.data() + 3);
  }
  Hull found(scaled);
  if (found.failed()) return std::nullopt;
  Solid hull;
  hull.kind = SolidKind::kHull;
  std::map<int, int> number;  // index of a point -> index of its corner
  found.each_triangle([&](const std::array<int, 3>& of_points, const Vec3& outside) {
    std::array<int, 3> triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [place, is_new] = number.emplace(of_points[i], static_cast<int>(hull.corners.size()));
      if (is_new) hull.corners.push_back(points[static_cast<std::size_t>(of_points[i])]);
      triangle[i] = place->second;
    }
    const auto corner = [&](std::size_t k) -> const Vec3& {
      return hull.corners[static_cast<std::size_t>(triangle[k])];
    };
    const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    if (normal.dot(outside) < 0.0) std::swap(triangle[1], triangle[2]);
    hull.triangles.push_back(triangle);
  });
  return hull;
}

}  // namespace armtune::internal
