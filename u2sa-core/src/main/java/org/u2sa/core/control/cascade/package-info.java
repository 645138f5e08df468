/**
 * Control of any vehicle by cascades from position over velocity to force, and from attitude over
 * rate to moment, with allocation to whatever actuators announced themselves. Laws of one kind of
 * vehicle belong to packages of their own.
 */
package org.u2sa.core.control.cascade;
