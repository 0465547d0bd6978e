// SPDX-License-Identifier: Apache-2.0
// Plain Monte Carlo, MISER and VEGAS of the GNU Scientific Library.
#include "methods.h"

#ifdef AWD_BENCH_GSL
#include <gsl/gsl_monte_miser.h>
#include <gsl/gsl_monte_plain.h>
#include <gsl/gsl_monte_vegas.h>
#include <gsl/gsl_rng.h>

#include <memory>
#include <stdexcept>

namespace bench {
namespace {

constexpr int kVegasIterations = 5;

/// An integrand over the unit cube with random numbers, as GSL takes them.
class Problem {
 public:
  Problem(const Integrand& f, uint64_t seed)
      : random_(gsl_rng_alloc(gsl_rng_mt19937), gsl_rng_free) {
    function_.f = [](double* x, size_t, void* user) {
      return (*static_cast<const Integrand*>(user))(x);
    };
    function_.dim = static_cast<size_t>(f.dimensions());
    function_.params = const_cast<Integrand*>(&f);
    gsl_rng_set(random_.get(), static_cast<unsigned long>(seed));
  }

  std::size_t dimensions() const { return function_.dim; }

  template <class Integrate, class State>
  Run run(Integrate&& integrate, std::size_t evaluations, State* state) {
    double lower[kMostDimensions] = {}, upper[kMostDimensions] = {1, 1, 1, 1, 1, 1};
    Run run;
    if (integrate(&function_, lower, upper, function_.dim, evaluations, random_.get(), state,
                  &run.value, &run.error) != 0) {
      throw std::runtime_error("GSL failed");
    }
    return run;
  }

 private:
  gsl_monte_function function_{};
  std::unique_ptr<gsl_rng, decltype(&gsl_rng_free)> random_;
};

template <class State>
using Owner = std::unique_ptr<State, void (*)(State*)>;

Run plain(const Integrand& f, uint64_t evaluations, uint64_t seed) {
  Problem problem(f, seed);
  const Owner<gsl_monte_plain_state> state(gsl_monte_plain_alloc(problem.dimensions()),
                                           gsl_monte_plain_free);
  return problem.run(gsl_monte_plain_integrate, evaluations, state.get());
}

Run miser(const Integrand& f, uint64_t evaluations, uint64_t seed) {
  Problem problem(f, seed);
  const Owner<gsl_monte_miser_state> state(gsl_monte_miser_alloc(problem.dimensions()),
                                           gsl_monte_miser_free);
  return problem.run(gsl_monte_miser_integrate, evaluations, state.get());
}

/// Five iterations of N/5, combined as VEGAS does.
Run vegasEqual(const Integrand& f, uint64_t evaluations, uint64_t seed) {
  Problem problem(f, seed);
  const Owner<gsl_monte_vegas_state> state(gsl_monte_vegas_alloc(problem.dimensions()),
                                           gsl_monte_vegas_free);
  return problem.run(gsl_monte_vegas_integrate, evaluations / kVegasIterations, state.get());
}

/// Five iterations on a fifth of the budget for the grid alone, then one of the rest.
Run vegasWarm(const Integrand& f, uint64_t evaluations, uint64_t seed) {
  Problem problem(f, seed);
  const Owner<gsl_monte_vegas_state> state(gsl_monte_vegas_alloc(problem.dimensions()),
                                           gsl_monte_vegas_free);
  const std::size_t warm = evaluations / 5;
  problem.run(gsl_monte_vegas_integrate, warm / kVegasIterations, state.get());
  gsl_monte_vegas_params parameters;
  gsl_monte_vegas_params_get(state.get(), &parameters);
  parameters.stage = 1;  // keep the grid, forget the results
  parameters.iterations = 1;
  gsl_monte_vegas_params_set(state.get(), &parameters);
  return problem.run(gsl_monte_vegas_integrate, evaluations - warm, state.get());
}

}  // namespace

std::vector<Method> gslMethods() {
  return {{kVegas[0], true, vegasEqual},
          {kVegas[1], true, vegasWarm},
          {"plain", true, plain},
          {"miser", true, miser}};
}

}  // namespace bench
#else
namespace bench {
std::vector<Method> gslMethods() { return {}; }
}  // namespace bench
#endif
