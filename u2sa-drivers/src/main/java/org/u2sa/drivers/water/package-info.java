/**
 * Velocity logs: speed over the bottom and through the water. Depths and ranges belong to {@code
 * org.u2sa.drivers.range} and {@code org.u2sa.drivers.sonar}.
 */
package org.u2sa.drivers.water;
