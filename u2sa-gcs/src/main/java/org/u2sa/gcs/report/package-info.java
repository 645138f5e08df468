/**
 * Self-contained report pages on one recorded run or several side by side: map, charts, events,
 * tables. Recordings are made and read by the recorder module.
 */
package org.u2sa.gcs.report;
