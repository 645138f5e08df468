/**
 * The files of a finished run, or of several: summary, track, picture. What they hold is made by
 * the packages beside this one.
 */
package org.u2sa.report.summary;
