/**
 * The worlds of BARN (Benchmark Autonomous Robot Navigation) for the simulated rover: reading,
 * conversion, driving and scoring as in the challenge. The rover is run by ordinary services,
 * configured in config/ugv.
 */
package org.u2sa.scenarios.barn;
