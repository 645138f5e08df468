/**
 * Control of any vehicle by cascades from position via velocity to force, and from attitude via
 * rate to moment, with allocation to the announced actuators. Laws for one kind of vehicle belong
 * to their own packages.
 */
package org.u2sa.control.cascade;
