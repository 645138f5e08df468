/** Landing gear of aircraft. */
package org.u2sa.sim.gear;
