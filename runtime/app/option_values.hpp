// app/option_values.hpp: values of options that several commands take.
#ifndef MEETC_APP_OPTION_VALUES_HPP
#define MEETC_APP_OPTION_VALUES_HPP

#include <string>

namespace meetc::app {

// Of --threads: 0, all cores, to the most that the core takes. Throws failure.
int threads_named(const std::string &text);

} // namespace meetc::app

#endif
