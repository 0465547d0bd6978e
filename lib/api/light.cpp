// SPDX-License-Identifier: Apache-2.0
#include "awd/light.h"

#include "api/field_checks.h"
#include "api/handles.h"

using namespace awd;

namespace {

const LightChoice& lightsOf(const Field& field, uint32_t patch) {
  const PatchView view = field.view(patch);
  if (view.lights) return *view.lights;
  fail(AWD_ERROR_INVALID_OPERATION, "the field chooses no lights: its lightCount is 0");
}

void checkLight(const LightChoice& lights, uint32_t light) {
  if (light < lights.lights()) return;
  fail(AWD_ERROR_INVALID_ARGUMENT, "light is %u: the field has %u", light, lights.lights());
}

}  // namespace

extern "C" {

AWDResult AWD_CALL awdChooseLight(AWDField field, uint32_t patch, double uniform, uint32_t* light,
                                  float* chance, double* rest) noexcept {
  return guard(__func__, [&] {
    const LightChoice& lights = lightsOf(object(field, "field"), patch);
    if (!(uniform >= 0.0 && uniform < 1.0)) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "uniform is %g: it must be in [0,1)", uniform);
    }
    need(light, "light");
    need(chance, "chance");
    const LightChoice::Chosen chosen = lights.choose(uniform);
    *light = chosen.light;
    *chance = chosen.chance;
    if (rest) *rest = chosen.rest;
  });
}

AWDResult AWD_CALL awdGetLightChance(AWDField field, uint32_t patch, uint32_t light,
                                     float* chance) noexcept {
  return guard(__func__, [&] {
    const LightChoice& lights = lightsOf(object(field, "field"), patch);
    checkLight(lights, light);
    *need(chance, "chance") = lights.chance(light);
  });
}

AWDResult AWD_CALL awdRecordLight(AWDField field, uint32_t patch, uint32_t light,
                                  double value) noexcept {
  return guard(__func__, [&] {
    Field& known = idle(field, "field");
    checkLight(lightsOf(known, patch), light);
    known.checkPatch(patch);
    known.recordLight(patch, known.view(patch), light, value);
  });
}

AWDResult AWD_CALL awdGetPatchLight(AWDField field, uint32_t patch, float* magnitude) noexcept {
  return guard(__func__, [&] {
    const LightChoice& lights = lightsOf(object(field, "field"), patch);
    *need(magnitude, "magnitude") = static_cast<float>(lights.magnitude());
  });
}

}  // extern "C"
