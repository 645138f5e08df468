/** Objects located by the directions in which they are perceived. Not here: sensors. */
package org.u2sa.world.bearing;
