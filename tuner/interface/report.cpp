#include "armtune/report.hpp"

#include "tuner/report/report.hpp"

namespace armtune {

void write_report(const std::string& folder, const std::string& path) {
  internal::report::write_report(folder, path, internal::report::Existing::kRefuse);
}

}  // namespace armtune
