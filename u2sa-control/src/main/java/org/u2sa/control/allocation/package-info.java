/**
 * Control allocation: distributes a wanted force and moment over the announced actuators (thesis
 * 3.2.3.5, 5.1). Control laws elsewhere compute the wanted force and moment.
 */
package org.u2sa.control.allocation;
