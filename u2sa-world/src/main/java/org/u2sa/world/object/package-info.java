/** Object map: matches detections with objects and tracks those that move. */
package org.u2sa.world.object;
