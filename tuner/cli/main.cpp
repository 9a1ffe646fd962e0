#include "tuner/cli/program.hpp"

int main(int argc, char** argv) {
  return armtune::cli::run(argc, argv);
}
