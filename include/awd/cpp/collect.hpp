// SPDX-License-Identifier: Apache-2.0
//
// Lists whose length the library knows.
#ifndef AWD_CPP_COLLECT_HPP
#define AWD_CPP_COLLECT_HPP

#include <vector>

#include "awd/cpp/error.hpp"

namespace awd {
inline namespace AWD_CPP_MODE {
namespace detail {

/// All that `fill`, a function (items, capacity, &count), has to tell. It is asked again should
/// there be more meanwhile.
template <class T, class Fill>
Returns<std::vector<T>> collect(Fill&& fill) {
  std::vector<T> items;
  std::size_t count = 0;
  AWDResult result = fill(nullptr, 0, &count);
  while (result == AWD_SUCCESS && count > items.size()) {
    items.resize(count);
    result = fill(items.data(), items.size(), &count);
  }
  items.resize(result == AWD_SUCCESS ? count : 0);
  return outcome(result, items);
}

}  // namespace detail
}  // namespace AWD_CPP_MODE
}  // namespace awd

#endif
