/* SPDX-License-Identifier: Apache-2.0
 *
 * Which light a shadow ray goes to, as a field learns it patch by patch. For next-event estimation
 * in scenes of several lights, each of which is seen from a part of the scene only.
 *
 * At a vertex a host chooses one of AWDFieldDesc.lightCount lights (awdChooseLight), a point on it
 * by its own means, traces the shadow ray, records what it brought (awdRecordLight), and divides by
 * the chance of the light for its estimate. Light l is chosen with the chance
 *   p_l = a power_l / sum power + (1 - a) sqrt(E[x_l^2]) / sum_k sqrt(E[x_k^2]),
 * which is the best but for the first term, that finds what has not been met yet: a is 1 before
 * anything is known and goes to 0.05.
 *
 * Chances are frozen between two adapts. Where shadow rays are combined with directions that met a
 * light, take weights of a fixed chance, such as by power: what the field learns of directions then
 * doesn't change with what it knows of lights.
 */
#ifndef AWD_LIGHT_H
#define AWD_LIGHT_H

#include "awd/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Chooses a light by a uniform in [0,1): its number, the chance it had, and the rest of the
   uniform, which is uniform in [0,1) again, to choose within a group of lights; rest may be NULL.
   AWD_ERROR_INVALID_OPERATION if the field's lightCount is 0. Free, but not while the field
   adapts. */
AWD_EXPORT AWDResult AWD_CALL awdChooseLight(AWDField field, uint32_t patch, double uniform,
                                             uint32_t* light, float* chance,
                                             double* rest) AWD_NOEXCEPT;

/* The chance of light < lightCount to be chosen. AWD_ERROR_INVALID_OPERATION if lightCount is 0.
   Free, but not while the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetLightChance(AWDField field, uint32_t patch, uint32_t light,
                                                float* chance) AWD_NOEXCEPT;

/* What a shadow ray to `light` brought: x_l = luminance of f_r L cos(theta) over the pdf of the
   point in solid angle (and of the choice within its group), times the weight with which the host
   combines it; not divided by the chance of the light; 0 where it was hidden. NaN, infinite or
   negative values count as rejected samples of value 0. AWD_ERROR_INVALID_OPERATION as above. Free,
   but not while the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdRecordLight(AWDField field, uint32_t patch, uint32_t light,
                                             double value) AWD_NOEXCEPT;

/* sum_l sqrt(E[x_l^2]), the root mean square of an estimate of all lights by one shadow ray chosen
   in the best way, by what all passes have found; 0 where nothing has been. Times throughput over
   what the pixel is expected to have it tells how many shadow rays a vertex is worth.
   AWD_ERROR_INVALID_OPERATION as above. Free, but not while the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetPatchLight(AWDField field, uint32_t patch,
                                               float* magnitude) AWD_NOEXCEPT;

#ifdef __cplusplus
}
#endif
#endif
