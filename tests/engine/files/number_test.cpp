// Every literal becomes the double that strtod gives (in the C locale, correctly rounded).
#include "engine/files/number.hpp"

#include <cmath>
#include <cstdlib>
#include <random>

#include "curve_testing.hpp"
#include "engine/files/text_points.hpp"

namespace lober::detail {
namespace {

class Literals {
 public:
  explicit Literals(std::uint64_t seed) : random_(seed) {}

  /// One of the shapes that files contain, and some that they do not.
  std::string next() {
    switch (below(7)) {
      case 0:
        return printed("%.17g", any_double());
      case 1:
        return printed("%.30f", std::ldexp(unit(), static_cast<int>(below(60)) - 30));
      case 2:
        return printed("%.15e", any_double());
      case 3:
        return sign() + digits(1 + below(40)) + "." + digits(below(40));
      case 4:
        return sign() + digits(below(3)) + "." + digits(1 + below(25)) + exponent();
      case 5:
        return sign() + digits(1 + below(20)) + exponent();
      default:
        return halfway();
    }
  }

 private:
  std::uint64_t below(std::uint64_t limit) { return random_() % limit; }
  double unit() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  std::string sign() { return below(2) == 0 ? "-" : ""; }
  std::string exponent() {
    return std::string(1, "eEdD"[below(4)]) + (below(3) == 0 ? "+" : "") + std::to_string(static_cast<int>(below(330)));
  }
  std::string digits(std::uint64_t count) {
    std::string text;
    for (; count != 0; --count) text += static_cast<char>('0' + below(10));
    return text;
  }
  double any_double() {
    for (;;) {
      const auto value = std::bit_cast<double>(random_());
      if (std::isfinite(value)) return value;
    }
  }
  static std::string printed(const char* format, double value) {
    char buffer[400];
    return {buffer, static_cast<std::size_t>(std::snprintf(buffer, sizeof buffer, format, value))};
  }
  /// The exact middle between two neighbouring doubles, or a digit beside it: the hard case of rounding.
  std::string halfway() {
    const double value = std::ldexp(1 + std::abs(unit()), static_cast<int>(below(80)) - 40);
    const auto middle =
        (static_cast<long double>(value) + static_cast<long double>(std::nextafter(value, 2 * value))) / 2;
    char buffer[400];
    std::string text(buffer, static_cast<std::size_t>(std::snprintf(buffer, sizeof buffer, "%.110Lf", middle)));
    if (below(2) == 0) text += below(2) == 0 ? "1" : "000000000000000001";
    return text;
  }

  std::mt19937_64 random_;
};

TEST(Number, AgreesWithStrtodOnAMillionLiterals) {
  Literals literals(20240611);
  for (int i = 0; i < 1000000; ++i) {
    const std::string literal = literals.next();
    std::string with_e = literal;
    if (const std::size_t mark = with_e.find_first_of("dD"); mark != std::string::npos) with_e[mark] = 'e';
    const double expected = std::strtod(with_e.c_str(), nullptr);
    double value = 42;
    const NumberKind kind = parse_number(literal, value);
    ASSERT_EQ(kind == NumberKind::finite, std::isfinite(expected)) << literal;
    if (kind != NumberKind::finite) continue;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected)) << literal;
    // The fast path of a line has to give the same.
    TextChunk chunk;
    const std::string line = literal + " " + literal + "\n";
    chunk.text = line;
    parse_chunk(chunk);
    ASSERT_EQ(chunk.points.size(), 1U) << literal;
    ASSERT_TRUE(test::same_bits(chunk.points, std::vector<Point>{{expected, expected}})) << literal;
  }
}

TEST(Number, RoundsTheEndsOfTheRangeAsStrtodDoes) {
  for (const char* const literal : {"1e-400",
                                    "-1e-400",
                                    "2e-324",
                                    "-2e-324",
                                    "2.4703282292062327208e-324",
                                    "2.4703282292062327209e-324",
                                    "3e-324",
                                    "4.9e-324",
                                    "1e-320",
                                    "2.2250738585072011e-308",
                                    "2.2250738585072014e-308",
                                    "1.7976931348623157e308",
                                    "1.7976931348623158e308",
                                    "1.7976931348623158079e308",
                                    "0e999999999",
                                    "-0e-999999999",
                                    "0.0",
                                    "-0",
                                    "1e-99999999999999999999999",
                                    "0.00000000000000000000000000000000000000000001e-290",
                                    "10000000000000000000000000000000000e-9223372036854775808"}) {
    double value = 42;
    ASSERT_EQ(parse_number(literal, value), NumberKind::finite) << literal;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(std::strtod(literal, nullptr)))
        << literal;
  }
  for (const char* const literal :
       {"1e999", "-1e999", "1.7976931348623159e308", "1e99999999999999999999999", "0.00001e314", "1000000000e300",
        "inf", "-inf", "nan", "-nan", "infinity", "+inf"}) {
    double value = 42;
    EXPECT_EQ(parse_number(literal, value), NumberKind::not_finite) << literal;
  }
  for (const char* const literal : {"", "+", "-", ".", "e5", "--1", "+-1", "-+1", "++1", "1e", "1e+", "1_000", "0x1p3",
                                    "1 ", " 1", "1,5", "1.2.3", "1d5d6", "none"}) {
    double value = 42;
    EXPECT_EQ(parse_number(literal, value), NumberKind::not_a_number) << literal;
  }
}

}  // namespace
}  // namespace lober::detail
