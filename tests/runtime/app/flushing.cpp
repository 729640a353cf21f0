// A library such as -ffast-math links: when it is loaded, subnormal numbers are flushed in the whole process.
#if defined(__SSE2__)
__attribute__((constructor)) static void flush() {
  __builtin_ia32_ldmxcsr(0x9fc0);
}
#endif
