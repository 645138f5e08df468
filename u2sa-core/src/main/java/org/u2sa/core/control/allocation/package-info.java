/**
 * Control allocation: which actuators do how much of a wanted force and moment, by what the
 * actuators announce of themselves (thesis 3.2.3.5, 5.1). Which force and moment are wanted is up
 * to control laws elsewhere.
 */
package org.u2sa.core.control.allocation;
