#pragma once

namespace meetc::poly {

// What counts in a search: every operation, or first those on values of the pair and then every operation.
enum class price { whole, pair };

} // namespace meetc::poly
