// Transport between regions of phase space: fluxes of one system and of many, Melnikov's method, escape from a well.
#pragma once

#include "lober/transport/escape.hpp"
#include "lober/transport/melnikov.hpp"
#include "lober/transport/monte_carlo.hpp"
#include "lober/transport/sweep.hpp"
#include "lober/transport/transport.hpp"
