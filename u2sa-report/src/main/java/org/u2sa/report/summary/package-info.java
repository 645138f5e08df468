/**
 * The files of a finished run, or of several: summary, track, picture. Their content comes from
 * sibling packages.
 */
package org.u2sa.report.summary;
