\\ The resultant with respect to z, for 20 ms at least; one thread, as everyone.
default(nbthreads, 1);
default(parisizemax, 4*10^9);
first = FIRST;
second = SECOND;
runs = 0;
start = getwalltime();
until(getwalltime() - start >= 20, answer = polresultant(first, second, z); runs++);
print("TIME ", getwalltime() - start, " ", runs);
print(answer);
