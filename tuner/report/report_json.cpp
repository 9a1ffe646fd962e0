#include "tuner/record/json_writer.hpp"
#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

std::string report_json(const ReportData& data) {
  return record::json_of(data);
}

}  // namespace armtune::internal::report
