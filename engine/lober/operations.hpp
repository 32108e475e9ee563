// The operations of the engine, described once: each with its inputs, its options and the parts of its result.
//
// The program, the batch, the C interface and the Python module follow from this table: to parse, check, print, store
// and document, they walk over it. C++ programs call the functions of the other headers, which an operation calls.
#pragma once

#include "lober/operations/operation.hpp"
#include "lober/operations/values.hpp"
