/* A shared library that is not a system. */
int lober_nothing_here = 1;
