/**
 * RoboBoat's dart gun: its control, and its simulation for the judge. The task that fires it is in
 * the package above.
 */
package org.u2sa.scenarios.roboboat.gun;
