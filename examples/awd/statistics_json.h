// SPDX-License-Identifier: Apache-2.0
// What a render cost, as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "awd_handles.hpp"

namespace command {

nlohmann::json toJson(const AWDPassStatistics& statistics);

/// {"passes": [...], "total": {...}} of the passes that have ended.
nlohmann::json renderStatistics(const Render& render);

/// {"failed": ..., "limited": ..., "iterations": ...} of the last time that the field adapted.
nlohmann::json refitStatistics(const Field& field);

/// Indented text that ends in a newline; bytes that are no UTF-8 are replaced.
std::string toText(const nlohmann::json& value);

}  // namespace command
