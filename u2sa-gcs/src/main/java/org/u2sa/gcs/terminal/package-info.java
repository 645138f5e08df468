/**
 * What people see of a run on a terminal: the live status, the table of waypoints. What programs
 * read (JSON, CSV) and pictures are not here.
 */
package org.u2sa.gcs.terminal;
