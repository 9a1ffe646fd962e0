#include "armtune/program.hpp"

int main(int argc, char** argv) {
  return armtune::run_program(argc, argv);
}
