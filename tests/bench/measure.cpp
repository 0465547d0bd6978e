// SPDX-License-Identifier: Apache-2.0
#include "measure.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <random>
#include <thread>

namespace bench {
namespace {

constexpr int kResamples = 2000;

/// Squares of the true and of the reported error.
struct Squares {
  double truth, reported;
};

double ratioOf(double reported, double truth) {
  return truth > 0.0 ? std::sqrt(reported / truth) : std::numeric_limits<double>::quiet_NaN();
}

/// The middle 95 % of the ratio over samples drawn with replacement from the repetitions.
void bootstrap(const std::vector<Squares>& squares, Figures& figures) {
  std::mt19937_64 random(squares.size());
  std::vector<double> ratios;
  for (int i = 0; i < kResamples; ++i) {
    double truth = 0.0, reported = 0.0;
    for (std::size_t k = 0; k < squares.size(); ++k) {
      const Squares& s = squares[random() % squares.size()];
      truth += s.truth;
      reported += s.reported;
    }
    ratios.push_back(ratioOf(reported, truth));
  }
  std::sort(ratios.begin(), ratios.end());
  figures.low = ratios[kResamples / 40];
  figures.high = ratios[kResamples - 1 - kResamples / 40];
}

Figures measureCell(const Cell& cell) {
  std::vector<double> errors;
  std::vector<Squares> squares;
  double truth = 0.0, reported = 0.0;
  Figures figures;
  for (int r = 0; r < cell.repetitions; ++r) {
    const Run run =
        cell.method->run(*cell.integrand, cell.evaluations, static_cast<uint64_t>(r) + 1);
    const double error = std::fabs(run.value - cell.integrand->integral());
    errors.push_back(error);
    squares.push_back({error * error, run.error * run.error});
    figures.mean += error / cell.repetitions;
    truth += squares.back().truth;
    reported += squares.back().reported;
  }
  figures.rms = std::sqrt(truth / cell.repetitions);
  figures.reported = std::sqrt(reported / cell.repetitions);
  figures.ratio = ratioOf(reported, truth);
  const std::size_t half = errors.size() / 2;
  std::sort(errors.begin(), errors.end());
  figures.median = errors.size() % 2 ? errors[half] : 0.5 * (errors[half - 1] + errors[half]);
  figures.low = figures.high = figures.ratio;
  if (truth > 0.0 && cell.repetitions > 1) bootstrap(squares, figures);
  return figures;
}

}  // namespace

std::vector<Figures> measure(const std::vector<Cell>& cells, unsigned threads) {
  std::vector<Figures> figures(cells.size());
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < cells.size(); i = next++) figures[i] = measureCell(cells[i]);
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      failure = std::current_exception();
      next = cells.size();
    }
  };
  std::vector<std::thread> workers;
  for (unsigned i = 1; i < threads; ++i) workers.emplace_back(work);
  work();
  for (std::thread& worker : workers) worker.join();
  if (failure) std::rethrow_exception(failure);
  return figures;
}

}  // namespace bench
