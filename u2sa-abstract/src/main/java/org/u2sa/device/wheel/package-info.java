/** Wheels of ground vehicles: geometry and odometry. */
package org.u2sa.device.wheel;
