/**
 * Integration of equations of motion over time. The equations belong to the packages of the
 * vehicles.
 */
package org.u2sa.sim.motion;
