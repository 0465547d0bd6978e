// SPDX-License-Identifier: Apache-2.0
#include "api/exchange.h"
#include "api/handles.h"
#include "awd/field.h"
#include "guide/field.h"

using namespace awd;

namespace {

Field::Exchanged exchangedOf(const Field& field, const uint32_t* patches, size_t count) {
  if (field.isSpatial()) {
    if (count > 0) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "patchCount is %zu: spatial patches are exchanged all, leave patches NULL", count);
    }
    return {};
  }
  if (count > 0) need(patches, "patches");
  for (size_t i = 1; i < count; ++i) {
    if (patches[i] > patches[i - 1]) continue;
    fail(AWD_ERROR_INVALID_ARGUMENT, "patches[%zu] is %u after %u: they must ascend", i, patches[i],
         patches[i - 1]);
  }
  return {patches, count};
}

}  // namespace

extern "C" {

AWDResult AWD_CALL awdExportField(AWDField field, const uint32_t* patches, size_t patchCount,
                                  uint64_t* numbers, size_t capacity, size_t* sums,
                                  size_t* maxima) noexcept {
  return guard(__func__, [&] {
    const Field& known = idle(field, "field");
    const Field::Exchanged exchanged = exchangedOf(known, patches, patchCount);
    const Field::ExchangeSize size = known.exchangeSize(exchanged);
    if (!tellSize(size.sums, size.maxima, numbers, capacity, sums, maxima)) return;
    known.exportRecords(exchanged, numbers, numbers + size.sums);
  });
}

AWDResult AWD_CALL awdImportField(AWDField field, const uint32_t* patches, size_t patchCount,
                                  const uint64_t* numbers, size_t count) noexcept {
  return guard(__func__, [&] {
    Field& known = idle(field, "field");
    const Field::Exchanged exchanged = exchangedOf(known, patches, patchCount);
    const Field::ExchangeSize size = known.exchangeSize(exchanged);
    checkCount(size.sums, size.maxima, numbers, count);
    known.importRecords(exchanged, numbers, numbers + size.sums);
  });
}

}  // extern "C"
