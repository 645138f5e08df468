/**
 * One page a run, or for several side by side, made of recordings: map, charts, events, tables. The
 * page needs no network. How a recording is made and read is the recorder's.
 */
package org.u2sa.gcs.report;
