// core/threads/cancelled.hpp: the exception of a call that its caller has stopped.
#ifndef MEETC_CORE_THREADS_CANCELLED_HPP
#define MEETC_CORE_THREADS_CANCELLED_HPP

#include <stdexcept>

namespace meetc {

// A stop was requested of the std::stop_token that the call was given. Its sets are as they were, and have no answer.
class cancelled : public std::runtime_error {
public:
  cancelled() : std::runtime_error("cancelled") {}
};

} // namespace meetc

#endif
