#pragma once
// Makes standard output and standard error of the program safe. Writing to them then never throws and never
// ends the program, even if the disk is full or a reader such as `head` has closed the pipe.

namespace armtune::internal::cli {

/// Makes the three standard streams safe to use. Call it first in main.
/// - A stream that is closed, as in some detached programs, is opened as /dev/null. Otherwise the next file
///   that is opened, such as a journal, would get its descriptor number, and printed text would end up there.
/// - `stdout` and `stderr` accept every text. Text that cannot be written is dropped, and the reason is kept.
/// - Writing to a pipe that nobody reads any more does not end the program by the signal SIGPIPE.
void open_standard_streams();

/// Writes out everything printed so far. Returns the errno of the first error that lost text, or 0. A pipe
/// that its reader has closed is not an error, because that reader needs no more.
int flush_standard_output();

}  // namespace armtune::internal::cli
