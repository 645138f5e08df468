/**
 * Content of a page about recorded runs: map, charts, timeline, latency. How a page is written is
 * in {@code report.page}.
 */
package org.u2sa.report.run;
