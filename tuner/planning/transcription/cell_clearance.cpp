// Limits on the distances between links of the arm, and of links from the cell (arm_terms.hpp).

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "tuner/planning/transcription/joint_axis.hpp"
#include "tuner/planning/transcription/term_parts.hpp"

namespace armtune::internal {
namespace {

/// Returns the name of a pair's term. All pairs with the same part of the cell share one term.
std::string term_name(const ClearanceModel& model, const ContactPair& pair) {
  switch (pair.of) {
    case Clearance::kCell:
      return "distance to part " + model.cell().parts[pair.other].name;
    case Clearance::kFloor:
      return "distance to the floor";
    default:
      return "distance between links";
  }
}

LimitKind kind_of(const ContactPair& pair) {
  return pair.of == Clearance::kCell    ? LimitKind::kCellPart
         : pair.of == Clearance::kFloor ? LimitKind::kFloor
                                        : LimitKind::kLinks;
}

std::string row_name(const ClearanceModel& model, const ContactPair& pair) {
  const auto& solids = model.arm().solids;
  const std::string& link = solids[pair.solid].link;
  return pair.of == Clearance::kSelf ? fmt::format("{} and {}", link, solids[pair.other].link) : link;
}

/// Writes the distance of a pair divided by `radius`, and its derivatives.
class PairRow {
 public:
  PairRow(const ClearanceModel& model, const ContactPair& pair, double radius)
      : model_(model), pair_(pair), radius_(radius) {}

  void write(const Knot& knot, int row, const KnotRows& out) const {
    MotionPoint<Vec3> at{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    if (pair_.of == Clearance::kCell) at = model_.cell().parts[pair_.other].path.at(knot.time);
    const Closest closest = model_.distance(pair_, knot.poses, at.position);
    out.value[row] = closest.distance / radius_;
    if (out.by_q == nullptr) return;
    double* by_q = out.by_q + static_cast<std::ptrdiff_t>(row) * out.columns;
    add(knot, model_.arm().solids[pair_.solid].body, closest.on_a, closest.away / radius_, by_q);
    if (pair_.of == Clearance::kSelf)
      add(knot, model_.arm().solids[pair_.other].body, closest.on_b, -closest.away / radius_, by_q);
    out.by_time[row] = -closest.away.dot(at.velocity) / radius_;
  }

 private:
  /// Adds the derivatives of direction . p with respect to q, where p is a point of the body.
  void add(const Knot& knot, int body, const Vec3& p, const Vec3& direction, double* by_q) const {
    for (int j = 0; j <= body; ++j)
      by_q[j] += direction.dot(point_rate(axis_of(model_.robot().chain, knot.poses, j), p));
  }

  const ClearanceModel& model_;
  const ContactPair& pair_;
  double radius_;
};

}  // namespace

std::vector<KnotTerm> clear_of_cell(const std::shared_ptr<const ClearanceModel>& model, KnotRange knots,
                                    double radius) {
  std::map<std::string, std::vector<std::size_t>> by_name;
  const auto& pairs = model->pairs();
  for (std::size_t k = 0; k < pairs.size(); ++k) by_name[term_name(*model, pairs[k])].push_back(k);
  std::vector<KnotTerm> terms;
  for (const auto& entry : by_name) {
    const std::string& name = entry.first;
    const std::vector<std::size_t>& of_term = entry.second;
    std::vector<std::string> rows;
    std::map<std::string, int> used;
    for (const std::size_t k : of_term) {
      // A link that consists of several bodies has one row for each of them.
      std::string row = row_name(*model, pairs[k]);
      if (const int count = ++used[row]; count > 1) row += fmt::format(" ({})", count);
      rows.push_back(std::move(row));
    }
    const LimitKind kind = kind_of(pairs[of_term.front()]);
    const double kept = kind == LimitKind::kLinks ? std::min(radius, kBetweenLinks) : radius;
    KnotTerm term = over(knots, name, rows);
    term.kind = kind;
    in_meters(1.0 / kept, term);
    term.on_time = true;
    term.lower = 1.0;
    term.evaluate = [model, of_term, kept](const Knot& knot, const KnotRows& out) {
      if (out.by_q != nullptr)
        std::fill(out.by_q, out.by_q + static_cast<std::ptrdiff_t>(of_term.size()) * out.columns, 0.0);
      for (std::size_t i = 0; i < of_term.size(); ++i)
        PairRow(*model, model->pairs()[of_term[i]], kept).write(knot, static_cast<int>(i), out);
    };
    terms.push_back(std::move(term));
  }
  return terms;
}

}  // namespace armtune::internal
