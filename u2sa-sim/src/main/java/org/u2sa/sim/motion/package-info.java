/** Numerical integration of equations of motion. The equations belong to the vehicle packages. */
package org.u2sa.sim.motion;
