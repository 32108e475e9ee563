# One line of "nanoseconds-a-point coordinate coordinate ..." for each tolerance, by SciPy's DOP853, one point at a time.
# usage: solve_ivp.py SYSTEM SPAN POINTS TOLERANCE...    (POINTS: a file with the coordinates of a point in each line)
import math
import sys
import time

import numpy
import scipy.integrate
import scipy.special


def vortex_pair(gamma=0.5, eps=0.1):
    terms = range(1, 13)
    coefficients = numpy.array([scipy.special.iv(k, eps) / (k * scipy.special.iv(0, eps)) for k in terms])
    numbers = numpy.arange(1, 13)
    speed = 0.5 * math.exp(eps) / scipy.special.iv(0, eps)

    def velocity(t, state):
        x, y = state
        sine, cosine = math.sin(t / gamma), math.cos(t / gamma)
        yv = math.exp(eps * (cosine - 1))
        across = x + gamma / yv * float(coefficients @ numpy.sin(numbers * (t / gamma)))
        strain = eps / gamma * sine
        near = 1 / (across * across + (y - yv) ** 2)
        far = 1 / (across * across + (y + yv) ** 2)
        return ((y + yv) * far - (y - yv) * near - speed + strain * x, across * (near - far) - strain * y)

    return velocity


def duffing(t, state):
    x, y = state
    return (y, x - x * x * x + 0.1 * math.cos(t))


def capsize(t, state, r2=1.6 * 1.6):
    x, y, vx, vy = state
    return (vx, vy, x * (2 * y - 1), r2 * (0.5 * x * x - y))


def three_body(t, state, mu=9.537e-4):
    x, y, px, py = state
    a, b = x + mu, x - (1 - mu)
    r1, r2 = a * a + y * y, b * b + y * y
    pull1, pull2 = (1 - mu) / (r1 * math.sqrt(r1)), mu / (r2 * math.sqrt(r2))
    return (px + y, py - x, py - a * pull1 - b * pull2, -px - y * (pull1 + pull2))


def main(system, span, file, *tolerances):
    velocity = {"ovp": vortex_pair(), "duffing": duffing, "capsize": capsize, "pcr3bp": three_body}[system]
    points = numpy.loadtxt(file)
    for tolerance in map(float, tolerances):
        before = time.perf_counter()
        ends = [
            scipy.integrate.solve_ivp(velocity, (0, float(span)), point, "DOP853", rtol=tolerance, atol=tolerance).y[:, -1]
            for point in points
        ]
        each = 1e9 * (time.perf_counter() - before) / len(points)
        print(each, *("%.17g" % coordinate for end in ends for coordinate in end))


main(*sys.argv[1:])
