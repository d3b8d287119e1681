// A folder that goes with its process, however that ends.
#pragma once

#include <string>

#include <sys/types.h>

namespace cover::reading {

/// Has a folder removed when this object ends or this process does, even killed: by a shell that
/// waits for that, apart from this process and its group, so that what ends these (a
/// terminal, mpirun) spares it. Where no shell can be started, nothing is removed here.
class Remover {
 public:
  explicit Remover(const std::string& folder);
  Remover(const Remover&) = delete;
  Remover& operator=(const Remover&) = delete;
  /// Returns when the folder is gone.
  ~Remover();

 private:
  pid_t shell_ = -1;  ///< none: -1
  int end_ = -1;      ///< of what the shell reads; closed with this process
};

}  // namespace cover::reading
