// The colours of all pictures and pages. Each has one meaning, in whichever picture it appears; lober.plot of Python
// has the same ones. They are those of Okabe & Ito (Color Universal Design, 2008), which people with any colour vision
// can tell apart, and keep apart in grey.
#pragma once

#include <array>

namespace lober::palette {

inline constexpr const char* ink = "#222222";       ///< axes, texts, dots
inline constexpr const char* grid = "#d9d9d9";      ///< lines that help to read
inline constexpr const char* unstable = "#d55e00";  ///< U, and tubes of what enters
inline constexpr const char* stable = "#0072b2";    ///< S, and tubes of what leaves
inline constexpr const char* boundary = "#b3b3b3";  ///< a wide band below the manifolds

inline constexpr const char* leaving = "#e69f00";   ///< lobes L12, and the fluid that they carry
inline constexpr const char* entering = "#009e73";  ///< lobes L21
inline constexpr const char* common = "#7b2d8b";    ///< overlap: what leaving and entering lobes have in common
// Lobes of which nobody knows whether they leave or enter.
inline constexpr const char* left_of_unstable = "#f0e442";
inline constexpr const char* right_of_unstable = "#56b4e9";

inline constexpr const char* curve1 = stable;    ///< C1 of two closed curves
inline constexpr const char* curve2 = unstable;  ///< C2
inline constexpr const char* shared = ink;       ///< arcs of both

// Lines over n, or over a parameter.
inline constexpr const char* flux = "#cc79a7";   ///< a(n)
inline constexpr const char* total = ink;        ///< T(n)
inline constexpr const char* action = stable;    ///< by action
inline constexpr const char* estimate = common;  ///< to first order

/// Heat maps, from few to much: viridis, by five of its colours (red, green, blue), which are mixed between them.
inline constexpr std::array<std::array<int, 3>, 5> heat{
    {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};

}  // namespace lober::palette
