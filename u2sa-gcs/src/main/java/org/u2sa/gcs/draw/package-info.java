/**
 * Drawing once for two kinds of file: a small canvas with an SVG and a PNG behind it, and the
 * helpers of any chart (ticks, colours, placing of labels). What is drawn, tracks and missions,
 * does not belong here.
 */
package org.u2sa.gcs.draw;
