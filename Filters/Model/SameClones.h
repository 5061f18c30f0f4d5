#ifndef galaxy_SameClones_h
#define galaxy_SameClones_h

/// Compiles a function for machines with AVX2 too, but without its fused multiply-add, which rounds
/// differently: every machine gets the same numbers.
#if defined(__x86_64__)
#define GALAXY_SAME_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define GALAXY_SAME_CLONES
#endif

#endif
