// How long work tells how far it is.
#pragma once

#include <cstddef>
#include <functional>

namespace mapwright {

/// Called with (done, total), from one thread at a time. Empty: nobody listens.
using Progress = std::function<void(std::size_t, std::size_t)>;

}  // namespace mapwright
