/* SPDX-License-Identifier: Apache-2.0
 *
 * guide-direct: the field learns where the lamp is. No shadow rays: paths must hit it.
 */
#include "comparison.h"

int main(int count, char** arguments) {
  const Settings settings = {128, 256, 1024, 1, NULL};
  Scene scene;
  makeFloor(&scene);
  return runCommand("guide-direct",
                    "Renders a floor under a lamp that only paths find, unguided and guided by "
                    "libawd.",
                    count, arguments, &scene, 0, settings);
}
