// SPDX-License-Identifier: Apache-2.0
// Rows of figures: over the seeds of one cell, as text and in files.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace bench {

/// Median and quartiles.
struct Spread {
  double median = 0.0, low = 0.0, high = 0.0;
};
Spread spreadOf(std::vector<double> values);

/// exp of the mean of the logarithms, each value at least 1e-12; NaN of none.
double geometricMean(const std::vector<double>& values);

/// A flat object, in the order of its columns.
using Row = nlohmann::ordered_json;

/// Sets `name`, `name`_low and `name`_high.
void setSpread(Row& row, const std::string& name, const Spread& spread);

/// FOLDER/name.json with `head` and its rows as "rows", and FOLDER/name.csv of the rows, whose
/// columns are all keys in the order of their first use. Each is whole or not at all.
void writeRows(const Row& head, const std::vector<Row>& rows, const std::string& folder,
               const std::string& name);

}  // namespace bench
