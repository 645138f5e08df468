/**
 * The air that simulated aircraft fly in: standard atmosphere, steady wind and gusts. What an
 * aircraft does in that air does not belong here.
 */
package org.u2sa.sim.atmosphere;
