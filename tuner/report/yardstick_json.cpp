#include "tuner/report/yardstick_json.hpp"

namespace armtune::report {

void write_yardstick(Json& json, const YardstickRow& row) {
  json.begin_object();
  json.integer("set", static_cast<long>(row.set));
  json.text("scenario", row.scenario);
  json.text("event", row.event);
  json.number("time", row.time);
  json.number("reached", row.reached);
  json.number("limit", row.limit);
  json.number("ratio", row.ratio);
  json.text("unit", row.unit);
  json.text("held_back_by", row.held_back_by);
  json.text("words", row.words);
  json.end_object();
}

}  // namespace armtune::report
