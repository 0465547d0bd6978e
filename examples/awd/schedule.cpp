// SPDX-License-Identifier: Apache-2.0
#include "schedule.h"

#include <charconv>
#include <string_view>

#include "failure.h"

namespace command {
namespace {

std::vector<uint32_t> parseNumbers(const std::string& list) {
  std::vector<uint32_t> numbers;
  std::string_view rest = list;
  while (true) {
    const std::string_view word = rest.substr(0, rest.find(','));
    uint32_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size() || number == 0) {
      throw UsageError("--spp " + list + ": " + inQuotes(std::string(word)) +
                       " is no number of samples: give whole numbers above 0, such as 4,4,8");
    }
    numbers.push_back(number);
    if (word.size() == rest.size()) return numbers;
    rest.remove_prefix(word.size() + 1);
  }
}

}  // namespace

Schedule makeSchedule(std::optional<uint32_t> passes, const std::optional<std::string>& spp,
                      std::optional<uint32_t> samples) {
  if (samples && (spp || passes)) {
    throw UsageError("--samples divides a total into passes by itself: it can't be used with " +
                     std::string(spp ? "--spp" : "--passes"));
  }
  if (passes && !spp) throw UsageError("--passes needs --spp: how many samples has each pass?");
  Schedule schedule;
  schedule.totalSamples = samples.value_or(0);
  if (!spp) return schedule;
  schedule.samplesPerPass = parseNumbers(*spp);
  if (!passes) return schedule;
  if (schedule.samplesPerPass.size() == 1) {
    schedule.samplesPerPass.resize(*passes, schedule.samplesPerPass.front());
  }
  if (schedule.samplesPerPass.size() != *passes) {
    throw UsageError("--spp " + *spp + " has " + std::to_string(schedule.samplesPerPass.size()) +
                     " numbers for --passes " + std::to_string(*passes) +
                     ": give one for all passes, or one for each");
  }
  return schedule;
}

}  // namespace command
