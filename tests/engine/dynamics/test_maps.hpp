// Maps whose manifolds are known: small, and independent of the systems that the engine brings.
#pragma once

#include <cmath>

#include "lober/dynamics/planar_map.hpp"

namespace lober::test {

/// p' = p + K sin x, x' = x + p', as points (x, p).
class StandardMap : public PlanarMap {
 public:
  explicit StandardMap(double k) : k_(k) {}
  void iterate(std::span<Point> points, int iterates) const override {
    for (Point& point : points) {
      for (int n = 0; n < iterates; ++n) point = forward(point);
      for (int n = 0; n > iterates; --n) point = backward(point);
    }
  }
  Point iterate_with_derivative(Point point, int iterates, Matrix2& derivative) const override {
    derivative = {};
    for (int n = 0; n < iterates; ++n) {
      const double c = k_ * std::cos(point.x);
      derivative = product({1 + c, 1, c, 1}, derivative);
      point = forward(point);
    }
    for (int n = 0; n > iterates; --n) {
      point = backward(point);
      const double c = k_ * std::cos(point.x);
      derivative = product({1, -1, -c, 1 + c}, derivative);
    }
    return point;
  }
  static Matrix2 product(const Matrix2& a, const Matrix2& b) {
    return {a.xx * b.xx + a.xy * b.yx, a.xx * b.xy + a.xy * b.yy, a.yx * b.xx + a.yy * b.yx, a.yx * b.xy + a.yy * b.yy};
  }

 private:
  [[nodiscard]] Point forward(Point z) const {
    const double p = z.y + k_ * std::sin(z.x);
    return {z.x + p, p};
  }
  [[nodiscard]] Point backward(Point z) const {
    const double x = z.x - z.y;
    return {x, z.y - k_ * std::sin(x)};
  }
  double k_;
};

/// (x, y) -> (x^2 - k - y, x).
class HenonMap : public PlanarMap {
 public:
  explicit HenonMap(double k) : k_(k) {}
  void iterate(std::span<Point> points, int iterates) const override {
    for (Point& z : points) {
      for (int n = 0; n < iterates; ++n) z = {z.x * z.x - k_ - z.y, z.x};
      for (int n = 0; n > iterates; --n) z = {z.y, z.y * z.y - k_ - z.x};
      if (!(std::isfinite(z.x) && std::isfinite(z.y))) z = {std::nan(""), std::nan("")};
    }
  }
  Point iterate_with_derivative(Point z, int iterates, Matrix2& derivative) const override {
    derivative = {};
    for (int n = 0; n < iterates; ++n) {
      derivative = StandardMap::product({2 * z.x, -1, 1, 0}, derivative);
      z = {z.x * z.x - k_ - z.y, z.x};
    }
    for (int n = 0; n > iterates; --n) {
      derivative = StandardMap::product({0, 1, -1, 2 * z.y}, derivative);
      z = {z.y, z.y * z.y - k_ - z.x};
    }
    return z;
  }

 private:
  double k_;
};

/// (x, y) -> (1 - a x^2 + y, b x): Henon's own map, which reverses orientation for b > 0.
class DissipativeHenonMap : public PlanarMap {
 public:
  DissipativeHenonMap(double a, double b) : a_(a), b_(b) {}
  void iterate(std::span<Point> points, int iterates) const override {
    for (Point& z : points) {
      for (int n = 0; n < iterates; ++n) z = {1 - a_ * z.x * z.x + z.y, b_ * z.x};
      for (int n = 0; n > iterates; --n) z = {z.y / b_, z.x - 1 + a_ * z.y * z.y / (b_ * b_)};
      if (!(std::isfinite(z.x) && std::isfinite(z.y))) z = {std::nan(""), std::nan("")};
    }
  }
  Point iterate_with_derivative(Point z, int iterates, Matrix2& derivative) const override {
    derivative = {};
    for (int n = 0; n != iterates; n += iterates < 0 ? -1 : 1) {
      const Matrix2 a =
          iterates > 0 ? Matrix2{-2 * a_ * z.x, 1, b_, 0} : Matrix2{0, 1 / b_, 1, 2 * a_ * z.y / (b_ * b_)};
      derivative = StandardMap::product(a, derivative);
      iterate({&z, 1}, iterates > 0 ? 1 : -1);
    }
    return z;
  }

 private:
  double a_, b_;
};

/// (x, y) -> (a x, y / b + x^3): a saddle at the origin with an unstable manifold in closed form.
class CubicSaddle : public PlanarMap {
 public:
  /// `a` may be negative: an inverse saddle.
  CubicSaddle(double a, double b) : a_(a), b_(b) {}
  void iterate(std::span<Point> points, int iterates) const override {
    for (Point& z : points) {
      for (int n = 0; n < iterates; ++n) z = {a_ * z.x, z.y / b_ + z.x * z.x * z.x};
      for (int n = 0; n > iterates; --n) {
        const double x = z.x / a_;
        z = {x, b_ * (z.y - x * x * x)};
      }
    }
  }
  Point iterate_with_derivative(Point z, int iterates, Matrix2& derivative) const override {
    derivative = {};
    for (int n = 0; n < iterates; ++n) {
      derivative = StandardMap::product({a_, 0, 3 * z.x * z.x, 1 / b_}, derivative);
      z = {a_ * z.x, z.y / b_ + z.x * z.x * z.x};
    }
    for (int n = 0; n > iterates; --n) {
      const double x = z.x / a_;
      derivative = StandardMap::product({1 / a_, 0, -3 * b_ * x * x / a_, b_}, derivative);
      z = {x, b_ * (z.y - x * x * x)};
    }
    return z;
  }
  /// y on the unstable manifold, c x^3 with c (a^3 - 1 / b) = 1.
  [[nodiscard]] double unstable(double x) const { return x * x * x / (a_ * a_ * a_ - 1 / b_); }

 private:
  double a_, b_;
};

}  // namespace lober::test
