// SPDX-License-Identifier: Apache-2.0
#include "row.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "write_file.h"

namespace bench {
namespace {

/// Of sorted values, linear between neighbours.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

std::string csvOf(const std::vector<Row>& rows) {
  std::vector<std::string> columns;
  for (const Row& row : rows) {
    for (const auto& [name, value] : row.items()) {
      if (std::find(columns.begin(), columns.end(), name) == columns.end()) columns.push_back(name);
    }
  }
  std::string text;
  for (const std::string& column : columns) text += (text.empty() ? "" : ",") + column;
  text += '\n';
  for (const Row& row : rows) {
    const char* comma = "";
    for (const std::string& column : columns) {
      text += comma;
      comma = ",";
      if (!row.contains(column)) continue;
      const Row& value = row[column];
      text += value.is_string() ? value.get<std::string>() : value.dump();
    }
    text += '\n';
  }
  return text;
}

}  // namespace

Spread spreadOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {quantile(values, 0.5), quantile(values, 0.25), quantile(values, 0.75)};
}

double geometricMean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += std::log(std::max(value, 1e-12));
  return std::exp(sum / static_cast<double>(values.size()));
}

void setSpread(Row& row, const std::string& name, const Spread& spread) {
  row[name] = spread.median;
  row[name + "_low"] = spread.low;
  row[name + "_high"] = spread.high;
}

void writeRows(const Row& head, const std::vector<Row>& rows, const std::string& folder,
               const std::string& name) {
  // One row a line: a file that can be read, and compared.
  std::string text = head.dump(1);
  text.erase(text.find_last_of('}'));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  text += head.empty() ? "\n \"rows\": [" : ",\n \"rows\": [";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += (i == 0 ? "\n  " : ",\n  ") + rows[i].dump();
  }
  text += "\n ]\n}\n";
  const std::string path = (std::filesystem::path(folder) / name).string();
  command::writeFile(path + ".json", text);
  command::writeFile(path + ".csv", csvOf(rows));
}

}  // namespace bench
