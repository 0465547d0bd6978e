// SPDX-License-Identifier: Apache-2.0
// Fractions and polynomials of fractions, for formulas that are to be checked without rounding.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <ostream>
#include <vector>

namespace awd {

class Rational {
 public:
  Rational(int64_t numerator = 0, int64_t denominator = 1) {  // NOLINT: 3 is a fraction too
    const int64_t divisor = std::gcd(numerator, denominator) * (denominator < 0 ? -1 : 1);
    if (divisor == 0) std::abort();
    numerator_ = numerator / divisor;
    denominator_ = denominator / divisor;
  }

  double value() const {
    return static_cast<double>(numerator_) / static_cast<double>(denominator_);
  }
  bool operator==(const Rational& o) const {
    return numerator_ == o.numerator_ && denominator_ == o.denominator_;
  }
  Rational operator+(const Rational& o) const {
    return {sum(product(numerator_, o.denominator_), product(o.numerator_, denominator_)),
            product(denominator_, o.denominator_)};
  }
  Rational operator-(const Rational& o) const { return *this + Rational(-1) * o; }
  Rational operator*(const Rational& o) const {
    const Rational a(numerator_, o.denominator_), b(o.numerator_, denominator_);
    Rational result;
    result.numerator_ = product(a.numerator_, b.numerator_);
    result.denominator_ = product(a.denominator_, b.denominator_);
    return result;
  }
  Rational operator/(const Rational& o) const {
    return *this * Rational(o.denominator_, o.numerator_);
  }

 private:
  // What does not fit ends the test.
  static int64_t product(int64_t a, int64_t b) {
    int64_t result;
    if (__builtin_mul_overflow(a, b, &result)) std::abort();
    return result;
  }
  static int64_t sum(int64_t a, int64_t b) {
    int64_t result;
    if (__builtin_add_overflow(a, b, &result)) std::abort();
    return result;
  }

  int64_t numerator_, denominator_;
};

inline void PrintTo(const Rational& r, std::ostream* out) { *out << r.value(); }

/// Coefficients of 1, t, t^2, ..
using Polynomial = std::vector<Rational>;

inline Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  Polynomial sum(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < a.size(); ++i) sum[i] = sum[i] + a[i];
  for (std::size_t i = 0; i < b.size(); ++i) sum[i] = sum[i] + b[i];
  return sum;
}

inline Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial product(a.size() + b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) product[i + k] = product[i + k] + a[i] * b[k];
  }
  while (!product.empty() && product.back() == Rational(0)) product.pop_back();
  return product;
}

inline Rational valueAt(const Polynomial& p, const Rational& t) {
  Rational value;
  for (std::size_t i = p.size(); i-- > 0;) value = value * t + p[i];
  return value;
}

inline Rational integralTo(const Polynomial& p, const Rational& t) {
  Polynomial integral = {0};
  for (std::size_t i = 0; i < p.size(); ++i) {
    integral.push_back(p[i] / Rational(static_cast<int64_t>(i) + 1));
  }
  return valueAt(integral, t);
}

}  // namespace awd
