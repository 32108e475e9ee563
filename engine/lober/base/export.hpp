// The symbols that the shared library exports: functions and classes marked with LOBER_API. Everything else in it is
// hidden.
//
// The macro marks the functions whose code is in the library, and the types whose type information or virtual functions
// both sides need: exceptions and what they hold, classes to derive from. Other types are left out on purpose: their
// inline functions then exist in the library by themselves, compiled with its flags, whatever the flags of its user.
#pragma once

#if defined(__GNUC__)
#define LOBER_API __attribute__((visibility("default")))
#else
#define LOBER_API
#endif
