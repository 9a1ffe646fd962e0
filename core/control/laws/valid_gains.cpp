#include "core/control/laws/valid_gains.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstring>

#include "armtune/error.hpp"
#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

void validate(const Gains& gains, const std::vector<std::string>& joints, const std::string& source) {
  const auto place = [&](const char* gain) { return InputPlace{source, 0, gain}; };
  for (const GainField& field : fields_of(gains)) {
    const auto values = numbers(gains, field);
    const auto names = component_names(gains, field, joints);
    const bool own = std::holds_alternative<OwnGain>(field.member);
    if (!field.required && !own && field.is_number() && values.empty()) continue;
    if (field.is_number() && values.size() != names.size()) {
      throw InputError(place(field.name),
                       fmt::format("{} has {} values, but the arm needs {}: {}", field.name, values.size(),
                                   names.size(), fmt::join(names, " ")))
          .with_value(std::to_string(values.size()), fmt::format("{} values", names.size()));
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool any_sign = std::strcmp(field.name, "joint_space_goal") == 0;
      const double v = values[i];
      if (!std::isfinite(v) || (!any_sign && (v < 0.0 || (field.strictly_positive && v == 0.0)))) {
        const std::string limit =
            fmt::format("finite and {}", field.strictly_positive ? "above zero" : "not negative");
        throw InputError(place(field.name), fmt::format("{}{}{} is {}; it must be {}", field.name,
                                                        names[i].empty() ? "" : "/", names[i], v, limit))
            .with_value(fmt::to_string(v), limit);
      }
      if (v >= field.below) {
        throw InputError(place(field.name),
                         fmt::format("{}{}{} is {}; it must be below {}", field.name,
                                     names[i].empty() ? "" : "/", names[i], v, field.below))
            .with_value(fmt::to_string(v), fmt::format("below {}", field.below));
      }
    }
  }
  if (gains.slerp_start_angle > gains.slerpAngularErrorThreshold) {
    throw InputError(
        place("slerp_start_angle"),
        fmt::format("slerp_start_angle is {} rad; it must be at most slerpAngularErrorThreshold = {} rad",
                    gains.slerp_start_angle, gains.slerpAngularErrorThreshold))
        .with_value(fmt::to_string(gains.slerp_start_angle),
                    fmt::format("at most {}", gains.slerpAngularErrorThreshold));
  }
  if (gains.release_radius != 0.0 && gains.release_radius < gains.obstacleInfluenceRadius) {
    throw InputError(place("release_radius"),
                     fmt::format("release_radius is {} m; it must be 0 or at least "
                                 "obstacleInfluenceRadius = {} m",
                                 gains.release_radius, gains.obstacleInfluenceRadius))
        .with_value(fmt::to_string(gains.release_radius),
                    fmt::format("0 or at least {}", gains.obstacleInfluenceRadius));
  }
}

}  // namespace armtune::internal
