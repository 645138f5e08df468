/**
 * Detects objects of surface and underwater courses in colour and thermal images, only those that
 * the current goals need. Ground courses are in {@code vision.camera}.
 */
package org.u2sa.vision.marine;
