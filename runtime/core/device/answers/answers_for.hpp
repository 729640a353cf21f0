// core/device/answers/answers_for.hpp: the answers of a query on a device, by what is asked for.
#ifndef MEETC_CORE_DEVICE_ANSWERS_ANSWERS_FOR_HPP
#define MEETC_CORE_DEVICE_ANSWERS_ANSWERS_FOR_HPP

#include "meet/core/device/answers/query_answer.hpp"

#include <memory>
#include <vector>

namespace meetc::on_device {

// None for a count of elements, which each query makes.
std::vector<std::unique_ptr<query_answer>> answers_for(const cuda::pair_launchers &by, const device_options &options);

} // namespace meetc::on_device

#endif
