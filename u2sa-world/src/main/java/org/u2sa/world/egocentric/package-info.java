/** Objects remembered relative to the vehicle, without its state. */
package org.u2sa.world.egocentric;
