#pragma once
// The processes of one `mpirun heckbert render ...`, which share its samples out: rank r of n traces part r + 1 of n,
// and what they found comes together at rank 0. A tool that was built without MPI, or that runs by itself, is rank 0
// of 1.

#include <string>

namespace heckbert::cli {

class Ranks {
 public:
  /// Joins the other processes when the program was started by mpirun or the like. One at a time.
  /// Errors: std::runtime_error when it was, and the tool cannot.
  Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int number() const { return number_; }  ///< of this process, from 0
  int count() const { return count_; }

  /// One process tells another; the other waits for it.
  void send(int to, const std::string& bytes) const;
  std::string receive(int from) const;

  /// Waits for all and leaves. A process that ends without it ends the others too: its part will be missing.
  void leave();
  /// Ends all processes: each may write what it has, then the job is over. Does not return when there are others.
  void interrupt_all() const;

 private:
  int number_ = 0, count_ = 1;
};

}  // namespace heckbert::cli
