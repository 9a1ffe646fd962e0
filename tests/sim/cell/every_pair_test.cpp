// The distance of every pair of an arm and its cell, compared with one that is computed from corners, edges
// and triangles alone.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/cell/hull.hpp"
#include "tests/sim/cell/busy_cell.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace every_pair_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// All points within `radius` of the convex hull of `corners`, in some frame. A capsule has no triangles.
struct Polytope {
  std::vector<Vec3> corners;
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<std::array<std::size_t, 3>> triangles;
  double radius = 0.0;
};

Polytope segment(double radius, double length) {
  return {{Vec3(0.0, 0.0, -0.5 * length), Vec3(0.0, 0.0, 0.5 * length)}, {{0, 1}}, {}, radius};
}

/// Corner k has the sign of bit i on axis i.
Polytope cuboid(const Vec3& edges) {
  Polytope made;
  for (std::size_t k = 0; k < 8; ++k) {
    const auto sign = [k](std::size_t bit) { return (k >> bit & 1U) != 0 ? 0.5 : -0.5; };
    made.corners.push_back(edges.cwiseProduct(Vec3(sign(0), sign(1), sign(2))));
    for (std::size_t bit = 0; bit < 3; ++bit) {
      const std::size_t other = k | std::size_t{1} << bit;
      if (other != k) made.edges.push_back({k, other});
      // The two faces across this axis, as two triangles each, from their first and their last corner.
      const std::size_t one = std::size_t{1} << (bit + 1) % 3, two = std::size_t{1} << (bit + 2) % 3;
      if ((k & (one | two)) != 0) continue;
      made.triangles.push_back({k, k | one, k | one | two});
      made.triangles.push_back({k, k | two, k | one | two});
    }
  }
  return made;
}

/// Corners 2 i and 2 i + 1 lie on axis i.
Polytope octahedron(const Vec3& half) {
  Polytope made;
  for (int i = 0; i < 3; ++i) {
    for (const double sign : {-1.0, 1.0}) made.corners.push_back(sign * half[i] * Vec3::Unit(i));
  }
  for (std::size_t a = 0; a < 6; ++a) {
    for (std::size_t b = a + 1; b < 6; ++b) {
      if (b / 2 != a / 2) made.edges.push_back({a, b});
    }
  }
  for (std::size_t k = 0; k < 8; ++k)
    made.triangles.push_back({k & 1U, 2 + (k >> 1 & 1U), 4 + (k >> 2 & 1U)});
  return made;
}

Polytope moved(Polytope made, const Mat3& R, const Vec3& p) {
  for (Vec3& corner : made.corners) corner = p + R * corner;
  return made;
}

/// The least of |a0 + s da - b0 - t db|^2 over s, t in [0, 1]: the quadratic program of two segments, solved
/// by going through every set of active bounds.
double least_between(const Vec3& a0, const Vec3& da, const Vec3& b0, const Vec3& db) {
  const auto at = [&](double s, double t) { return (a0 + s * da - b0 - t * db).norm(); };
  double least = kInfinity;
  for (const double end : {0.0, 1.0}) {
    least = std::min(least, at(end, std::clamp((a0 + end * da - b0).dot(db) / db.squaredNorm(), 0.0, 1.0)));
    least = std::min(least, at(std::clamp((b0 + end * db - a0).dot(da) / da.squaredNorm(), 0.0, 1.0), end));
  }
  Eigen::Matrix2d H;
  H << da.dot(da), -da.dot(db), -da.dot(db), db.dot(db);
  const Eigen::Vector2d free = H.fullPivLu().solve(Eigen::Vector2d(-da.dot(a0 - b0), db.dot(a0 - b0)));
  if (free.minCoeff() >= 0.0 && free.maxCoeff() <= 1.0) least = std::min(least, at(free[0], free[1]));
  return least;
}

/// Distance of a point from the plane of a triangle; infinite if it is not above the triangle.
double above(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
  Mat3 frame;
  frame << b - a, c - a, (b - a).cross(c - a).normalized();
  const Vec3 local = frame.inverse() * (point - a);
  const bool inside = local.x() >= 0.0 && local.y() >= 0.0 && local.x() + local.y() <= 1.0;
  return inside ? std::abs(local.z()) : kInfinity;
}

/// True if a plane separates the hulls of the corners: one across a triangle, or along an edge of each (the
/// separating axis theorem). Two segments count as separated.
bool are_apart(const Polytope& a, const Polytope& b) {
  if (a.triangles.empty() && b.triangles.empty()) return true;
  std::vector<Vec3> axes;
  for (const Polytope* one : {&a, &b}) {
    const auto& c = one->corners;
    for (const auto& [i, j, k] : one->triangles) axes.push_back((c[j] - c[i]).cross(c[k] - c[i]));
  }
  for (const auto& [i, j] : a.edges) {
    for (const auto& [k, l] : b.edges)
      axes.push_back((a.corners[j] - a.corners[i]).cross(b.corners[l] - b.corners[k]));
  }
  return std::any_of(axes.begin(), axes.end(), [&](const Vec3& axis) {
    double lower_a = kInfinity, upper_a = -kInfinity, lower_b = kInfinity, upper_b = -kInfinity;
    for (const Vec3& corner : a.corners) {
      lower_a = std::min(lower_a, axis.dot(corner));
      upper_a = std::max(upper_a, axis.dot(corner));
    }
    for (const Vec3& corner : b.corners) {
      lower_b = std::min(lower_b, axis.dot(corner));
      upper_b = std::max(upper_b, axis.dot(corner));
    }
    return lower_a > upper_b || lower_b > upper_a;
  });
}

/// Distance of bodies that are apart: that of the nearest edges, or of a corner and a triangle, without the
/// radii.
double distance_between(const Polytope& a, const Polytope& b) {
  double least = kInfinity;
  for (const auto& [i, j] : a.edges) {
    for (const auto& [k, l] : b.edges) {
      least = std::min(least, least_between(a.corners[i], a.corners[j] - a.corners[i], b.corners[k],
                                            b.corners[l] - b.corners[k]));
    }
  }
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const auto& [i, j, k] : one->triangles) {
      for (const Vec3& corner : other->corners)
        least = std::min(least, above(corner, one->corners[i], one->corners[j], one->corners[k]));
    }
  }
  return least - a.radius - b.radius;
}

const Vec3 kRock(0.09, 0.06, 0.12);  // m

/// A bundled arm of capsules with a box at its tool, and a mesh on its third link.
std::shared_ptr<const RobotModel> mixed_arm(const std::string& name, const test::TemporaryFolder& folder) {
  RobotModel arm = *load_robot(name);
  arm.source = folder / "arm.urdf";
  std::string obj;
  const Polytope rock = octahedron(kRock);
  for (const Vec3& c : rock.corners) obj += fmt::format("v {} {} {}\n", c.x(), c.y(), c.z());
  for (const auto& [i, j, k] : rock.triangles) obj += fmt::format("f {} {} {}\n", i + 1, j + 1, k + 1);
  folder.write("rock.obj", obj);
  Shape mesh;
  mesh.body = 2;
  const auto of_body = std::find_if(arm.shapes.begin(), arm.shapes.end(),
                                    [](const Shape& shape) { return shape.collision && shape.body == 2; });
  mesh.link = of_body->link;
  mesh.link_name = of_body->link_name;
  mesh.collision = true;
  mesh.kind = ShapeKind::kMesh;
  mesh.size = Vec3::Ones();
  mesh.file = "rock.obj";
  mesh.p_BS = of_body->p_BS;
  arm.shapes.push_back(mesh);
  Shape block;
  block.body = arm.n() - 1;
  block.link = arm.shapes.back().link;
  block.link_name = arm.joints.back().link;
  for (const Shape& shape : arm.shapes) {
    if (shape.link_name == block.link_name) block.link = shape.link;
  }
  block.collision = true;
  block.kind = ShapeKind::kBox;
  block.size = {0.08, 0.1, 0.05};
  block.p_BS = arm.chain.p_BT;
  arm.shapes.push_back(block);
  return std::make_shared<const RobotModel>(std::move(arm));
}

/// A solid of the arm, from the shape that it was made of.
Polytope of_arm(const RobotModel& arm, const ArmSolid& solid, const Poses& poses) {
  const auto shape = std::find_if(arm.shapes.begin(), arm.shapes.end(), [&](const Shape& one) {
    return one.collision && one.link_name == solid.link && one.p_BS == solid.placed.p_BS &&
           (one.kind == ShapeKind::kMesh) == (solid.placed.solid.kind == SolidKind::kHull);
  });
  if (shape == arm.shapes.end()) {
    ADD_FAILURE() << "no shape of " << solid.link;
    return segment(1.0, 1.0);
  }
  const Polytope made = shape->kind == ShapeKind::kMesh  ? octahedron(kRock)
                        : shape->kind == ShapeKind::kBox ? cuboid(shape->size)
                                                         : segment(shape->size[0], shape->size[1]);
  const auto k = static_cast<std::size_t>(std::max(shape->body, 0));
  const Mat3 R = shape->body < 0 ? Mat3(Mat3::Identity()) : poses.R_0B[k];
  const Vec3 p = shape->body < 0 ? Vec3(Vec3::Zero()) : poses.p_0B[k];
  return moved(made, R * shape->R_BS, p + R * shape->p_BS);
}

struct OwnCell {
  Cell cell;
  std::vector<Polytope> parts;
};

/// A table, a post and an octahedron that stands tilted, above a floor.
OwnCell own_cell() {
  OwnCell own;
  own.cell.floor = -0.3;
  const auto add = [&own](const std::string& name, const Solid& solid, const Polytope& made, const Vec3& p) {
    const Mat3 R(Eigen::AngleAxisd(0.4, Vec3(1.0, 2.0, 3.0).normalized()));
    CellPart part = test::part(name, solid, p);
    part.R_0S = R;
    own.cell.parts.push_back(part);
    own.parts.push_back(moved(made, R, p));
  };
  add("table", box({0.6, 0.8, 0.05}), cuboid({0.6, 0.8, 0.05}), {0.7, 0.0, -0.1});
  add("post", capsule(0.05, 1.0), segment(0.05, 1.0), {-0.5, 0.4, 0.3});
  const Polytope rock = octahedron({0.2, 0.3, 0.25});
  add("rock", convex_hull(rock.corners).value(), rock, {0.1, -0.6, 0.5});
  return own;
}

// Where the bodies' cores meet, the sign alone is compared: how deep they do is not defined.
TEST(EveryPair, HasTheDistanceOfItsNearestCornersEdgesAndTriangles) {
  const test::TemporaryFolder folder;
  std::mt19937 generator(18);
  const OwnCell own = own_cell();
  std::array<long, kClearances> apart{}, met{};
  for (const char* name : {"ur5e", "fr3", "iiwa14"}) {
    const auto arm = mixed_arm(name, folder);
    const ClearanceModel model(arm, own.cell);
    ASSERT_TRUE(model.arm().unread.empty()) << model.arm().unread[0];
    for (int sample = 0; sample < 1000; ++sample) {
      const JointVector q = test::random_configuration(generator, *arm);
      const Poses poses = test::poses_at(arm->chain, q);
      std::vector<Polytope> bodies;
      for (const ArmSolid& solid : model.arm().solids) bodies.push_back(of_arm(*arm, solid, poses));
      for (const ContactPair& pair : model.pairs()) {
        const double found = model.distance(pair, poses, test::place_of(model, pair, 0.0)).distance;
        const Polytope& body = bodies[pair.solid];
        const auto kind = static_cast<std::size_t>(pair.of);
        if (pair.of == Clearance::kFloor) {
          double lowest = kInfinity;
          for (const Vec3& corner : body.corners) lowest = std::min(lowest, corner.z());
          EXPECT_NEAR(found, lowest - body.radius + 0.3, 1e-6) << name << ", " << model.name(pair);
          (found > 0.0 ? apart : met)[kind] += 1;
          continue;
        }
        const Polytope& other = pair.of == Clearance::kSelf ? bodies[pair.other] : own.parts[pair.other];
        if (are_apart(body, other)) {
          EXPECT_NEAR(found, distance_between(body, other), 1e-6) << name << ", " << model.name(pair);
        } else {
          EXPECT_LT(found, 1e-6) << name << ", " << model.name(pair);
        }
        (found > 0.0 ? apart : met)[kind] += 1;
      }
    }
  }
  for (std::size_t kind = 0; kind < kClearances; ++kind) {
    EXPECT_GT(apart[kind], 1000) << kind;
    EXPECT_GT(met[kind], 100) << kind;
  }
}

TEST(EveryPair, OfLinksThatAreNotNeighboursIsLookedAt) {
  for (const char* name : {"ur5e", "fr3", "iiwa14"}) {
    const auto arm = load_robot(name);
    const ClearanceModel model(arm, Cell{});
    for (const Shape& a : arm->shapes) {
      for (const Shape& b : arm->shapes) {
        if (!a.collision || !b.collision || b.body - a.body < 2) continue;
        EXPECT_TRUE(std::any_of(model.pairs().begin(), model.pairs().end(),
                                [&](const ContactPair& pair) {
                                  return model.arm().solids[pair.other].link == a.link_name &&
                                         model.arm().solids[pair.solid].link == b.link_name;
                                }))
            << a.link_name << ", " << b.link_name;
      }
    }
  }
}

}  // namespace every_pair_test
}  // namespace armtune::internal
