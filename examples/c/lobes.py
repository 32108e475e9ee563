"""The same from Python without a module, by ctypes: python3 lobes.py LIBLOBER"""
import ctypes as c
import sys

import numpy as np


class Array(c.Structure):
    _fields_ = [("name", c.c_char_p), ("type", c.c_int), ("data", c.c_void_p), ("rows", c.c_size_t), ("columns", c.c_size_t)]


lober = c.CDLL(sys.argv[1] if len(sys.argv) > 1 else "liblober.so")
lober.lober_message.restype = c.c_char_p
lober.lober_number.restype = c.c_double


def call(function, *arguments):
    """The function's result, a handle."""
    result = c.c_void_p()
    if function(*arguments, c.byref(result)) != 0:
        raise RuntimeError(lober.lober_message().decode())
    return result


def doubles(result, name):
    """A copy of an array."""
    array = Array()
    if lober.lober_array_named(result, name.encode(), c.byref(array)) != 0:
        raise RuntimeError(lober.lober_message().decode())
    data = c.cast(array.data, c.POINTER(c.c_double))
    return np.ctypeslib.as_array(data, (array.rows, array.columns)).copy()


def points(x, y):
    """A curve and its number of points, as the library takes them."""
    curve = np.ascontiguousarray(np.column_stack([x, y]))
    return curve, c.c_void_p(curve.ctypes.data), c.c_size_t(len(curve))


n = 1000
angle = 2 * np.pi * np.arange(n) / n
radius = 1 + 0.2 * np.sin(5 * angle)
circle = points(np.cos(angle), np.sin(angle))
wave = points(radius * np.cos(angle), radius * np.sin(angle))
result = call(lober.lober_overlay, *circle[1:], *wave[1:], None)
total = lober.lober_number(result, b"areas.c1_minus_c2")
print(f"{len(doubles(result, 'pieces.c1_minus_c2.area'))} lobes of area {total:.12f} in all")
lober.lober_result_free(result)

model = call(lober.lober_model_open, b"standard", b"K=1.2", None)
result = call(lober.lober_transport, model, b"iterates=3")
print(f"flux {doubles(result, 'turnstile.flux12')[0, 0]:.9f}")
lober.lober_result_free(result)
lober.lober_model_free(model)

circles = 5
row = np.concatenate([circle[0] + [0.6 * k, 0] for k in range(circles)])
begin = (c.c_size_t * (circles + 1))(*range(0, n * circles + 1, n))
result = call(
    lober.lober_overlap_matrix, c.c_void_p(row.ctypes.data), begin, c.c_size_t(circles), None, None, c.c_size_t(0),
    b"what=intersection,crossings dense=1",
)
for area, crossings in zip(doubles(result, "intersection")[0, 1:], doubles(result, "crossings")[0, 1:]):
    print(f"{area:.9f} {crossings:.0f}")
lober.lober_result_free(result)
