// SPDX-License-Identifier: Apache-2.0
#include "api/exchange.h"
#include "api/render_at_work.h"
#include "awd/render.h"

using namespace awd;

extern "C" {

AWDResult AWD_CALL awdRenderPassPart(AWDRender render, const AWDSchedule* schedule, uint32_t part,
                                     uint32_t parts, uint32_t* samplesPerPixel) noexcept {
  return guard(__func__, [&] {
    *need(samplesPerPixel, "samplesPerPixel") = 0;
    AWDSchedule known = AWD_SCHEDULE_INIT;
    if (schedule) known = readStruct(schedule, "schedule", "AWD_SCHEDULE_INIT");
    *samplesPerPixel = RenderAtWork(object(render, "render"))->passPart(known, part, parts);
  });
}

AWDResult AWD_CALL awdExportPass(AWDRender render, uint64_t* numbers, size_t capacity, size_t* sums,
                                 size_t* maxima) noexcept {
  return guard(__func__, [&] {
    const Render& known = idleWithField(render);
    const Field::ExchangeSize size = known.exchangeSize();
    if (!tellSize(size.sums, size.maxima, numbers, capacity, sums, maxima)) return;
    known.exportPass(numbers, numbers + size.sums);
  });
}

AWDResult AWD_CALL awdImportPass(AWDRender render, const uint64_t* numbers, size_t count,
                                 AWDPassStatistics* statistics) noexcept {
  return guard(__func__, [&] {
    Render& known = idleWithField(render);
    const Field::ExchangeSize size = known.exchangeSize();
    checkCount(size.sums, size.maxima, numbers, count);
    AWDPassStatistics figures = AWD_PASS_STATISTICS_INIT;
    // A bad output struct must be found before anything is changed.
    if (statistics) writeStruct(statistics, figures, "statistics", "AWD_PASS_STATISTICS_INIT");
    figures = known.importPass(numbers, numbers + size.sums);
    if (statistics) writeStruct(statistics, figures, "statistics", "AWD_PASS_STATISTICS_INIT");
  });
}

}  // extern "C"
