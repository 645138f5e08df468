/**
 * The air that simulated aircraft fly in: standard atmosphere, steady wind and gusts. Aircraft
 * dynamics do not belong here.
 */
package org.u2sa.sim.atmosphere;
