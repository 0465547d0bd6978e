// SPDX-License-Identifier: Apache-2.0
// What a render cost, as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "awd/awd.hpp"

namespace command {

nlohmann::json toJson(const AWDPassStatistics& statistics);

/// {"passes": [...], "total": {...}} of the passes that have ended.
nlohmann::json renderStatistics(awd::Render& render);

/// {"failed": ..., "limited": ..., "iterations": ...} of the last time that the field adapted.
nlohmann::json refitStatistics(awd::Field& field);

/// Indented text that ends in a newline; bytes that are no UTF-8 are replaced.
std::string toText(const nlohmann::json& value);

}  // namespace command
