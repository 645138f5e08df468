/**
 * Content of a page about recorded runs: map, charts, timeline, latency. Pages are written by
 * {@code report.page}.
 */
package org.u2sa.report.run;
