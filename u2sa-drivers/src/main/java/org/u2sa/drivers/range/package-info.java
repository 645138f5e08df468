/**
 * Range finders: single beams and scanning lasers, and what they say. What becomes of a distance or
 * a scan belongs to {@code org.u2sa.device}.
 */
package org.u2sa.drivers.range;
