#include "tuner/identification/excitation_clearance.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

constexpr double kLinksApart = 0.005;  // m
constexpr std::array<std::pair<Clearance, const char*>, kClearances> kClearanceNames = {
    {{Clearance::kSelf, "between links"},
     {Clearance::kCell, "from the parts of the cell"},
     {Clearance::kFloor, "from the floor"}}};

/// Returns a copy with all amplitudes multiplied by `factor`.
Excitation scaled_excitation(const Excitation& excitation, double factor) {
  Excitation scaled = excitation;
  scaled.sine *= factor;
  scaled.cosine *= factor;
  return scaled;
}

}  // namespace

std::vector<double> KeptDistances::least(const JointVector& center, double spare) const {
  PairDistances distances(model);
  distances.move_to(0.0, center);
  const auto& pairs = model->pairs();
  std::vector<double> all(pairs.size(), clearance + spare);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (pairs[k].of != Clearance::kSelf) continue;
    const double half = std::max(0.0, 0.5 * distances.compute(k).distance);
    all[k] = std::min({kLinksApart + spare, clearance + spare, half});
  }
  return all;
}

DistanceTally::DistanceTally(const KeptDistances& kept, const JointVector& center, double spare) {
  if (!kept.model) return;
  distances_.emplace(kept.model);
  least_ = kept.least(center, spare);
}

void DistanceTally::see(double time, const JointVector& q) {
  if (!distances_) return;
  distances_->move_to(time, q);
  bool is_near = false;
  for (std::size_t k = 0; k < least_.size(); ++k) {
    if (distances_->at_least(k, least_[k])) continue;
    const double distance = distances_->compute(k).distance;
    if (distance >= least_[k]) continue;
    is_near = true;
    most_ = std::max(most_, 1.0 - distance / least_[k]);
  }
  ++seen_;
  if (is_near) ++near_;
}

double DistanceTally::shortfall() const {
  if (near_ == 0) return 0.0;
  // Overlaps of hulls have no depth, so all overlaps count alike.
  return std::min(1.0, most_) + static_cast<double>(near_) / static_cast<double>(seen_);
}

DistancesAlong distances_along(const Excitation& excitation, const KeptDistances& kept) {
  if (!kept.model) return {};
  ClearanceWatch watch(kept.model, kept.least(excitation.center));
  const long samples = std::lround(excitation.duration / kDistancePeriod);
  for (long k = 0; k <= samples; ++k) {
    const double t = static_cast<double>(k) * kDistancePeriod;
    const JointVector q = excitation.at(t).position;
    watch.see(t, q);
  }
  return {watch.least(), watch.too_near()};
}

void check_distances_at(const JointVector& center, const KeptDistances& kept) {
  if (!kept.model) return;
  PairDistances distances(kept.model);
  distances.move_to(0.0, center);
  const auto& pairs = kept.model->pairs();
  std::vector<LeastClearance> too_near;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double distance = distances.compute(k).distance;
    const bool keeps = pairs[k].of == Clearance::kSelf ? distance > 0.0 : distance >= kept.clearance;
    if (!keeps) too_near.push_back({distance, 0.0, &pairs[k]});
  }
  if (too_near.empty()) return;
  throw InputError(
      InputPlace{.key = "center"},
      fmt::format("at the centre of the trajectory, {}; move the centre, or give another --clearance",
                  too_near_clause(too_near, kept)));
}

Excitation shrunk_to_keep(const Excitation& excitation, const KeptDistances& kept) {
  constexpr int kBisections = 10;
  if (distances_along(excitation, kept).too_near.empty()) return excitation;
  double keeps = 0.0;
  double too_large = 1.0;
  for (int k = 0; k < kBisections; ++k) {
    const double factor = 0.5 * (keeps + too_large);
    (distances_along(scaled_excitation(excitation, factor), kept).too_near.empty() ? keeps : too_large) =
        factor;
  }
  return scaled_excitation(excitation, keeps);
}

std::string too_near_clause(const std::vector<LeastClearance>& too_near, const KeptDistances& kept) {
  std::vector<std::string> clauses;
  clauses.reserve(too_near.size());
  for (const LeastClearance& found : too_near) {
    const std::string pair = kept.model->name(*found.pair);
    clauses.push_back(found.distance > 0.0 ? fmt::format("{} come within {:.2g} m of each other at {:.2f} s",
                                                         pair, found.distance, found.time)
                                           : fmt::format("{} touch at {:.2f} s", pair, found.time));
  }
  return fmt::format("{}", fmt::join(clauses, "; "));
}

std::string contact_sentences(const LeastClearances& nearest, const KeptDistances& kept) {
  if (!kept.model) return "Contact of the arm with itself and its surroundings was not checked.";
  const ClearanceModel& model = *kept.model;
  std::vector<std::string> found;
  for (const auto& [kind, name] : kClearanceNames) {
    const LeastClearance& least = least_of(kind, nearest);
    if (least.pair == nullptr) continue;
    found.push_back(fmt::format("{} {:.3g} m ({}, at {:.2f} s)", name, least.distance,
                                model.name(*least.pair), least.time));
  }
  std::string text;
  if (!found.empty()) {
    text = fmt::format("Smallest distances along the trajectory, computed every {:g} ms: {}.",
                       1e3 * kDistancePeriod, fmt::join(found, "; "));
  }
  std::vector<std::string> missing;
  if (!model.has(Clearance::kSelf)) missing.emplace_back("contact between links");
  if (!model.has(Clearance::kCell) && !model.has(Clearance::kFloor))
    missing.emplace_back("contact with the surroundings, as no cell is known");
  if (const auto& unknown = model.arm().unknown; !unknown.empty())
    missing.push_back(fmt::format("{}, whose shapes are not known", fmt::join(unknown, ", ")));
  if (const auto drawn = drawn_links(model.arm()); !drawn.empty())
    missing.push_back(
        fmt::format("collision shapes of {}, which have only drawn (visual) shapes", fmt::join(drawn, ", ")));
  if (const auto left_out = model.left_out_by_their_make(); !left_out.empty())
    missing.push_back(
        fmt::format("{}, whose shapes touch at nearly every position", fmt::join(left_out, ", ")));
  missing.emplace_back("the motion to the centre, where the trajectory starts");
  return fmt::format("{}{}Not checked: {}.", text, text.empty() ? "" : " ", fmt::join(missing, "; "));
}

}  // namespace armtune::internal
