/** Systems with one degree of freedom (thesis 1.2): elevators, carriages on rails. */
package org.u2sa.sim.guide;
