#pragma once
// Runs the real program and keeps what it said.

#include <string>
#include <vector>

namespace armtune::internal::test {

/// Returns the path of the program that is tested.
std::string program_path();

/// Returns the path of mpiexec, or an empty text if armtune is built without MPI.
std::string mpiexec_path();

struct Finished {
  int exit_code = -1;  ///< -1: ended by a signal
  std::string out;
  std::string err;
};

/// A program under way. Its output goes to files, so that it never waits for a reader.
class Program {
 public:
  /// Arguments without the program's own name; `folder`: where it runs. launcher: what starts it, by its
  /// path, with arguments of its own; none: the program itself.
  Program(const std::vector<std::string>& arguments, const std::string& folder,
          const std::vector<std::string>& launcher = {});
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void interrupt() const;  ///< SIGINT
  void kill() const;       ///< SIGKILL
  bool running();
  int pid() const { return pid_; }
  std::string err_so_far() const;
  Finished wait();

 private:
  int pid_ = -1;
  int status_ = 0;
  bool ended_ = false;
  std::string out_path_;
  std::string err_path_;
};

/// Runs it to its end in a folder of its own.
Finished run_program(const std::vector<std::string>& arguments);

}  // namespace armtune::internal::test
