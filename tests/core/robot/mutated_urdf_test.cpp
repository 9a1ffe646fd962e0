// 10,000 arms that something happened to: each is refused in one line, or is an arm that keeps its own rules
// and about which urdfdom had no error to log.

#include <urdf_parser/urdf_parser.h>

#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string_view>

#include "core/robot/dynamics.hpp"
#include "tests/core/support/urdf_text.hpp"
#include "tests/core/support/urdfdom_errors.hpp"

namespace armtune::internal {
namespace mutated_urdf_test {

/// One to three faults of the kinds that editors, scripts and transfers make.
class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  std::string operator()(std::string text) {
    for (std::size_t faults = 1 + below(3); faults > 0 && !text.empty(); --faults) mutate(text);
    return text;
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : std::size_t(random_() % n); }

  void mutate(std::string& text) {
    static const std::vector<std::string> kValues = {"nan", "inf",   "-1",     "0",    "1e400", "1,5",
                                                     "",    "0x10",  "1e-320", "${m}", "%n",    "a b c",
                                                     "-0",  "1e300", "&#37;",  "1 2",  "true"};
    const std::size_t at = below(text.size());
    switch (below(8)) {
      case 0:  // a byte
        text[at] = static_cast<char>(random_());
        break;
      case 1:  // a stretch lost
        text.erase(at, 1 + below(200));
        break;
      case 2:  // a stretch twice
        text.insert(at, text.substr(below(text.size()), 1 + below(400)));
        break;
      case 3:  // cut off
        text.resize(at);
        break;
      case 4:
      case 5:
      case 6: {  // the value of an attribute
        const auto [begin, end] = value_near(text, at);
        if (begin < end) text.replace(begin, end - begin, kValues[below(kValues.size())]);
        break;
      }
      default: {  // the value of another attribute
        const auto [begin, end] = value_near(text, at);
        const auto [from, to] = value_near(text, below(text.size()));
        if (begin < end && from < to) text.replace(begin, end - begin, text.substr(from, to - from));
      }
    }
  }

  static std::pair<std::size_t, std::size_t> value_near(const std::string& text, std::size_t at) {
    const std::size_t equals = text.find('=', at);
    if (equals == std::string::npos || equals + 1 >= text.size()) return {0, 0};
    const std::size_t end = text.find(text[equals + 1], equals + 2);
    return end == std::string::npos ? std::pair<std::size_t, std::size_t>{0, 0} : std::pair{equals + 2, end};
  }

  std::mt19937_64 random_;
};

class MutatedUrdf : public test::UrdfFiles {};

TEST_F(MutatedUrdf, TenThousandAreRefusedOrSound) {
  std::ifstream file(test::kUr10);
  const std::string ur10{std::istreambuf_iterator<char>(file), {}};
  const std::string small =
      test::robot(test::one_joint() + test::link("c") + test::joint("k", "prismatic", "b", "c"));
  Mutator mutated(7);
  int accepted = 0;
  constexpr int kAll = 10'000;
  for (int i = 0; i < kAll; ++i) {
    const std::string text = mutated(i % 5 == 0 ? small : ur10);
    const std::string path = write(text);
    RobotModel model;
    try {
      model = read_urdf(path);
    } catch (const InputError& error) {
      const std::string_view message = error.what();
      ASSERT_NE(message.find("arm.urdf"), std::string_view::npos) << message;
      ASSERT_EQ(message.find('\n'), std::string_view::npos) << message;
      ASSERT_LT(message.size(), 3000U);
      continue;
    }
    ++accepted;
    ASSERT_NO_THROW(validate(model)) << text;
    const test::UrdfdomErrors errors;
    ASSERT_TRUE(urdf::parseURDF(text)) << text;
    ASSERT_EQ(errors.text(), "") << text;
    Poses poses;
    const JointVector zero = JointVector::Zero(model.n());
    forward_kinematics(model.chain, zero, poses);
    JointVector torque;
    gravity_torque(model.chain, poses, torque);
    ASSERT_TRUE(torque.allFinite()) << text;
  }
  // Bytes of comments, names and poses may change and leave an arm; many others must not.
  std::cout << kAll << " mutated URDFs: " << kAll - accepted << " refused in one line, " << accepted
            << " sound arms, none accepted with an error logged\n";
  EXPECT_GT(accepted, kAll / 20);
  EXPECT_LT(accepted, kAll - kAll / 4);
}

}  // namespace mutated_urdf_test
}  // namespace armtune::internal
