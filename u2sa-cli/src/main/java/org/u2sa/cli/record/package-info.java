/**
 * Commands for recordings: making, recovering and playing them. The recorder and the file format
 * belong to u2sa-recorder.
 */
package org.u2sa.cli.record;
