/* SPDX-License-Identifier: Apache-2.0
 *
 * mpi-render: one film and one field by many processes, with the bits of one process.
 */
#include <errno.h>
#include <mpi.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>

#include "room.h"

typedef struct Job {
  const char* checkpoint;
  const char* image;
  uint32_t size;    /* of the image, pixels a side */
  uint32_t samples; /* per pixel */
  uint32_t dies;    /* in this pass, from 1 on, the last rank is killed; 0: in none */
  int rank, ranks;
  AWDDevice device;
  AWDScene scene;
  AWDRender render;
  uint64_t* numbers;
  size_t capacity;
} Job;

/* Without one of its ranks a job can't go on: it ends, and says why. */
static void check(const Job* job, AWDResult result) {
  if (result == AWD_SUCCESS) return;
  fprintf(stderr, "mpi-render: rank %d of %d: %s\n", job->rank, job->ranks,
          awdGetLastErrorMessage());
  MPI_Abort(MPI_COMM_WORLD, 1);
}

/* All ranks must do the same: the first one looks whether there is a checkpoint. */
static int hasCheckpoint(const Job* job) {
  int there = 0;
  if (job->rank == 0) {
    FILE* file = fopen(job->checkpoint, "rb");
    there = file != NULL || errno != ENOENT; /* one that can't be opened is not to be overwritten */
    if (file) fclose(file);
  }
  MPI_Bcast(&there, 1, MPI_INT, 0, MPI_COMM_WORLD);
  return there;
}

static void begin(Job* job) {
  const AWDCamera camera = viewOfRoom(job->size);
  AWDRenderDesc desc = AWD_RENDER_DESC_INIT;
  AWDDeviceDesc deviceDesc = AWD_DEVICE_DESC_INIT;
  uint32_t passes = 0;
  desc.camera = &camera;
  deviceDesc.threads = 1; /* a rank a core; 0 for a rank a machine */
  check(job, awdNewDevice(&deviceDesc, &job->device));
  check(job, makeRoom(job->device, &job->scene));
  if (!hasCheckpoint(job)) {
    check(job, awdNewRender(job->scene, NULL, &desc, &job->render));
    return;
  }
  check(job, awdLoadRender(job->scene, job->checkpoint, NULL, &desc, &job->render));
  check(job, awdGetPassCount(job->render, &passes));
  if (job->rank == 0) printf("going on after %u passes\n", (unsigned)passes);
}

/* In pieces, since MPI counts in ints. */
static void reduce(uint64_t* numbers, size_t count, MPI_Op op) {
  const size_t most = (size_t)1 << 26;
  while (count > 0) {
    const size_t now = count < most ? count : most;
    MPI_Allreduce(MPI_IN_PLACE, numbers, (int)now, MPI_UINT64_T, op, MPI_COMM_WORLD);
    numbers += now;
    count -= now;
  }
}

/* What all parts have found becomes what each rank has. The bytes that it took. */
static size_t exchange(Job* job) {
  size_t sums, maxima;
  check(job, awdExportPass(job->render, NULL, 0, &sums, &maxima));
  if (sums + maxima > job->capacity) {
    job->capacity = sums + maxima;
    free(job->numbers);
    job->numbers = malloc(job->capacity * sizeof *job->numbers);
    if (!job->numbers) {
      fprintf(stderr, "mpi-render: rank %d of %d: out of memory\n", job->rank, job->ranks);
      MPI_Abort(MPI_COMM_WORLD, 1);
    }
  }
  check(job, awdExportPass(job->render, job->numbers, job->capacity, &sums, &maxima));
  reduce(job->numbers, sums, MPI_SUM);
  reduce(job->numbers + sums, maxima, MPI_MAX);
  check(job, awdImportPass(job->render, job->numbers, sums + maxima, NULL));
  return (sums + maxima) * sizeof *job->numbers;
}

static void renderPasses(Job* job) {
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.totalSamples = job->samples;
  for (;;) {
    const double begun = MPI_Wtime();
    double rendered;
    size_t bytes;
    uint32_t samples, pass;
    check(job, awdGetPassCount(job->render, &pass));
    if (pass + 1 == job->dies && job->rank == job->ranks - 1) raise(SIGKILL);
    check(job, awdRenderPassPart(job->render, &schedule, (uint32_t)job->rank, (uint32_t)job->ranks,
                                 &samples));
    if (samples == 0) break;
    rendered = MPI_Wtime();
    bytes = exchange(job);
    if (job->rank == 0) {
      printf("pass %u: %u samples, %.3f s rendered, %.3f s combined, %zu bytes\n",
             (unsigned)pass + 1, (unsigned)samples, rendered - begun, MPI_Wtime() - rendered,
             bytes);
      check(job, awdSaveRender(job->render, job->checkpoint));
    }
  }
}

static void writeImage(const Job* job) {
  AWDImage image = NULL;
  if (job->rank != 0) return;
  check(job, awdNewFilmImage(job->render, &image));
  check(job, awdWriteImageEXR(image, job->image));
  awdReleaseImage(image);
}

int main(int count, char** arguments) {
  Job job = {NULL, NULL, 128, 64, 0, 0, 1, NULL, NULL, NULL, NULL, 0};
  MPI_Init(&count, &arguments);
  MPI_Comm_rank(MPI_COMM_WORLD, &job.rank);
  MPI_Comm_size(MPI_COMM_WORLD, &job.ranks);
  if (count < 3) {
    if (job.rank == 0) {
      fprintf(stderr, "usage: mpi-render CHECKPOINT OUT.exr [SIZE [SAMPLES [DIES]]]\n");
    }
    MPI_Finalize();
    return 2;
  }
  job.checkpoint = arguments[1];
  job.image = arguments[2];
  if (count > 3) job.size = (uint32_t)strtoul(arguments[3], NULL, 10);
  if (count > 4) job.samples = (uint32_t)strtoul(arguments[4], NULL, 10);
  if (count > 5) job.dies = (uint32_t)strtoul(arguments[5], NULL, 10);

  begin(&job);
  renderPasses(&job);
  writeImage(&job);

  awdReleaseRender(job.render);
  awdReleaseScene(job.scene);
  awdReleaseDevice(job.device);
  free(job.numbers);
  MPI_Finalize();
  return 0;
}
