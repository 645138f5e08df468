/**
 * Aircraft described in the file format of JSBSim (fdm_config 2.0): its function language, mass
 * balance, piston engines with tabulated propellers, control systems and ground contacts. Inside
 * this package quantities are in JSBSim's units: feet, pounds, slugs, radians. The motion itself is
 * that of {@link org.u2sa.sim.flight.UnmannedAircraft}.
 */
package org.u2sa.sim.jsbsim;
