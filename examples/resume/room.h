/* SPDX-License-Identifier: Apache-2.0
 *
 * A closed room with a lamp that shines at the ceiling.
 */
#ifndef ROOM_H
#define ROOM_H

#include <awd/awd.h>

/* Uploads and commits it. */
AWDResult makeRoom(AWDDevice device, AWDScene* scene);
/* A view of it, of size x size pixels. */
AWDCamera viewOfRoom(uint32_t size);

#endif
