#include "converter/isolation/shared_batches.hpp"

#include <sys/mman.h>

namespace mapwright::converter {

std::unique_ptr<SharedBatches> SharedBatches::create() {
  void* const memory = ::mmap(nullptr, kSlots * kSlotBytes, PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return nullptr;
  return std::unique_ptr<SharedBatches>(new SharedBatches(static_cast<char*>(memory)));
}

SharedBatches::~SharedBatches() {
  ::munmap(memory_, kSlots * kSlotBytes);
}

}  // namespace mapwright::converter
