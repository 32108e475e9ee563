// Under which sanitizers this is compiled, for GCC and clang alike.
//
// LOBER_THREAD_SANITIZER, LOBER_ADDRESS_SANITIZER: 1 or 0. Code asks these and nothing else.
#pragma once

#ifdef __has_feature
#define LOBER_HAS_FEATURE(feature) __has_feature(feature)
#else
#define LOBER_HAS_FEATURE(feature) 0
#endif

#if defined(__SANITIZE_THREAD__) || LOBER_HAS_FEATURE(thread_sanitizer)
#define LOBER_THREAD_SANITIZER 1
#else
#define LOBER_THREAD_SANITIZER 0
#endif

#if defined(__SANITIZE_ADDRESS__) || LOBER_HAS_FEATURE(address_sanitizer)
#define LOBER_ADDRESS_SANITIZER 1
#else
#define LOBER_ADDRESS_SANITIZER 0
#endif
