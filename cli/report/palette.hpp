// The colours of the pictures of manifolds. Each has one meaning, in whichever picture it appears.
#pragma once

namespace lober::cli::palette {

inline constexpr const char* unstable = "#b3261e";
inline constexpr const char* stable = "#1f5fa8";
inline constexpr const char* boundary = "#e3b94a";

inline constexpr const char* leaving = "#c8701e";   ///< lobes L12, and the fluid that they carry
inline constexpr const char* entering = "#3f8f6b";  ///< lobes L21
inline constexpr const char* common = "#4b1d7a";    ///< what leaving and entering lobes have in common
// Lobes of which nobody knows whether they leave or enter.
inline constexpr const char* left_of_unstable = "#8d7b4f";
inline constexpr const char* right_of_unstable = "#6b7f99";

// Lines over n.
inline constexpr const char* flux = "#8a3d7c";   ///< a(n)
inline constexpr const char* total = "#44505e";  ///< T(n)

}  // namespace lober::cli::palette
