#pragma once

#include <console_bridge/console.h>

#include <string>

namespace armtune::internal::test {

/// Collects the errors that urdfdom logs while this object lives, and then restores the handler that it
/// found.
class UrdfdomErrors : public console_bridge::OutputHandler {
 public:
  UrdfdomErrors() : found_(console_bridge::getOutputHandler()) { console_bridge::useOutputHandler(this); }
  ~UrdfdomErrors() override {
    // Twice, because console_bridge also remembers the previous handler, which must not be this object.
    console_bridge::useOutputHandler(found_);
    console_bridge::useOutputHandler(found_);
  }
  UrdfdomErrors(const UrdfdomErrors&) = delete;
  UrdfdomErrors& operator=(const UrdfdomErrors&) = delete;
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) text_ += text;
  }
  /// The messages one after the other; empty if there was none.
  const std::string& text() const { return text_; }

 private:
  console_bridge::OutputHandler* found_;
  std::string text_;
};

}  // namespace armtune::internal::test
