import sympy

print("VERSION", sympy.__version__)
