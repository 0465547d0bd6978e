/* SPDX-License-Identifier: Apache-2.0
 *
 * host-tracer: a path tracer of its own, guided through the C interface of libawd.
 */
#include "comparison.h"

int main(int count, char** arguments) {
  const Settings settings = {96, 512, 8192, 1, NULL};
  Scene scene;
  makeRoom(&scene);
  return runCommand("host-tracer",
                    "Renders a room lit by way of its ceiling, unguided and guided by libawd.",
                    count, arguments, &scene, 1, settings);
}
