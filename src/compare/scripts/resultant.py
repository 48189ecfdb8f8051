# The resultant with respect to z, for 20 ms at least.
import time
from sympy import Poly, Rational, symbols

x, y, z = symbols("x y z")
first = Poly(FIRST, z, x, y)
second = Poly(SECOND, z, x, y)
runs = 0
start = time.perf_counter()
while runs == 0 or time.perf_counter() - start < 0.02:
    answer = first.resultant(second)
    runs += 1
print("TIME", 1000 * (time.perf_counter() - start), runs)
for (i, j), coefficient in answer.terms():
    print(f"+ ({coefficient})*x**{i}*y**{j}")
