#include "tuner/session/journalled_run.hpp"

#include <dlfcn.h>
#include <filesystem>

#include "core/common/file_path.hpp"
#include "tuner/run/arithmetic.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/input_copies.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/session/study_files.hpp"

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;

constexpr double kPatience = 10.0;  ///< [s]; ranks of a killed run are gone by then

/// Removes the files of a run that has just begun, except its journal. Then removes the folder if it is
/// empty. A journal in it would belong to another run.
void discard_folder(const std::string& folder) {
  std::error_code ignored;
  const fs::path warm = fs::path(folder) / kWarmGains;
  fs::remove(warm, ignored);
  fs::remove(warm.parent_path(), ignored);
  fs::remove_all(fs::path(folder) / kInputCopies, ignored);
  fs::remove(folder, ignored);
}

/// Removes the folder of a new run that ended before anything was finished.
void discard_run(const std::string& folder) {
  std::error_code ignored;
  fs::remove(folder + "/" + kJournal, ignored);
  discard_folder(folder);
}

/// Calls write_first, begins a journal, and copies the inputs.
std::unique_ptr<Journal> begin(const std::string& folder, const RunHeader& header,
                               const std::vector<std::string>& inputs,
                               const std::function<void()>& write_first) {
  std::unique_ptr<Journal> journal;
  try {
    if (write_first) write_first();
    journal = Journal::begin(folder + "/" + kJournal, header);
    keep_inputs(folder, inputs);
  } catch (...) {  // the folder must not prevent another try
    const bool begun = journal != nullptr;
    journal.reset();  // if the process ran out of file descriptors, removing needs this one
    begun ? discard_run(folder) : discard_folder(folder);
    throw;
  }
  return journal;
}

std::unique_ptr<Journal> resume(const std::string& folder, const RunHeader& header,
                                const std::vector<std::string>& inputs, SessionObserver& observer) {
  refuse_links(folder);
  std::string warning;
  auto journal = Journal::resume(journal_in(folder), header, warning, kPatience);
  if (!warning.empty()) observer.warned(warning);
  if (journal->exit_code()) return journal;
  keep_inputs(folder, inputs);
  return journal;
}

}  // namespace

std::string journal_in(const std::string& folder) {
  return find_run_file(folder, kJournal).value_or(folder + "/" + kJournal);
}

/// Returns the file with this code: the program, or a library such as the Python module.
static std::string code_path() {
  Dl_info info{};
  const bool known =
      ::dladdr(reinterpret_cast<const void*>(&journal_in), &info) != 0 && info.dli_fname != nullptr;
  const fs::path path = known ? info.dli_fname : "";
  constexpr const char* kProgram = "/proc/self/exe";
  std::error_code error;
  // For a program, dli_fname is the name by which it was called. Another file in the current folder may have
  // this name.
  const bool library = path.is_absolute() && !fs::equivalent(path, kProgram, error) && !error;
  return library ? path.string() : kProgram;
}

RunHeader run_header(const Invocation& invocation, std::vector<std::pair<std::string, std::string>> identity,
                     const std::vector<std::string>& inputs) {
  RunHeader header;
  header.arguments = invocation.words;
  header.working_folder = absolute_path(".");
  header.identity = std::move(identity);
  for (auto& version : versions()) header.identity.push_back(std::move(version));
  header.identity.emplace_back("arithmetic", arithmetic().fingerprint);
  header.identity.emplace_back(RunHeader::kProgram, hash_of_file(code_path()));
  for (auto& input : hashes(inputs)) header.identity.push_back(std::move(input));
  return header;
}

JournalledRun::JournalledRun(RunPlace place, const RunHeader& header, const std::vector<std::string>& inputs,
                             SessionObserver& observer, const std::function<void()>& write_first)
    : place_(std::move(place)) {
  if (!place_.resume) lock_ = make_run_folder(place_.folder);
  journal_ = place_.resume ? armtune::internal::resume(place_.folder, header, inputs, observer)
                           : begin(place_.folder, header, inputs, write_first);
  before_ = journal_->seconds();
}

JournalledRun::~JournalledRun() {
  if (!kept_ && !place_.resume) discard_run(place_.folder);
}

std::optional<Ending> JournalledRun::finished() const {
  if (!journal_->exit_code()) return std::nullopt;
  return static_cast<Ending>(*journal_->exit_code());
}

bool JournalledRun::can_resume() const {
  std::error_code ignored;
  return fs::exists(place_.folder + "/" + kJournal, ignored);
}

}  // namespace armtune::internal
