#include "core/robot/link_inertias.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "armtune/error.hpp"
#include "core/robot/body_inertia.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {
namespace {

/// Tolerance for a negative moment of inertia, as a share of the largest one about the link's origin. A thin
/// rod's smallest moment can become negative by rounding when the author of a file rotates or shifts it.
constexpr double kRounding = 1e-12;

/// Returns the inertia about the centre of mass as that of a body of 1 kg, since the given mass may be wrong.
LinkInertia about_center(const GivenInertia& given) {
  return {1.0, Vec3::Zero(), given.about_center};
}

/// Returns the smallest moment that the file gives if it is negative; 0 if none is.
double negative_moment(const UrdfInertial& given) {
  const double least = given.about_center.diagonal().minCoeff();
  const double largest = given.about_center.diagonal().maxCoeff() + given.mass * given.p_LC.squaredNorm();
  return least < -kRounding * largest ? least : 0.0;
}

void add_to(LinkInertia& body, const LinkInertia& in_B) {
  body.mass += in_B.mass;
  body.first_moment += in_B.first_moment;
  body.inertia += in_B.inertia;
}

}  // namespace

LinkInertia in_link_frame(const GivenInertia& told) {
  return in_frame({told.mass, Vec3::Zero(), told.about_center}, Mat3::Identity(), told.center);
}

void add_to_body(const LinkInertia& in_L, const Site& site, Chain& chain) {
  add_to(chain.link[static_cast<std::size_t>(site.body)], in_frame(in_L, site.R_BL, site.p_BL));
}

void LinkInertias::add(const UrdfLink& link, const Site& site, Chain& chain) {
  const UrdfInertial& given = *link.inertial;
  parts_.push_back({link.name,
                    site,
                    in_frame({given.mass, Vec3::Zero(), given.about_center}, given.R_LC, given.p_LC),
                    {given.mass, given.p_LC, given.R_LC * given.about_center * given.R_LC.transpose()},
                    negative_moment(given)});
  add_to_body(parts_.back().in_L, site, chain);
}

void LinkInertias::add(const std::string& link, const GivenInertia& given, const Site& site, Chain& chain) {
  parts_.push_back({link, site, in_link_frame(given), given, 0.0});
  add_to_body(parts_.back().in_L, site, chain);
}

std::string LinkInertias::negative_value(const Part& part) {
  if (part.given.mass < 0.0) return fmt::format("mass {:.6g} kg", part.given.mass);
  if (part.negative_moment < 0.0) return fmt::format("moment {:.6g} kg m^2", part.negative_moment);
  return {};
}

std::string LinkInertias::impossible_moments(const Part& part) {
  if (!(part.in_L.mass > 0.0) || is_physical(part.in_L)) return {};
  const Vec3 moments = principal_moments(part.in_L);
  return fmt::format("principal moments {:.4g}, {:.4g}, {:.4g} kg m^2", moments[0], moments[1], moments[2]);
}

ImpossibleInertia LinkInertias::proposal(const Part& part, std::string fault) {
  ImpossibleInertia found{part.link, part.site.body, std::move(fault), part.given, 0.0};
  found.nearest.mass = std::max(0.0, part.given.mass);
  const LinkInertia given = about_center(part.given);
  const bool keeps_moments = part.given.mass < 0.0 && is_physical(given);
  if (!keeps_moments) found.nearest.about_center = nearest_physical(given).inertia;
  if (found.has_moments())
    found.moved = (found.nearest.about_center - given.inertia).norm() / given.inertia.norm();
  return found;
}

std::vector<ImpossibleInertia> LinkInertias::replace_impossible(int i, JointMotion motion,
                                                                LinkInertia& body) const {
  std::vector<ImpossibleInertia> found;
  std::vector<const Part*> possible;
  for (const Part& part : parts_) {
    if (part.site.body == i) possible.push_back(&part);
  }
  const auto replace_where = [&](const auto& fault_of) {
    for (const Part*& part : possible) {
      std::string fault = part == nullptr ? std::string() : fault_of(*part);
      if (fault.empty()) continue;
      found.push_back(proposal(*part, std::move(fault)));
      const LinkInertia placeholder{1.0, Vec3::Zero(), Mat3::Identity()};
      const LinkInertia now = found.back().is_complete() ? in_link_frame(found.back().nearest) : placeholder;
      const LinkInertia change{now.mass - part->in_L.mass, now.first_moment - part->in_L.first_moment,
                               now.inertia - part->in_L.inertia};
      add_to(body, in_frame(change, part->site.R_BL, part->site.p_BL));
      part = nullptr;
    }
  };
  replace_where(negative_value);
  if (!(body.mass > 0.0) || !body.inertia.allFinite()) return found;
  if (!is_physical(body)) replace_where(impossible_moments);
  if (motion == JointMotion::kRevolute && !has_inertia_about_axis(body)) {
    replace_where([](const Part& part) {
      return std::string(part.in_L.mass > 0.0 ? "no inertia about the axis of its joint" : "");
    });
  }
  return found;
}

void LinkInertias::judge(Chain& chain, const std::string& source, MissingData* missing) const {
  std::string named;
  std::optional<ImpossibleInertia> first;
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    LinkInertia body = chain.link[k];
    for (ImpossibleInertia& link : replace_impossible(i, chain.motion[k], body)) {
      named += fmt::format("{}{} ({})", named.empty() ? "" : ", ", link.link, link.fault);
      if (!first) first = link;
      if (missing == nullptr) continue;
      missing->impossible.push_back(std::move(link));
      chain.link[k] = body;
    }
  }
  if (missing != nullptr || !first) return;
  throw InputError(
      InputPlace{source, 0, first->link + "/inertia"},
      fmt::format(
          "no moving link can have this inertia: {}. No mass or moment may be negative, no principal moment may "
          "be larger than the sum of the other two (triangle inequality), and a link needs inertia about the "
          "axis of its joint. 'armtune robot {} --sidecar arm.yaml' proposes the nearest possible values, "
          "and leaves a gap for you to fill in where there are none",
          named, source))
      .with_value(first->fault, "the inertia of a rigid body");
}

}  // namespace armtune::internal
