/* SPDX-License-Identifier: Apache-2.0
 *
 * libawd: adaptive wavelet densities for Monte Carlo ray tracing. All of the interface but that of
 * basis plugins (awd/basis.h).
 */
#ifndef AWD_AWD_H
#define AWD_AWD_H

#include "awd/density.h"
#include "awd/device.h"
#include "awd/field.h"
#include "awd/image.h"
#include "awd/light.h"
#include "awd/render.h"
#include "awd/scene.h"
#include "awd/types.h"

#endif
