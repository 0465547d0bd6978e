/* SPDX-License-Identifier: Apache-2.0
 *
 * awd-integrate: integrates one of a few functions over the unit cube. Exit codes: 0 done, 1 failed
 * or goal not met, 2 misused, 130 interrupted.
 */
#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "integrate.h"

typedef struct Function {
  const char* name;
  const char* formula;
  double (*at)(uint32_t dimensions, const double* x);
} Function;

static double ballAt(uint32_t dimensions, const double* x) {
  double sum = 0.0;
  uint32_t a;
  for (a = 0; a < dimensions; ++a) sum += x[a] * x[a];
  return sum < 1.0;
}

static double bumpAt(uint32_t dimensions, const double* x) {
  double sum = 0.0;
  uint32_t a;
  for (a = 0; a < dimensions; ++a) sum += (x[a] - 0.5) * (x[a] - 0.5);
  return exp(-sum / 0.02);
}

static double ridgeAt(uint32_t dimensions, const double* x) {
  double sum = 0.0, squares = 0.0;
  uint32_t a;
  for (a = 0; a < dimensions; ++a) {
    sum += x[a];
    squares += x[a] * x[a];
  }
  return exp((sum * sum / dimensions - squares) / 0.02);
}

static double waveAt(uint32_t dimensions, const double* x) {
  double sum = 0.0;
  uint32_t a;
  for (a = 0; a < dimensions; ++a) sum += x[a];
  return cos(9.0 * sum);
}

static const Function kFunctions[] = {
    {"ball", "1 where |x| < 1, else 0", ballAt},
    {"bump", "exp(-|x - 1/2|^2 / 0.02)", bumpAt},
    {"ridge", "exp(-r^2 / 0.02), r the distance from the diagonal", ridgeAt},
    {"wave", "cos(9 sum x)", waveAt},
};
static const size_t kFunctionCount = sizeof kFunctions / sizeof kFunctions[0];

typedef struct Problem {
  const Function* function;
  uint32_t dimensions;
} Problem;

static volatile sig_atomic_t interrupted = 0;

static void onInterrupt(int number) {
  (void)number;
  interrupted = 1;
}

static double evaluate(void* user, const double* x) {
  const Problem* problem = user;
  return problem->function->at(problem->dimensions, x);
}

static int goOn(void* user, const IntegrateProgress* progress) {
  (void)user;
  (void)progress;
  return !interrupted;
}

static void printUsage(FILE* file) {
  size_t i;
  fputs(
      "usage: awd-integrate FUNCTION [options]\n"
      "Integrates a function over the unit cube.\n\n",
      file);
  for (i = 0; i < kFunctionCount; ++i) {
    fprintf(file, "  %-22s %s\n", kFunctions[i].name, kFunctions[i].formula);
  }
  fputs(
      "\n"
      "  --dimensions D         1 to 6; default 2\n"
      "  --evaluations N        the budget; default 100000\n"
      "  --absolute E           goal: an error of at most E, or\n"
      "  --relative E           of E times the value; default: spend the budget\n"
      "  --seed S               default 1\n"
      "  --help                 this text\n",
      file);
}

static int misused(const char* what, const char* value) {
  fprintf(stderr, "awd-integrate: %s%s (--help tells more)\n", what, value);
  return 2;
}

/* A number of at least 0; 0 if it isn't one. */
static int parseNumber(const char* text, double* value) {
  char* end = NULL;
  errno = 0;
  *value = strtod(text, &end);
  return end != text && *end == '\0' && errno == 0 && *value >= 0.0 && isfinite(*value);
}

static int parse(int count, char** arguments, Problem* problem, IntegrateOptions* options) {
  int i;
  for (i = 1; i < count; ++i) {
    const char* name = arguments[i];
    double value;
    if (strncmp(name, "--", 2) != 0) {
      size_t f = 0;
      while (f < kFunctionCount && strcmp(kFunctions[f].name, name) != 0) ++f;
      if (f == kFunctionCount) return misused("no such function: ", name);
      problem->function = &kFunctions[f];
      continue;
    }
    if (i + 1 == count) return misused("an option without its value, or unknown: ", name);
    if (!parseNumber(arguments[++i], &value)) return misused("not a number: ", arguments[i]);
    if (strcmp(name, "--absolute") == 0) {
      options->absoluteError = value;
    } else if (strcmp(name, "--relative") == 0) {
      options->relativeError = value;
    } else if (value != floor(value) || value > 1e15) {
      return misused("not a whole number up to 1e15: ", arguments[i]);
    } else if (strcmp(name, "--dimensions") == 0) {
      problem->dimensions = value > 1e9 ? 1000000000u : (uint32_t)value;
    } else if (strcmp(name, "--evaluations") == 0) {
      options->evaluations = (uint64_t)value;
    } else if (strcmp(name, "--seed") == 0) {
      options->seed = (uint64_t)value;
    } else {
      return misused("no such option: ", name);
    }
  }
  return problem->function ? 0 : misused("say which function", "");
}

static void print(const Problem* problem, const IntegrateResult* result) {
  uint32_t a;
  printf("value        %.12g\n", result->value);
  printf("error        %.3g\n", result->error);
  printf("evaluations  %llu, %llu of them not finite\n", (unsigned long long)result->evaluations,
         (unsigned long long)result->nonFinite);
  printf("passes       %u in %u rounds\n", result->passes, result->rounds);
  printf("sampling     levels");
  for (a = 0; a < problem->dimensions; ++a) printf(" %u", result->levels[a]);
  printf(", %llu strata, %llu cells\n", (unsigned long long)result->strata,
         (unsigned long long)result->cells);
}

static int run(Problem* problem, IntegrateOptions* options) {
  static const double lower[AWD_MAX_DIMENSIONS] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  static const double upper[AWD_MAX_DIMENSIONS] = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  AWDDevice device = NULL;
  IntegrateResult result;
  IntegrateStatus status;
  if (awdNewDevice(NULL, &device) != AWD_SUCCESS) {
    fprintf(stderr, "awd-integrate: %s\n", awdGetLastErrorMessage());
    return 1;
  }
  signal(SIGINT, onInterrupt);
  options->progress = goOn;
  status =
      integrate(device, evaluate, problem, problem->dimensions, lower, upper, options, &result);
  awdReleaseDevice(device);
  if (status < 0) {
    fprintf(stderr, "awd-integrate: %s\n", result.message);
    return status == INTEGRATE_INVALID ? 2 : 1;
  }
  if (result.rounds > 0) print(problem, &result);
  if (status == INTEGRATE_CANCELLED) {
    fprintf(stderr, "awd-integrate: interrupted\n");
    return 130;
  }
  if (status == INTEGRATE_NOT_MET) {
    fprintf(stderr, "awd-integrate: the budget is spent, the goal isn't met\n");
    return 1;
  }
  return 0;
}

int main(int count, char** arguments) {
  Problem problem = {NULL, 2};
  IntegrateOptions options = INTEGRATE_OPTIONS_INIT;
  int i, code;
  for (i = 1; i < count; ++i) {
    if (strcmp(arguments[i], "--help") == 0) {
      printUsage(stdout);
      return 0;
    }
  }
  code = parse(count, arguments, &problem, &options);
  if (code == 0) code = run(&problem, &options);
  if (fflush(stdout) != 0 || ferror(stdout)) {
    fprintf(stderr, "awd-integrate: can't write to standard output\n");
    if (code == 0) code = 1;
  }
  return code;
}
