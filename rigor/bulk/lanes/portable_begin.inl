// The counterpart of avx2_begin.inl for any processor. Functions of lanes that follow are inlined where the
// compiler likes to: forced into each other, as AVX2 has them, the portable ones are ten times as long, and a
// compiler with sanitizers takes six times as long for them.

#define RIGOR_LANES_HAVE_FMA 0
#undef RIGOR_FLOAT_LANES
#define RIGOR_FLOAT_LANES inline
