release = version();
print("VERSION ", release[1], ".", release[2], ".", release[3]);
