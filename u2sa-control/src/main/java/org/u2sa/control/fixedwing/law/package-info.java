/**
 * Control laws of a fixed-wing aircraft: attitude and rate loops, total energy, flare, steering on
 * the ground.
 */
package org.u2sa.control.fixedwing.law;
