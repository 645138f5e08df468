/**
 * Vehicle files: a simulated vehicle's body, dynamics and devices in XML (docs/vehicle-files.md).
 * The physics and the devices themselves have their own packages.
 */
package org.u2sa.sim.file;
