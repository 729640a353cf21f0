#pragma once

namespace meetc::poly {

// The price in a search: every operation, or first those on values of the pair and then every operation.
enum class price { whole, pair };

} // namespace meetc::poly
