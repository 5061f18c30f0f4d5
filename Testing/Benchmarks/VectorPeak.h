#ifndef galaxy_VectorPeak_h
#define galaxy_VectorPeak_h

/// Single-precision operations a second of all threads together, with the best instruction set that
/// drawing uses: multiply-adds that wait for nothing.
double vectorPeak();

#endif
