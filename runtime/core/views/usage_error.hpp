// core/views/usage_error.hpp: the exception for a call that does not fit, whatever the elements are.
#ifndef MEETC_CORE_VIEWS_USAGE_ERROR_HPP
#define MEETC_CORE_VIEWS_USAGE_ERROR_HPP

#include <stdexcept>

namespace meetc {

// Kinds, predicates, rungs, poses or options that do not belong together, or a name that is not there. A bad element is an
// input_error, which is no usage_error.
class usage_error : public std::invalid_argument {
public:
  using std::invalid_argument::invalid_argument;
};

} // namespace meetc

#endif
