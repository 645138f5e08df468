/**
 * Mosaics: one map-projected picture of the images of a survey (thesis 4.4.1.3). How images are
 * taken and which ground they show belongs to u2sa-vision.
 */
package org.u2sa.report.mosaic;
