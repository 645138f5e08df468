/**
 * Lane lines: joins pieces of painted lines that a camera saw into lines, closes their gaps, and
 * keeps the vehicle's own lane apart from others.
 */
package org.u2sa.vision.lane;
