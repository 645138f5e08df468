/**
 * What a fuzzer calls, one class a kind of input, and the replay of all that fuzzers found worth
 * keeping (docs/testing.md). Nothing here knows the fuzzer: a target takes bytes and throws.
 */
package org.u2sa.fuzz;
